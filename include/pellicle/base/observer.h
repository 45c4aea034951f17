// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace pellicle
{
/** What one accepted Newton iteration reports. */
struct IterationReport
{
  int step                 = 0;
  int iteration            = 0;
  double relative_residual = 0.;
  double step_length       = 0.;
  double energy            = 0.; ///< in the user's units
  int rejected             = 0;  ///< trials rejected before this one
  double seconds           = 0.;
};

/** What one finished load or time step reports. */
struct StepReport
{
  int step             = 0;
  double fraction_done = 1.; ///< of the whole run, for the estimate of the time left
  /** What load stepping has changed and where it stands: "load" of a scene's own load path, a parameter. */
  std::vector<std::pair<std::string, double>> stepped;
  int iterations = 0;
  std::vector<std::pair<std::string, double>> quantities; ///< name, value in the user's units
};

/** A row of a table that an analysis writes, `<table>.csv`. */
struct TableRow
{
  std::string table;
  std::vector<std::pair<std::string, std::string>> fields; ///< column, text
};

/** Watches a run. Solvers call it; files and the terminal implement it. */
class Observer
{
public:
  virtual ~Observer() = default;
  virtual void on_iteration(const IterationReport & /*report*/) {}
  virtual void on_step(const StepReport & /*report*/) {}
  virtual void on_row(const TableRow & /*row*/) {}
  virtual void on_message(const std::string & /*text*/) {}
};
} // namespace pellicle

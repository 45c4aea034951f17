// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/observer.h>
#include <pellicle/output/tables.h>

#include <filesystem>
#include <map>
#include <set>
#include <string>

namespace pellicle
{
/**
 * Makes the output directory ready for a new run: creates it if missing and removes the result files that an earlier
 * run left in it (summary, tables, solutions, picture, checkpoints, and what was unfinished when it was killed; nothing
 * else), so that a run that is killed cannot be mistaken for a finished one. Throws WriteError with path and reason.
 */
void prepare_output_directory(const std::filesystem::path &directory);

/** The same for a run that goes on there: solutions and checkpoints stay. */
void prepare_continued_directory(const std::filesystem::path &directory);

/** Removes files of solutions, of surfaces and bodies, other than those to keep. */
void remove_solutions(const std::filesystem::path &directory, const std::set<std::string> &keep);

/** Keeps `history.csv` and `convergence.csv` of a run, which start empty, and the tables of analyses, which start with
 * their first row. Under MPI only rank 0 constructs one. */
class RunFiles : public Observer
{
public:
  /** The directory stands. Throws UserError when it cannot be written. */
  explicit RunFiles(const std::filesystem::path &directory);

  void on_iteration(const IterationReport &report) override;
  void on_step(const StepReport &report) override;
  void on_row(const TableRow &row) override;

  /** All tables; those that are read take the place of what is in the files. */
  void exchange(Archive &archive);

private:
  std::filesystem::path directory;
  GrowingTable history;
  ConvergenceTable convergence;
  std::map<std::string, GrowingTable> tables;
};
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/observer.h>

#include <functional>
#include <iosfwd>
#include <ostream>
#include <string>

namespace pellicle
{
/** How much a run says in the terminal. */
enum class Verbosity
{
  quiet,  ///< nothing
  normal, ///< one line a step
  verbose ///< one line a Newton iteration as well
};

/** True if standard output is a terminal and not a file or a pipe. */
bool standard_output_is_terminal();

/** A duration for people: "0.4 s", "47 s", "3 min 20 s", "2 h 5 min". */
std::string duration_text(double seconds);

/**
 * Reports a run as it goes. In a terminal a `normal` run has one line for the step in work, rewritten at every
 * iteration, with the time left estimated from the fraction done; a finished step's line stays. Elsewhere (files,
 * pipes) it writes finished lines only. Under MPI only rank 0 constructs one.
 */
class Progress : public Observer
{
public:
  using Clock = std::function<double()>; ///< seconds since some fixed moment

  /** `out` must outlive this object. An empty clock means the steady clock of the system. */
  Progress(std::ostream &out, Verbosity verbosity, bool in_terminal, Clock clock = {});
  /** Ends a line that is still being rewritten. */
  ~Progress() override;
  Progress(const Progress &)            = delete;
  Progress &operator=(const Progress &) = delete;

  void on_iteration(const IterationReport &report) override;
  void on_step(const StepReport &report) override;
  void on_message(const std::string &text) override;

private:
  double elapsed() const;
  /** "12 s", in a terminal with ", about 30 s left" once a part of the run is done. */
  std::string time_text() const;
  /** Overwrites the line in work. */
  void rewrite(const std::string &line);
  /** Writes a line that stays, in place of the line in work. */
  void write(const std::string &line);

  std::ostream &out;
  const Verbosity verbosity;
  const bool in_terminal;
  const Clock clock;
  const double start;
  double fraction_done = 0.;
  std::size_t n_shown  = 0; ///< characters of the line in work
};
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace pellicle
{
/** How a program that run_program() started came to its end. */
struct ProgramEnd
{
  bool started    = false;
  bool timed_out  = false; ///< it was stopped because its time was over
  int exit_status = -1;    ///< of a program that ended by itself
  std::string output;      ///< what it wrote to its standard output and standard error
};

/**
 * Runs a program (no shell) and waits for it. After `timeout_seconds` it and all programs it started are ended. The
 * program may not inherit an MPI job: variables of the MPI launcher are taken out of its environment.
 */
ProgramEnd run_program(const std::vector<std::string> &command, double timeout_seconds);
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/output/progress.h>

#include <string>
#include <variant>
#include <vector>

namespace pellicle
{
/** What the command line of an application asks for. */
struct CommandLine
{
  std::string scene_file;             ///< empty only with write_parameters_file or restart_directory
  std::string write_parameters_file;  ///< empty: do not write parameters
  bool validate = false;              ///< read and build, do not solve
  std::vector<std::string> overrides; ///< arguments of --set, "Section/Name=value", in their order
  std::string output_directory;       ///< empty: the scene or the application decides
  std::string restart_directory;      ///< of the run to go on with; empty: a new run
  Verbosity verbosity = Verbosity::normal;
};

/** The application has nothing to do but to print a text and end. */
struct CommandLineExit
{
  int status = 0;   ///< 0 for help and version, 2 for a command line that cannot be used
  std::string text; ///< ends with a line break; belongs to standard output for status 0, else to standard error
};

/** Reads the command line. Prints nothing, so that under MPI one process can print for all. */
std::variant<CommandLine, CommandLineExit>
parse_command_line(int argc, const char *const *argv, const std::string &application, const std::string &description);
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
// What is fuzzed: everything that reads what a user wrote.
#pragma once

#include <string>
#include <vector>

namespace pellicle::fuzz
{
/**
 * Reads an input in one of the ways in which users' files and arguments are read. Returns, whether the input was
 * accepted or refused with a UserError; any other exception leaves it, and ends the program if it is a fuzzer.
 */
struct Target
{
  std::string name; ///< also that of its corpus, tests/fuzz/corpus/<name>, and dictionary, tests/fuzz/<name>.dict
  void (*read)(const std::string &input);
};

const std::vector<Target> &targets();

/** Calls target.read(); a UserError is as good as an answer if it says something. */
void run(const Target &target, const std::string &input);

void read_command_line(const std::string &input);
void read_expression(const std::string &input);
void read_mesh(const std::string &input);
void read_scene(const std::string &input);
void build_scene(const std::string &input);
} // namespace pellicle::fuzz

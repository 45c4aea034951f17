// SPDX-License-Identifier: LGPL-2.1-or-later
// What is fuzzed: everything that reads what a user wrote.
#pragma once

#include <string>
#include <vector>

namespace pellicle::fuzz
{
/**
 * Reads an input in one of the ways in which users' files and arguments are read. Returns or throws UserError, or
 * SolveError if a start shape is found unusable by computing; any other exception is a finding.
 */
using Reader = void(const std::string &input);

Reader read_checkpoint, read_command_line, read_expression, read_mesh, read_model, read_scene;

/** A reader and its name, which is also that of its corpus, tests/fuzz/corpus/<name>. */
struct Target
{
  std::string name;
  Reader *read;
};

const std::vector<Target> &targets();

/** Calls a reader; a refusal is as good as an answer if it says something. */
void run(Reader *read, const std::string &input);
} // namespace pellicle::fuzz

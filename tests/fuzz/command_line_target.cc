// SPDX-License-Identifier: LGPL-2.1-or-later
// Every line of the input is an argument. Overrides that are accepted are set in an empty scene.
#include "targets.h"

#include <pellicle/apps/command_line.h>
#include <pellicle/base/scene_file.h>

#include <sstream>

namespace pellicle::fuzz
{
void read_command_line(const std::string &input)
{
  std::vector<std::string> arguments{"vesicle"};
  std::istringstream lines(input);
  for (std::string line; std::getline(lines, line);)
    arguments.emplace_back(line.c_str()); // as far as a command line can hold it
  std::vector<const char *> argv;
  for (const std::string &argument : arguments)
    argv.push_back(argument.c_str());
  argv.push_back(nullptr);

  const auto parsed = parse_command_line(static_cast<int>(arguments.size()), argv.data(), "vesicle", "A description.");
  if (const auto *end = std::get_if<CommandLineExit>(&parsed))
  {
    if ((end->status != 0 && end->status != 2) || end->text.empty() || end->text.back() != '\n')
      throw std::logic_error("not an answer: " + end->text);
    return;
  }
  SceneEntries scene;
  apply_overrides(scene, std::get<CommandLine>(parsed).overrides);
}
} // namespace pellicle::fuzz

// SPDX-License-Identifier: LGPL-2.1-or-later
// Scene files are files of deal.II's ParameterHandler: both readers find the same values in them.
#include "scene_example.h"

#include <pellicle/base/scene.h>

#include <deal.II/base/parameter_handler.h>

#include <gtest/gtest.h>

#include <sstream>

using namespace pellicle;
using namespace pellicle::test_scene;

namespace
{
std::vector<std::string> parts_of(const std::string &section)
{
  std::vector<std::string> parts;
  std::istringstream stream(section);
  for (std::string part; std::getline(stream, part, '/');)
    parts.push_back(part);
  return parts;
}

void declare(dealii::ParameterHandler &prm, const std::string &section, const std::string &name)
{
  for (const std::string &part : parts_of(section))
    prm.enter_subsection(part);
  prm.declare_entry(name, "not given");
  for (std::size_t i = 0; i < parts_of(section).size(); ++i)
    prm.leave_subsection();
}

/** Parses the text with both readers and compares all entries; unknown entries make deal.II throw. */
void expect_same_entries(const std::string &text, const std::size_t n_entries)
{
  const SceneEntries scene = scan_scene(text, "a.prm");
  dealii::ParameterHandler prm;
  for (const SceneEntry &entry : scene.entries)
    declare(prm, entry.section, entry.name);
  prm.parse_input_from_string(text);
  EXPECT_EQ(scene.entries.size(), n_entries);
  for (const SceneEntry &entry : scene.entries)
    EXPECT_EQ(prm.get(parts_of(entry.section), entry.name), entry.value) << entry.path();
}

std::size_t n_parameters()
{
  Parameters parameters;
  std::size_t n = 2; // the lists of effects and analyses
  for (const ParameterSection &section : parameters.listed())
    n += section.entries().size();
  return n;
}
} // namespace

TEST(ParameterHandler, EveryConstruct)
{
  expect_same_entries(every_construct, 5);
}

TEST(ParameterHandler, CommentedScene)
{
  Parameters parameters;
  expect_same_entries(commented_scene(description(parameters)), n_parameters());
}

TEST(ParameterHandler, UsedScene)
{
  Parameters parameters;
  expect_same_entries(Scene("vesicle", {}).used_text(parameters.listed(), effects, {}), n_parameters());
}

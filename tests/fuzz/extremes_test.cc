// SPDX-License-Identifier: LGPL-2.1-or-later
// Every parameter of the scenes in the corpus at values far out, one after the other: each makes a model or is refused.
#include "scene_input.h"
#include "targets.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace
{
using namespace pellicle;

std::vector<std::string> extreme_values(const ParameterSection::Entry &entry)
{
  if (std::holds_alternative<bool *>(entry.target))
    return {"true", "false"};
  if (std::holds_alternative<std::string *>(entry.target))
    return entry.choices.empty() ? std::vector<std::string>{"1/0", "Mesh/Degree", "1e300*x^9", "sqrt(x)"}
                                 : entry.choices;
  return {"0", "-1", "1", "90", "180", "1e-300", "1e-9", "1e9", "1e300", "-1e300", "inf", "0.5", "1, 1e300, 1e-300"};
}

/** All "Section/Name=value" to try in a scene. */
std::vector<std::string> overrides_for(const std::string &input)
{
  fuzz::SceneInput scene(input);
  std::vector<std::string> all;
  for (const ParameterSection &section : scene.file().read()->sections())
    for (const ParameterSection::Entry &entry : section.entries())
      for (const std::string &value : extreme_values(entry))
        all.push_back(section.name() + "/" + entry.name + "=" + value);
  return all;
}

class Extremes : public testing::TestWithParam<std::string>
{
};

TEST_P(Extremes, MakeAModelOrAreRefused)
{
  std::ostringstream text;
  text << std::ifstream(PELLICLE_SOURCE_DIR "/tests/fuzz/corpus/model/" + GetParam(), std::ios::binary).rdbuf();
  for (const std::string &override : overrides_for(text.str()))
  {
    SCOPED_TRACE(override);
    EXPECT_NO_THROW(fuzz::run(fuzz::read_model, text.str() + "#:set " + override + "\n"));
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Extremes,
                         testing::Values("prolate", "stomatocyte", "tether", "budding", "red_cell", "inclined", "rough",
                                         "squeezed", "pinned_axial", "unpinned_3d", "inclusion", "pinched_hemisphere",
                                         "two_inclusions"),
                         [](const auto &named) { return named.param; });
} // namespace

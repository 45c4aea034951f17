// SPDX-License-Identifier: LGPL-2.1-or-later
// What is written about scenes reads back: used_text(), commented_scene(); the manual's chapter.
#include "scene_example.h"

#include <pellicle/base/scene.h>
#include <pellicle/base/scene_text.h>

#include <gtest/gtest.h>

#include <sstream>

using namespace pellicle;
using namespace pellicle::test_scene;

namespace
{
void expect_equal(const Parameters &a, const Parameters &b) // exactly
{
  EXPECT_EQ(a.vesicle.area, b.vesicle.area);
  EXPECT_EQ(a.vesicle.reduced_volume, b.vesicle.reduced_volume);
  EXPECT_EQ(a.vesicle.stiffness, b.vesicle.stiffness);
  EXPECT_EQ(a.vesicle.shape, b.vesicle.shape);
  EXPECT_EQ(a.vesicle.file, b.vesicle.file);
  EXPECT_EQ(a.vesicle.axes, b.vesicle.axes);
  EXPECT_EQ(a.vesicle.seed, b.vesicle.seed);
  EXPECT_EQ(a.vesicle.noisy, b.vesicle.noisy);
  EXPECT_EQ(a.mesh.degree, b.mesh.degree);
  EXPECT_EQ(a.quality.weight, b.quality.weight);
  EXPECT_EQ(a.bending.rigidity, b.bending.rigidity);
}

Parameters read(const std::string &text)
{
  Parameters parameters;
  Scene("vesicle", scan_scene(text, "b.prm")).read(parameters.listed(), unlisted_sections);
  return parameters;
}

bool contains(const std::string &text, const std::string &part)
{
  return text.find(part) != std::string::npos;
}
} // namespace

TEST(SceneText, UsedTextGivesTheSameValues)
{
  SceneEntries entries = scan_scene("subsection Vesicle\nset Area = 4*pi\nset File = a b.msh\nend\n", "a.prm");
  apply_overrides(
      entries, {"Helfrich bending/Bending rigidity=20*4.11e-21", "Vesicle/Random seed=5", "Mesh/Quality/Weight=1/3"});
  Scene scene("vesicle", entries);
  Parameters parameters;
  const auto sections = parameters.listed();
  scene.read(sections, unlisted_sections);

  const std::string used = scene.used_text(sections, effects, analyses);
  expect_equal(parameters, read(used));
  EXPECT_TRUE(contains(used, "set Area = 4*pi\n")) << used; // verbatim
  EXPECT_TRUE(contains(used, "set Bending rigidity = 20*4.11e-21\n")) << used;
  EXPECT_TRUE(contains(used, "set Semi axes = 1, 0.3333333333333333, 0.1\n")) << used;
  EXPECT_FALSE(contains(used, "Area constraint\n  set")) << used;

  const Scene again("vesicle", scan_scene(used, "used.prm"));
  EXPECT_EQ(again.effects({}, effects), effects);
  EXPECT_EQ(again.analyses({}, analyses), analyses);
}

TEST(SceneText, UsedTextOfAUsedTextIsTheSame)
{
  Parameters parameters, more;
  const auto sections = parameters.listed(), same_sections = more.listed();
  const std::string used = Scene("vesicle", {}).used_text(sections, effects, {});
  Scene again("vesicle", scan_scene(used, "used.prm"));
  again.read(same_sections, unlisted_sections);
  EXPECT_EQ(again.used_text(same_sections, again.effects({}, effects), again.analyses({"stability"}, analyses)), used);
}

TEST(SceneText, CommentedSceneGivesTheDefaults)
{
  Parameters parameters;
  const std::string text = commented_scene(description(parameters));
  expect_equal(read(text), Parameters());
  const Scene scene("vesicle", scan_scene(text, "c.prm"));
  EXPECT_EQ(scene.effects({}, effects), effects);
  EXPECT_EQ(scene.analyses({}, analyses), analyses);
}

TEST(SceneText, CommentedSceneExplains)
{
  Parameters parameters;
  const std::string text = commented_scene(description(parameters));
  EXPECT_TRUE(contains(text, "Known: helfrich bending, area constraint, pressure."));
  EXPECT_TRUE(contains(text, "Known: stability, spectrum."));
  EXPECT_TRUE(contains(text, "  # Area of the membrane.\n"
                             "  # Allowed: a number > 0. Unit: length^2.\n"
                             "  set Area = 12.566370614359172\n"));
  EXPECT_TRUE(contains(text, "# Allowed: 'prolate', 'oblate' or 'file'.\n"));
  EXPECT_TRUE(contains(text, "subsection Mesh\n  subsection Quality\n    # Weight"));
  EXPECT_TRUE(contains(text, "# subsection Pressure\n#   # P, inside minus outside.\n"));
  EXPECT_TRUE(contains(text, "#   set Pressure = 0\n# end\n"));
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    EXPECT_LE(line.size(), 120u) << line;
}

TEST(SceneText, CommentedOutSectionsWorkWhenUncommentedAndListed)
{
  Parameters parameters;
  std::string text = commented_scene(description(parameters));
  text.erase(0, text.find("# subsection Pressure"));
  for (std::size_t at = 0; (at = text.find("# ", at)) != std::string::npos; at = text.find('\n', at))
    text.erase(at, 2);
  const auto section           = bound("Pressure", parameters.pressure);
  parameters.pressure.pressure = 5.;
  Scene("vesicle", scan_scene(text, "c.prm")).read({section}, {});
  EXPECT_EQ(parameters.pressure.pressure, 0.);
}

TEST(SceneText, ParameterChapter)
{
  Parameters parameters;
  const std::string text = parameter_chapter(description(parameters));
  EXPECT_TRUE(contains(
      text, "# Parameters of `vesicle`\n\n## Vesicle\n\n| parameter | default | allowed | unit | meaning |\n"));
  EXPECT_TRUE(contains(text, "| `Area` | `12.566370614359172` | a number > 0 | length^2 | Area of the membrane. |\n"));
  EXPECT_TRUE(contains(text, "below 0 \\| above 1.")) << text;
  EXPECT_TRUE(contains(text, "| `File` | (empty) | any text |  | Mesh file. |\n"));
  EXPECT_TRUE(contains(text, "## Pressure\n\nOnly when the effect `pressure` is listed"));
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// Reading scenes into parameter structs, and the messages about what is wrong with a scene.
#include "expect_user_error.h"
#include "scene_example.h"

#include <pellicle/base/scene.h>

#include <cmath>

using namespace pellicle;
using pellicle::test::expect_user_error;
using namespace pellicle::test_scene;

namespace
{
Scene scene_of(const std::string &text, const std::vector<std::string> &overrides = {})
{
  SceneEntries entries = scan_scene(text, "a.prm");
  apply_overrides(entries, overrides);
  return Scene("vesicle", entries);
}

Parameters read(Scene scene)
{
  Parameters parameters;
  scene.read(parameters.listed(), unlisted_sections);
  return parameters;
}

void expect_read_refusal(const std::string &text, const std::vector<std::string> &parts)
{
  expect_user_error([&] { read(scene_of(text)); }, parts);
}

/** A scene with one line in the section Vesicle, on line 2. */
std::string vesicle_line(const std::string &line)
{
  return "subsection Vesicle\n" + line + "\nend\n";
}

const double inf = std::numeric_limits<double>::infinity();
} // namespace

TEST(Scene, ValuesAndDefaults)
{
  const Parameters p = read(scene_of(R"(
    set Effects = helfrich bending
    subsection Vesicle
      set Area           = 4*pi
      set Start shape    = oblate
      set Semi axes      = 1, sqrt(4), 3
      set Stiffness      = inf
      set Random seed    = 2^3
      set File           = my mesh.msh
      set Noisy          = yes
    end
    subsection Mesh
      subsection Quality
        set Weight = 0.125
      end
    end)"));
  EXPECT_DOUBLE_EQ(p.vesicle.area, 4. * std::acos(-1.));
  EXPECT_EQ(p.vesicle.shape, "oblate");
  EXPECT_EQ(p.vesicle.axes, (std::vector<double>{1., 2., 3.}));
  EXPECT_EQ(p.vesicle.stiffness, inf);
  EXPECT_EQ(p.vesicle.seed, 8);
  EXPECT_EQ(p.vesicle.file, "my mesh.msh");
  EXPECT_TRUE(p.vesicle.noisy);
  EXPECT_EQ(p.quality.weight, 0.125);
  EXPECT_EQ(p.vesicle.reduced_volume, Parameters().vesicle.reduced_volume);
  EXPECT_EQ(p.bending.rigidity, Parameters().bending.rigidity);
}

TEST(Scene, OverridesCount)
{
  const Parameters p =
      read(scene_of(vesicle_line("set Area = 2"), {"Vesicle/Area=3", "Helfrich bending/Bending rigidity=7"}));
  EXPECT_EQ(p.vesicle.area, 3.);
  EXPECT_EQ(p.bending.rigidity, 7.);
}

TEST(Scene, Lists)
{
  using Names          = std::vector<std::string>;
  const Names known    = {"helfrich bending", "area constraint", "pressure"};
  const Names defaults = {"helfrich bending"};
  EXPECT_EQ(scene_of("").effects(defaults, known), defaults);
  EXPECT_EQ(scene_of("set Effects =").effects(defaults, known), Names{});
  EXPECT_EQ(scene_of("set Effects = pressure ,area constraint").effects(defaults, known),
            (Names{"pressure", "area constraint"}));
  EXPECT_EQ(scene_of("set Effects = pressure", {"Effects=area constraint"}).effects(defaults, known),
            Names{"area constraint"});
  EXPECT_EQ(scene_of("set Analyses = stability").analyses({}, {"stability"}), Names{"stability"});

  expect_user_error([&] { scene_of("\nset Effects = pressure, pressure").effects(defaults, known); },
                    {"a.prm:2: ", "Effects", "'pressure' twice"});
  expect_user_error([&] { scene_of("set Effects = presure").effects(defaults, known); },
                    {"a.prm:1: ", "Effects", "'presure'", "Did you mean 'pressure'?"});
  expect_user_error([&] { scene_of("", {"Effects=presure"}).effects(defaults, known); },
                    {"--set \"Effects=presure\": "});
  expect_user_error([&] { scene_of("set Effects = pressure,").effects(defaults, known); }, {"a.prm:1: ", "commas"});
  expect_user_error([&] { scene_of("set Analyses = stabilty").analyses({}, {"stability"}); },
                    {"a.prm:1: ", "Analyses", "'stability'"});
}

TEST(Scene, UnknownSection)
{
  expect_read_refusal("\nsubsection Vesicel\nset Area = 1\nend\n",
                      {"a.prm:2: ", "no section 'Vesicel'", "Did you mean 'Vesicle'?"});
  expect_read_refusal("subsection Vesicel\nend\n", {"a.prm:1: ", "no section 'Vesicel'"});
  expect_read_refusal("subsection Mesh\nsubsection Qualty\nend\nend\n",
                      {"a.prm:2: ", "Did you mean 'Mesh/Quality' or"});
  expect_user_error([] { read(scene_of("", {"Vesicel/Area=1"})); },
                    {"--set \"Vesicel/Area=1\": ", "no section 'Vesicel'"});
}

TEST(Scene, SectionOfAnUnlistedEffect)
{
  const std::string message =
      "section 'Pressure' belongs to the effect 'pressure', which is not in Effects: list it or remove the section";
  expect_read_refusal("\n\nsubsection Pressure\nset Pressure = 1\nend\n", {"a.prm:3: ", message});
  expect_read_refusal("subsection Pressure\nend\n", {"a.prm:1: ", message});
  expect_user_error([] { read(scene_of("", {"Pressure/Pressure=1"})); }, {"--set \"Pressure/Pressure=1\": ", message});
}

TEST(Scene, UnknownParameter)
{
  expect_read_refusal(vesicle_line("set Aera = 1"),
                      {"a.prm:2: ", "section 'Vesicle'", "'Aera'", "Did you mean 'Area'?"});
  expect_read_refusal(vesicle_line("set Bending rigidity = 1"),
                      {"'Bending rigidity'", "is a parameter of the section 'Helfrich bending'."});
  expect_read_refusal("set Effect = pressure\n", {"a.prm:1: ", "top-level", "'Effect'", "Did you mean 'Effects'?"});
  expect_read_refusal("set Area = 1\n", {"top-level", "'Area'", "section 'Vesicle'"});
  expect_user_error([] { read(scene_of("", {"Vesicle/Aera=1"})); }, {"--set \"Vesicle/Aera=1\": ", "'Area'"});
}

TEST(Scene, MalformedNumbers)
{
  const std::vector<std::string> where = {"a.prm:2: ", "section 'Vesicle'", "parameter 'Area'",
                                          "Allowed: a number > 0."};
  for (const char *text : {"4*pie", "nan", "abc", "1,5", "inf", "-inf", "0", "-4*pi"})
  {
    std::vector<std::string> parts = where;
    parts.push_back("'" + std::string(text) + "'");
    expect_read_refusal(vesicle_line("set Area = " + std::string(text)), parts);
  }
  expect_read_refusal(vesicle_line("set Area ="), {"a.prm:2: ", "parameter 'Area'", "empty"});
}

TEST(Scene, RangesNameValueAndLimits)
{
  expect_read_refusal(vesicle_line("set Reduced volume = 1.2"),
                      {"'1.2' is out of range", "Allowed: a number in (0, 1]."});
  expect_read_refusal(vesicle_line("set Reduced volume = 3/2"), {"'3/2' (= 1.5) is out of range"});
  expect_read_refusal(vesicle_line("set Stiffness = -inf"), {"'-inf' is out of range", "a number > 0 or inf"});
  expect_read_refusal(vesicle_line("set Semi axes = 1, -2, 3"), {"'-2' is out of range", "list, each a number > 0"});
  expect_read_refusal(vesicle_line("set Semi axes = 1,,3"), {"missing", "comma-separated"});
}

TEST(Scene, Integers)
{
  expect_read_refusal(vesicle_line("set Random seed = 2.5"), {"'2.5' is not an integer", "Allowed: an integer >= 0."});
  expect_read_refusal(vesicle_line("set Random seed = -1"), {"'-1' is out of range"});
  expect_read_refusal(vesicle_line("set Random seed = 1e10"), {"'1e10' (= 10000000000) is out of range"});
  expect_read_refusal(vesicle_line("set Random seed = inf"), {"'inf' is not an integer"});
  expect_read_refusal("subsection Mesh\nset Degree = 7\nend\n",
                      {"'7' is out of range", "Allowed: an integer in [2, 5]."});
}

TEST(Scene, ChoicesAndFlags)
{
  expect_read_refusal(vesicle_line("set Start shape = prolat"),
                      {"a.prm:2: ", "'prolat'", "Did you mean 'prolate'?", "Allowed: 'prolate', 'oblate' or 'file'."});
  expect_read_refusal(vesicle_line("set Start shape ="), {"'' is not one of the choices"});
  expect_read_refusal(vesicle_line("set Noisy = maybe"),
                      {"'maybe' is neither true nor false", "Allowed: true or false."});
}

TEST(Scene, SettingAParameterAndReadingAgainIsALoadStep)
{
  Scene scene = scene_of(vesicle_line("set Area = 2"));
  Parameters first;
  scene.read(first.listed(), unlisted_sections);
  scene.set("Vesicle/Reduced volume", "0.8", "load step 3");
  Parameters second;
  scene.read(second.listed(), unlisted_sections);
  EXPECT_EQ(first.vesicle.reduced_volume, 1.);
  EXPECT_EQ(second.vesicle.reduced_volume, 0.8);
  EXPECT_EQ(second.vesicle.area, 2.);

  scene.set("Vesicle/Reduced volume", "1.8", "load step 4");
  Parameters third;
  expect_user_error([&] { scene.read(third.listed(), unlisted_sections); }, {"load step 4: ", "'1.8' is out of range"});
}

TEST(Scene, TextAndOriginOfAParameter)
{
  Scene scene = scene_of(vesicle_line("set Area = 4*pi"));
  Parameters parameters;
  scene.read(parameters.listed(), unlisted_sections);
  EXPECT_EQ(scene.value("Vesicle/Area"), "4*pi");
  EXPECT_EQ(scene.origin("Vesicle/Area"), "a.prm:2");
  EXPECT_EQ(scene.value("Vesicle/Reduced volume"), "1");
  EXPECT_EQ(scene.origin("Vesicle/Reduced volume"), "default");
  expect_user_error([&] { scene.value("Vesicle/Reduced volum"); },
                    {"no parameter 'Vesicle/Reduced volum'", "Did you mean 'Vesicle/Reduced volume'"});
}

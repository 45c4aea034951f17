// SPDX-License-Identifier: LGPL-2.1-or-later
#include "expect_user_error.h"
#include "scene_example.h"

#include <pellicle/base/scene_file.h>

#include <filesystem>
#include <fstream>

using namespace pellicle;
using pellicle::test::expect_user_error;
using namespace pellicle::test_scene;

namespace
{
/** "path=value@origin" of every entry, one a line. */
std::string listing(const SceneEntries &scene)
{
  std::string text;
  for (const SceneEntry &entry : scene.entries)
    text += entry.path() + "=" + entry.value + "@" + entry.origin + "\n";
  return text;
}

void expect_scan_refusal(const std::string &text, const std::vector<std::string> &parts)
{
  expect_user_error([&] { scan_scene(text, "a.prm"); }, parts);
}
} // namespace

TEST(SceneFile, EveryConstruct)
{
  const SceneEntries scene = scan_scene(every_construct, "a.prm");
  EXPECT_EQ(listing(scene), "Effects=helfrich bending, area constraint@a.prm:2\n"
                            "Mesh/Degree=4@a.prm:6\n"
                            "Mesh/Inner part/File=a b.msh@a.prm:8\n"
                            "Mesh/Refinements=@a.prm:10\n"
                            "Vesicle/Reduced volume=2 * (0.4) = x@a.prm:13\n");
  ASSERT_EQ(scene.sections.size(), 3u);
  EXPECT_EQ(scene.sections[1].name, "Mesh/Inner part");
  EXPECT_EQ(scene.sections[1].origin, "a.prm:7");
  EXPECT_EQ(scene.entries[2].section, "Mesh/Inner part");
  EXPECT_EQ(scene.entries[2].name, "File");
}

TEST(SceneFile, CarriageReturnsAndMissingLastLineBreakDoNotMatter)
{
  EXPECT_EQ(listing(scan_scene("set A = 1\r\nset B = \\\r\n  2", "a.prm")), "A=1@a.prm:1\nB=2@a.prm:2\n");
  EXPECT_EQ(listing(scan_scene("", "a.prm")), "");
}

TEST(SceneFile, EmptySectionsAreReported)
{
  const SceneEntries scene = scan_scene("\nsubsection Pressure\nend\n", "a.prm");
  ASSERT_EQ(scene.sections.size(), 1u);
  EXPECT_EQ(scene.sections[0].origin, "a.prm:2");
}

TEST(SceneFile, MalformedLines)
{
  for (const char *line : {"Degree = 4", "set Degree 4", "set = 4", "set", "subsection", "end it", "sett A = 3",
                           "include other.prm", "set Mesh/Degree = 4", "subsection A/B"})
    expect_scan_refusal("set A = 1\n" + std::string(line) + "\n",
                        {"a.prm:2: ", "'" + std::string(line) + "'", "'set Name = value'"});
}

TEST(SceneFile, UnbalancedSubsections)
{
  expect_scan_refusal("set A = 1\nend\n", {"a.prm:2: ", "'end' without an open subsection"});
  expect_scan_refusal("subsection Mesh\n set A = 1\n", {"a.prm:1: ", "'Mesh' is never closed"});
}

TEST(SceneFile, DuplicatesNameBothLines)
{
  expect_scan_refusal("subsection M\nset A = 1\nend\n\nsubsection M\nset A = 1\nend\n",
                      {"a.prm:6: ", "'M/A' is set twice", "a.prm:2"});
  EXPECT_NO_THROW(scan_scene("set A = 1\nsubsection M\nset A = 1\nend\n", "a.prm"));
}

TEST(SceneFile, FilesThatCannotBeRead)
{
  expect_user_error([] { read_scene_file("no_such_file.prm"); }, {"'no_such_file.prm'", "No such file"});
  const std::string directory = std::filesystem::temp_directory_path().string();
  expect_user_error([&] { read_scene_file(directory); }, {"'" + directory + "'", "is a directory"});
}

TEST(SceneFile, ReadsFiles)
{
  const std::filesystem::path file = std::filesystem::path(PELLICLE_BINARY_DIR) / "tests" / "scene_file_test.prm";
  std::ofstream(file) << "set A = 1\n";
  EXPECT_EQ(listing(read_scene_file(file.string())), "A=1@" + file.string() + ":1\n");
  std::ofstream(file, std::ios::trunc).flush();
  EXPECT_EQ(listing(read_scene_file(file.string())), "");
  std::filesystem::remove(file);
}

TEST(SceneFile, OverridesReplaceAndAdd)
{
  SceneEntries scene = scan_scene("set A = 1\nsubsection M\nset B = 2\nend\n", "a.prm");
  apply_overrides(scene, {"M/B = 3", "M/N/C=4", "D=x=y", "M/B=5", "A="});
  EXPECT_EQ(listing(scene), "A=@--set \"A=\"\n"
                            "M/B=5@--set \"M/B=5\"\n"
                            "M/N/C=4@--set \"M/N/C=4\"\n"
                            "D=x=y@--set \"D=x=y\"\n");
}

TEST(SceneFile, MalformedOverrides)
{
  SceneEntries scene;
  for (const char *argument : {"Mesh/Degree", "=3", " =3"})
    expect_user_error([&] { apply_overrides(scene, {argument}); },
                      {"--set \"" + std::string(argument) + "\"", "Section/Name=value"});
  for (const char *argument : {"/A=3", "Mesh/=3"})
    expect_user_error([&] { apply_overrides(scene, {argument}); }, {"names no parameter", "'Section/Name'"});
  for (const char *argument : {"M/F=a#b", "M/F=a\nb", "M/F=a\\"})
    expect_user_error([&] { apply_overrides(scene, {argument}); }, {"--set \"M/F=a", "cannot hold '#'"});
}

// What is no scene at all is refused before it fills the memory, and without printing it.
TEST(SceneFile, WhatIsNoScene)
{
  expect_user_error([] { scan_scene(std::string("set A = 1\n\0", 11), "a.vtu"); }, {"a.vtu", "zero bytes"});
  expect_user_error([] { scan_scene("\x1b[2J", "a.prm"); }, {"a.prm:1: cannot understand '?[2J'"});
  expect_user_error([] { read_scene_file("/dev/zero"); }, {"'/dev/zero' is no scene file", "more than 4000000"});
  std::string nested;
  for (unsigned int i = 0; i < 9; ++i)
    nested += "subsection A\n";
  expect_user_error([&] { scan_scene(nested, "a.prm"); }, {"a.prm:9", "nested more than 8 deep"});
  expect_user_error([] { scan_scene("subsection " + std::string(201, 'a'), "a.prm"); },
                    {"a.prm:1", std::string(197, 'a') + "...'", "more than 200 characters"});
}

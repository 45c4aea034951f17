// SPDX-License-Identifier: LGPL-2.1-or-later
// The manual's parameter chapter is what the parameter structs say.
#include <pellicle/base/scene_text.h>
#include <pellicle/models/vesicle_scene.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace
{
using namespace pellicle;

TEST(Manual, ParameterChapterIsUpToDate)
{
  const EffectLibrary library = standard_effects();
  VesicleScene scene          = make_vesicle_scene(library, library.names(), {});
  SceneDescription description;
  description.application    = "vesicle";
  description.effects        = library.names();
  description.known_effects  = library.names();
  description.known_analyses = {"stability", "phase diagram"};
  description.sections       = scene.sections();
  const std::string chapter  = parameter_chapter(description);

  const std::string path = PELLICLE_SOURCE_DIR "/doc/parameters.md";
  if (std::getenv("PELLICLE_WRITE_MANUAL") != nullptr)
    std::ofstream(path) << chapter;
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  EXPECT_EQ(text.str(), chapter) << "Run this test with PELLICLE_WRITE_MANUAL=1 and commit doc/parameters.md.";
}
} // namespace

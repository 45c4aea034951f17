// SPDX-License-Identifier: LGPL-2.1-or-later
// The manual's parameter chapters are what the parameter structs say.
#include <pellicle/base/scene_text.h>
#include <pellicle/models/droplet_scene.h>
#include <pellicle/models/ridge_scene.h>
#include <pellicle/models/vesicle_scene.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace
{
using namespace pellicle;

void compare(const std::string &application, const std::string &file, const EffectLibrary &library,
             const std::vector<std::string> &analyses, SurfaceScene &scene)
{
  SceneDescription description;
  description.application    = application;
  description.effects        = library.names();
  description.known_effects  = library.names();
  description.known_analyses = analyses;
  description.sections       = scene.sections();
  const std::string chapter  = parameter_chapter(description);

  const std::string path = PELLICLE_SOURCE_DIR "/doc/" + file;
  if (std::getenv("PELLICLE_WRITE_MANUAL") != nullptr)
    std::ofstream(path) << chapter;
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  EXPECT_EQ(text.str(), chapter) << "Run this test with PELLICLE_WRITE_MANUAL=1 and commit doc/" << file << ".";
}

TEST(Manual, ParametersOfVesicles)
{
  const EffectLibrary library = standard_effects();
  VesicleScene scene          = make_vesicle_scene(library, library.names(), {});
  compare("vesicle", "parameters.md", library, {"stability", "phase diagram"}, scene);
}

TEST(Manual, ParametersOfDrops)
{
  const EffectLibrary library = droplet_effects();
  DropletScene scene          = make_droplet_scene(library, library.names(), {});
  compare("droplet_contact", "parameters_droplet_contact.md", library, {"stability"}, scene);
}

TEST(Manual, ParametersOfRidges)
{
  const EffectLibrary library = ridge_effects();
  RidgeScene scene            = make_ridge_scene(library, library.names(), {});
  compare("wetting_ridge", "parameters_wetting_ridge.md", library, {"stability"}, scene);
}
} // namespace

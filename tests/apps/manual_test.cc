// SPDX-License-Identifier: LGPL-2.1-or-later
// The manual's parameter chapters are what the parameter structs say.
#include <pellicle/base/scene_text.h>
#include <pellicle/models/director_scene.h>
#include <pellicle/models/droplet_scene.h>
#include <pellicle/models/ridge_scene.h>
#include <pellicle/models/shell_scene.h>
#include <pellicle/models/vesicle_scene.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace
{
using namespace pellicle;

void compare(const std::string &application, const std::string &file, const EffectLibrary &library,
             const std::vector<std::string> &effects, const std::vector<std::string> &analyses, SurfaceScene &scene)
{
  SceneDescription description;
  description.application    = application;
  description.effects        = effects;
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
  compare("vesicle", "parameters.md", library, library.names(), {"stability", "phase diagram"}, scene);
}

TEST(Manual, ParametersOfDrops)
{
  const EffectLibrary library = droplet_effects();
  DropletScene scene          = make_droplet_scene(library, library.names(), {});
  compare("droplet_contact", "parameters_droplet_contact.md", library, library.names(), {"stability"}, scene);
}

TEST(Manual, ParametersOfRidges)
{
  const EffectLibrary library = ridge_effects();
  RidgeScene scene            = make_ridge_scene(library, library.names(), {});
  compare("wetting_ridge", "parameters_wetting_ridge.md", library, library.names(), {"stability"}, scene);
}

/** Those of a shell are in scenes of their own. */
TEST(Manual, ParametersOfMembranesWithDirectorsAndOfShells)
{
  const EffectLibrary library           = director_effects();
  std::vector<std::string> of_membranes = library.names(), of_shells{"cosserat shell", "dead load", "point loads"};
  for (const std::string &name : of_shells)
    of_membranes.erase(std::find(of_membranes.begin(), of_membranes.end(), name));
  of_shells.push_back("pressure");
  DirectorScene membrane;
  list_effects(membrane, library, of_membranes, {});
  compare("director_membrane", "parameters_director_membrane.md", library, of_membranes, {"stability"}, membrane);
  ShellScene shell = make_shell_scene(library, of_shells, {});
  compare("director_membrane", "parameters_shells.md", library, of_shells, {"stability"}, shell);
}
} // namespace

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene_input.h"

#include <pellicle/models/director_scene.h>
#include <pellicle/models/droplet_scene.h>
#include <pellicle/models/ridge_scene.h>
#include <pellicle/models/shell_scene.h>
#include <pellicle/models/vesicle_scene.h>

#include <sstream>

namespace pellicle::fuzz
{
namespace
{
template <typename Scene>
std::unique_ptr<SurfaceScene> scene_of(const std::vector<std::string> & /*effects*/)
{
  return std::make_unique<Scene>();
}

/** The scenes of all applications; those of shells as if they had one of their own. */
const std::vector<SurfaceApplication> &applications()
{
  static const std::vector<SurfaceApplication> list = {
      {"vesicle",
       "",
       standard_effects(),
       {"helfrich bending", "area constraint", "volume constraint"},
       scene_of<VesicleScene>,
       {{"phase diagram", {}}}},
      {"droplet_contact",
       "",
       droplet_effects(),
       {"liquid surface", "volume constraint", "wetting"},
       scene_of<DropletScene>},
      {"wetting_ridge",
       "",
       ridge_effects(),
       {"liquid surface", "volume constraint", "solid", "solid skins"},
       scene_of<RidgeScene>},
      {"director_membrane", "", director_effects(), {"director"}, scene_of<DirectorScene>},
      {"shell", "", director_effects(), {"cosserat shell"}, scene_of<ShellScene>}};
  return list;
}
} // namespace

SceneInput::SceneInput(const std::string &input, const std::vector<std::string> &overrides)
    : memory(input)
    , chosen(&applications().front())
{
  CommandLine command_line;
  command_line.scene_file = memory.name();
  std::istringstream lines(input);
  for (std::string line; std::getline(lines, line);)
  {
    for (const SurfaceApplication &application : applications())
      if (line == "#:" + application.name)
        chosen = &application;
    const std::string set = "#:set ";
    if (line.rfind(set, 0) == 0)
      command_line.overrides.push_back(line.substr(set.size()));
  }
  command_line.overrides.insert(command_line.overrides.end(), overrides.begin(), overrides.end());
  scene_file = std::make_unique<SurfaceSceneFile>(*chosen, command_line);
}
} // namespace pellicle::fuzz

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/apps/surface_application.h>
#include <pellicle/models/director_scene.h>
#include <pellicle/models/shell_scene.h>

#include <algorithm>

int main(int argc, char **argv)
{
  using namespace pellicle;
  const auto scene_for = [](const std::vector<std::string> &effects) -> std::unique_ptr<SurfaceScene>
  {
    if (std::find(effects.begin(), effects.end(), "cosserat shell") != effects.end())
      return std::make_unique<ShellScene>();
    return std::make_unique<DirectorScene>();
  };
  return run_surface_application(argc, argv,
                                 {"director_membrane",
                                  "Membranes with directors (tilt of lipids) and Cosserat shells.",
                                  director_effects(),
                                  {"director"},
                                  scene_for});
}

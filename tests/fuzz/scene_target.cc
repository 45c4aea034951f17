// SPDX-License-Identifier: LGPL-2.1-or-later
// A scene becomes the values of all parameters, is checked, and is written as it would be run.
#include "scene_input.h"
#include "targets.h"

namespace pellicle::fuzz
{
void read_scene(const std::string &input)
{
  SceneInput scene(input);
  const std::unique_ptr<SurfaceScene> values = scene.file().read();
  const std::string used                     = scene.file().used_text();

  SceneInput again("#:" + scene.application().name + "\n" + used);
  again.file().read();
  if (again.file().used_text() != used)
    throw std::logic_error("used.prm is read as another scene");

  values->scales();
  if (!values->load.parameter.empty())
    scene_at_start_of_load(scene.file(), values->load);
}
} // namespace pellicle::fuzz

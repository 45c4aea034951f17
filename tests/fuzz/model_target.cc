// SPDX-License-Identifier: LGPL-2.1-or-later
// What --validate does, on the coarsest mesh: a scene becomes a model that could be solved.
#include "scene_input.h"
#include "targets.h"

#include "../../source/apps/mpi_session.h"

namespace pellicle::fuzz
{
void read_model(const std::string &input)
{
  int argc    = 0;
  char **argv = nullptr;
  static const MpiSession session(argc, argv);
  SceneInput scene(input, {"Mesh/Degree=2", "Mesh/Refinements=0"});
  std::unique_ptr<SurfaceScene> values = scene.file().read();
  if (!values->load.parameter.empty())
    values = scene_at_start_of_load(scene.file(), values->load);
  Timing timing;
  const Communicator communicator;
  const SurfaceModel model(*values, communicator, timing);
}
} // namespace pellicle::fuzz

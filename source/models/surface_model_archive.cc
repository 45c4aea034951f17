// SPDX-License-Identifier: LGPL-2.1-or-later
// A model in a checkpoint.
#include <pellicle/models/surface_model.h>

#include <utility>

namespace pellicle
{
void SurfaceModel::exchange(Archive &archive)
{
  std::size_t n_nodes = solved_mesh().n_nodes;
  archive.name("model");
  archive | n_nodes;
  if (n_nodes != solved_mesh().n_nodes)
    throw ArchiveMismatch("it is of a mesh with " + std::to_string(n_nodes) + " nodes, and the scene's has " +
                          std::to_string(solved_mesh().n_nodes));
  bool rigid_gauge = true;
  for (const auto &active : active_sets)
  {
    archive.name(active->name());
    active->exchange(archive);
    rigid_gauge = rigid_gauge && active->leaves_rigid_motions();
  }
  if (archive.is_reading() && !active_sets.empty())
  {
    NodalConditions conditions = own_conditions;
    for (const auto &active : active_sets)
      active->add_conditions(conditions);
    problem->set_rigid_gauge(rigid_gauge);
    problem->set_conditions(std::move(conditions));
  }
  problem->exchange(archive);
  archive | last_unknown_counts | last_stability | last_linear_solver;
}

void SurfaceModel::exchange_motion(const TimeParameters &time, Archive &archive)
{
  archive.name("motion");
  if (!archive.is_reading())
  {
    current_motion->write(archive);
    return;
  }
  // A motion begins in a chart of its own, and its integrator normalises directors.
  Archive state;
  problem->exchange(state);
  current_motion = make_motion(time, {newton, *problem, *solver, communicator, timing}, &archive);
  Archive same(state.content());
  problem->exchange(same);
}
} // namespace pellicle

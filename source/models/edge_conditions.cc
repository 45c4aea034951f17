// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/models/edge_conditions.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

namespace pellicle
{
namespace
{
const EdgeLoop &loop_named(const SurfaceDiscretization &discretization, const std::string &name)
{
  const auto &edges = discretization.edges;
  const auto found  = std::find_if(edges.begin(), edges.end(), [&](const EdgeLoop &e) { return e.name == name; });
  PELLICLE_ASSERT(found != edges.end(), "the scene names an edge that the mesh does not have");
  return *found;
}

void set_all(FieldConditions &conditions, const SurfaceDiscretization &discretization, const EdgeLoop &loop,
             const std::optional<AdmissibleDirections> &directions)
{
  conditions.only.resize(discretization.n_nodes);
  for (const std::size_t node : loop.cell_nodes)
    conditions.only[node] = directions;
}

AdmissibleDirections along_z()
{
  AdmissibleDirections directions;
  directions.count   = 1;
  directions.columns = {{{{0., 0., 1.}}, {}, {}}};
  return directions;
}

/** One node moves as another one. */
void follow(FieldConditions &conditions, const SurfaceDiscretization &discretization, const std::size_t follower,
            const std::size_t leader)
{
  if (conditions.leader.empty())
  {
    conditions.leader.resize(discretization.n_nodes);
    std::iota(conditions.leader.begin(), conditions.leader.end(), 0);
  }
  conditions.leader[follower] = leader;
}

/** All nodes of a loop move as its first one. */
void tie(FieldConditions &conditions, const SurfaceDiscretization &discretization, const EdgeLoop &loop)
{
  for (const std::size_t node : loop.cell_nodes)
    follow(conditions, discretization, node, loop.cell_nodes.front());
}

} // namespace

NodalConditions edge_conditions(const SurfaceDiscretization &discretization, const SceneTargets &targets)
{
  NodalConditions conditions;
  const auto has_conormals = [&](const SceneEdge &edge, const EdgeLoop &loop)
  {
    FieldConditions &conormals = conditions["edge conormal"];
    if (conormals.only.empty())
      conormals.only.assign(discretization.n_nodes, held());
    set_all(conormals, discretization, loop, std::nullopt);
    // Its multiplier lives on one side of a split line only, that of the potential.
    if (edge.support != EdgeSupport::far_side)
      conditions["edge multiplier"].only = conormals.only;
  };
  for (const SceneEdge &edge : targets.edges)
  {
    const EdgeLoop &loop = loop_named(discretization, edge.name);
    if (edge.support == EdgeSupport::inner || edge.support == EdgeSupport::far_side)
    {
      if (targets.gaussian_difference != 0.)
        has_conormals(edge, loop);
      continue;
    }
    if (edge.support == EdgeSupport::on_body)
      continue; // the application's business
    if (edge.name == "tip")
    {
      set_all(conditions["position"], discretization, loop, along_z());
      tie(conditions["position"], discretization, loop);
    }
    else if (edge.support != EdgeSupport::free)
      set_all(conditions["position"], discretization, loop, held());
    if (edge.support == EdgeSupport::clamped)
      continue;
    if (targets.gaussian_modulus != 0.)
      has_conormals(edge, loop);
    else
      set_all(conditions["moment"], discretization, loop, held());
  }
  // Both sides of a split line are at the same place and have the same conormal and director; the shear that directors
  // exert is each one's own, and moments are where Gaussian moduli differ.
  for (const auto &[copy, original] : discretization.twins)
  {
    for (const char *field : {"position", "edge conormal", "director"})
      follow(conditions[field], discretization, copy, original);
    if (targets.gaussian_difference == 0.)
      follow(conditions["moment"], discretization, copy, original);
  }
  return conditions;
}

} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/discretization/edge_loops.h>
#include <pellicle/discretization/hanging_nodes.h>

namespace pellicle
{
void join_hanging_nodes(const std::vector<HangingNode> &hanging, NodalVectors &values)
{
  for (const HangingNode &hangs : hanging)
    for (unsigned int c = 0; c < 3; ++c)
    {
      double sum = 0.;
      for (const auto &[node, share] : hangs.shares)
        sum += share * values[3 * node + c];
      values[3 * hangs.node + c] = sum;
    }
}

void join_hanging_nodes(SurfaceDiscretization &discretization)
{
  join_hanging_nodes(discretization.hanging, discretization.positions);
  if (!discretization.mesh_reference.empty())
    join_hanging_nodes(discretization.hanging, discretization.mesh_reference);
  for (auto &field : discretization.start_values)
    join_hanging_nodes(discretization.hanging, field.second);
}

void hand_over_forces(const std::vector<HangingNode> &hanging, NodalVectors &forces)
{
  for (const HangingNode &hangs : hanging)
    for (unsigned int c = 0; c < 3; ++c)
    {
      for (const auto &[node, share] : hangs.shares)
        forces[3 * node + c] += share * forces[3 * hangs.node + c];
      forces[3 * hangs.node + c] = 0.;
    }
}

std::vector<bool> hanging_flags(const SurfaceDiscretization &discretization)
{
  std::vector<bool> flags(discretization.n_nodes, false);
  for (const HangingNode &hangs : discretization.hanging)
    flags[hangs.node] = true;
  return flags;
}

// Nodes in the middle of an edge belong to no other edge: one of them tells.
IrregularSides::IrregularSides(const SurfaceDiscretization &discretization)
    : surface(discretization)
    , marks(hanging_flags(discretization))
{
  for (const HangingNode &hangs : discretization.hanging)
    for (const auto &[node, share] : hangs.shares)
      marks[node] = true;
}

bool IrregularSides::contains(const CellSide &side) const
{
  return marks[side_node(surface, side, 1)];
}
} // namespace pellicle

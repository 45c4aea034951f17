// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/split_line.h>

#include <algorithm>
#include <map>
#include <set>

namespace pellicle
{
std::string far_side(const std::string &line)
{
  return line + ", far side";
}

SurfaceDiscretization split_along(SurfaceDiscretization surface, const std::string &line)
{
  const auto loop = std::find_if(surface.edges.begin(), surface.edges.end(),
                                 [&](const EdgeLoop &candidate) { return candidate.name == line; });
  PELLICLE_ASSERT(loop != surface.edges.end() && !loop->is_rim, "there is no such line to split along");

  std::map<std::size_t, std::size_t> copy_of;
  for (const std::size_t node : loop->cell_nodes)
    copy_of.emplace(node, 0);
  const auto append = [](NodalVectors &vectors, const std::size_t node)
  {
    for (unsigned int c = 0; c < 3; ++c)
      vectors.push_back(vectors[3 * node + c]);
  };
  for (auto &[original, copy] : copy_of)
  {
    copy = surface.n_nodes++;
    surface.twins.emplace_back(copy, original);
    append(surface.positions, original);
    if (!surface.mesh_reference.empty())
      append(surface.mesh_reference, original);
    for (auto &field : surface.start_values)
      append(field.second, original);
    if (!surface.admissible.empty())
      surface.admissible.push_back(surface.admissible[original]);
  }
  const auto replace = [&](std::size_t &node)
  {
    const auto found = copy_of.find(node);
    if (found != copy_of.end())
      node = found->second;
  };
  std::set<std::size_t> beyond; // nodes on the far side
  for (std::size_t cell = 0; cell < surface.n_cells; ++cell)
    if (surface.cell_region[cell] != 0)
      for (std::size_t i = 0; i < surface.n_local(); ++i)
      {
        std::size_t &node = surface.cell_nodes[cell * surface.n_local() + i];
        replace(node);
        beyond.insert(node);
      }
  for (HangingNode &hanging : surface.hanging)
    if (beyond.count(hanging.node) > 0)
      for (auto &[node, share] : hanging.shares)
        replace(node);

  EdgeLoop other = *loop;
  other.name     = far_side(line);
  for (std::size_t &node : loop->cell_nodes)
    replace(node);
  surface.edges.push_back(std::move(other));
  return surface;
}
} // namespace pellicle

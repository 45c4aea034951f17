// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/joined.h>

#include <algorithm>
#include <utility>

namespace pellicle
{
namespace
{
void append(std::vector<std::size_t> &list, const std::vector<std::size_t> &more, const std::size_t shift)
{
  for (const std::size_t node : more)
    list.push_back(shift + node);
}

void shift(std::vector<std::size_t> &list, const std::size_t by)
{
  for (std::size_t &node : list)
    node += by;
}

template <typename Part>
void check_name(const std::vector<Part> &parts, const std::string &name)
{
  if (std::any_of(parts.begin(), parts.end(), [&](const Part &part) { return part.name == name; }))
    throw UserError("Two parts of a scene are named \"" + name + "\". Give one of them another name.");
}
} // namespace

SurfaceDiscretization joined(const SurfaceDiscretization &first, const SurfaceDiscretization &second,
                             const std::array<std::string, 2> &regions)
{
  if (first.kind != second.kind || first.degree != second.degree)
    throw UserError("Parts of one scene must both be axial or both not, and of one degree; the degrees are " +
                    std::to_string(first.degree) + " and " + std::to_string(second.degree) + ".");
  PELLICLE_ASSERT(first.region_names.empty() && second.region_names.empty() && first.mirror == second.mirror,
                  "parts with regions cannot be joined");
  SurfaceDiscretization result = first;
  const std::size_t n = first.n_nodes, n_cells = first.n_cells;
  result.n_nodes += second.n_nodes;
  result.n_cells += second.n_cells;
  append(result.cell_nodes, second.cell_nodes, n);
  unsigned int n_patches = 0;
  for (const CellPlace &place : first.cell_places)
    n_patches = std::max(n_patches, place.patch + 1);
  for (CellPlace place : second.cell_places)
  {
    place.patch += n_patches;
    result.cell_places.push_back(place);
  }
  result.positions.insert(result.positions.end(), second.positions.begin(), second.positions.end());
  result.mesh_reference.insert(result.mesh_reference.end(), second.mesh_reference.begin(), second.mesh_reference.end());
  result.admissible.resize(n);
  if (second.admissible.empty())
    result.admissible.resize(result.n_nodes);
  else
    result.admissible.insert(result.admissible.end(), second.admissible.begin(), second.admissible.end());
  result.rigid_motions.clear();
  for (EdgeLoop loop : second.edges)
  {
    check_name(first.edges, loop.name);
    shift(loop.cell_nodes, n);
    for (CellSide &side : loop.sides)
      side.cell += n_cells;
    result.edges.push_back(std::move(loop));
  }
  for (BulkPart body : second.bulks)
  {
    check_name(first.bulks, body.name);
    shift(body.cell_nodes, n);
    for (auto &[name, nodes] : body.faces)
      shift(nodes, n);
    result.bulks.push_back(std::move(body));
  }
  for (HangingNode hanging : second.hanging)
  {
    hanging.node += n;
    for (auto &[node, share] : hanging.shares)
      node += n;
    result.hanging.push_back(std::move(hanging));
  }
  for (const auto &[copy, original] : second.twins)
    result.twins.emplace_back(copy + n, original + n);
  if (n_cells > 0 && second.n_cells > 0)
  {
    result.region_names = {regions[0], regions[1]};
    result.cell_region.assign(n_cells, 0);
    result.cell_region.resize(result.n_cells, 1);
  }
  return result;
}

SurfaceDiscretization without_surface(SurfaceDiscretization discretization)
{
  discretization.n_cells = 0;
  discretization.cell_nodes.clear();
  discretization.cell_places.clear();
  discretization.edges.clear();
  return discretization;
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/edge_loops.h>
#include <pellicle/discretization/hanging_nodes.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace pellicle
{
namespace
{
/** Sides by the nodes at which they begin and end. */
using SideMap = std::map<std::pair<std::size_t, std::size_t>, CellSide>;

std::pair<std::size_t, std::size_t> ends(const SurfaceDiscretization &surface, const CellSide &at)
{
  return {side_node(surface, at, 0), side_node(surface, at, surface.degree)};
}

// Where cells of different sizes meet there is no line: lines have cells of equal size on both sides.
template <typename Predicate>
SideMap collect_sides(const SurfaceDiscretization &surface, const Predicate &wanted)
{
  const IrregularSides irregular(surface);
  SideMap sides;
  for (std::size_t cell = 0; cell < surface.n_cells; ++cell)
    for (unsigned int side = 0; side < 4 && wanted(cell); ++side)
      if (!irregular.contains({cell, side}))
        sides[ends(surface, {cell, side})] = {cell, side};
  return sides;
}

/** Sides whose other side is not among `cells`, by the node at which they begin. Neighbours oriented alike run through
 * their common side in opposite directions. */
std::map<std::size_t, CellSide> unmatched(const SideMap &cells)
{
  std::map<std::size_t, CellSide> sides;
  for (const auto &[nodes, side] : cells)
    if (cells.count({nodes.second, nodes.first}) == 0)
    {
      PELLICLE_ASSERT(sides.count(nodes.first) == 0, "lines touch each other in a node");
      sides[nodes.first] = side;
    }
  return sides;
}

/** Joins sides end to end; the first of each line is where it begins or, of a closed one, the one of the first cell. */
std::vector<EdgeLoop> join(const SurfaceDiscretization &surface, std::map<std::size_t, CellSide> from)
{
  std::vector<EdgeLoop> loops;
  while (!from.empty())
  {
    std::set<std::size_t> reached;
    for (const auto &[node, side] : from)
      reached.insert(side_node(surface, side, surface.degree));
    const auto first_cell = [](const auto &a, const auto &b) { return a.second.cell < b.second.cell; };
    auto next = std::find_if(from.begin(), from.end(), [&](const auto &at) { return reached.count(at.first) == 0; });
    if (next == from.end())
      next = std::min_element(from.begin(), from.end(), first_cell);
    EdgeLoop loop;
    loop.tables = make_edge_tables(surface.degree, surface.degree + 1);
    while (next != from.end())
    {
      const CellSide at = next->second;
      from.erase(next);
      loop.sides.push_back(at);
      for (std::size_t i = 0; i <= surface.degree; ++i)
        loop.cell_nodes.push_back(side_node(surface, at, i));
      next = from.find(loop.cell_nodes.back());
    }
    loop.n_cells = loop.sides.size();
    loops.push_back(std::move(loop));
  }
  return loops;
}
} // namespace

std::size_t side_node(const SurfaceDiscretization &surface, const CellSide &at, const std::size_t i)
{
  const std::size_t k            = surface.degree;
  const std::size_t *const nodes = &surface.cell_nodes[at.cell * surface.n_local()];
  const std::array<std::size_t, 4> local{{i, i * (k + 1) + k, k * (k + 1) + k - i, (k - i) * (k + 1)}};
  return nodes[local[at.side]];
}

EdgeLoop circle_loop(const SurfaceDiscretization &meridian, const std::string &name, const std::size_t cell,
                     const bool at_end_of_cell, const bool is_rim)
{
  PELLICLE_ASSERT(meridian.kind == SurfaceDiscretization::Kind::meridian, "circles are lines of meridians");
  EdgeLoop loop;
  loop.name       = name;
  loop.is_rim     = is_rim;
  loop.n_cells    = 1;
  loop.cell_nodes = {meridian.cell_nodes[cell * meridian.n_local() + (at_end_of_cell ? meridian.degree : 0)]};
  loop.sides      = {{cell, at_end_of_cell ? 1u : 0u}};
  loop.tables     = make_circle_tables(at_end_of_cell ? 1 : -1);
  return loop;
}

std::vector<EdgeLoop> find_rims(const SurfaceDiscretization &surface,
                                const std::function<std::string(const Vector3<double> &)> &name)
{
  std::vector<EdgeLoop> rims = join(surface, unmatched(collect_sides(surface, [](const std::size_t) { return true; })));
  for (EdgeLoop &rim : rims)
  {
    PELLICLE_ASSERT(rim.cell_nodes.front() == rim.cell_nodes.back(), "a line around a surface is closed");
    const double *const x = &surface.positions[3 * rim.cell_nodes[0]];
    rim.name              = name({x[0], x[1], x[2]});
  }
  return rims;
}

std::vector<EdgeLoop> find_region_boundary(const SurfaceDiscretization &surface, const unsigned int region,
                                           const std::string &name)
{
  const auto inside = [&](const std::size_t cell) { return surface.cell_region[cell] == region; };
  const SideMap others =
      collect_sides(surface, [&](const std::size_t cell) { return surface.cell_region[cell] != region; });
  std::map<std::size_t, CellSide> sides;
  for (const auto &[node, side] : unmatched(collect_sides(surface, inside)))
  {
    const auto nodes = ends(surface, side);
    if (others.count({nodes.second, nodes.first}) > 0) // else the surface ends there
      sides[node] = side;
  }
  std::vector<EdgeLoop> loops = join(surface, sides);
  for (EdgeLoop &loop : loops)
  {
    loop.name   = name;
    loop.is_rim = false;
  }
  return loops;
}

std::vector<bool> nodes_of_edges(const SurfaceDiscretization &surface)
{
  std::vector<bool> on_edge(surface.n_nodes, false);
  for (const EdgeLoop &loop : surface.edges)
    for (const std::size_t node : loop.cell_nodes)
      on_edge[node] = true;
  return on_edge;
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/surface_cells.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/hanging_nodes.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace pellicle
{
namespace
{
/** Local nodes of a side, numbered as in CellSide. */
std::vector<std::size_t> side_nodes(const unsigned int side, const std::size_t degree)
{
  const std::size_t n     = degree + 1;
  const std::size_t begin = side == 1 ? degree : side == 2 ? degree * n : 0, step = side % 2 == 0 ? 1 : n;
  std::vector<std::size_t> list;
  for (std::size_t i = 0; i < n; ++i)
    list.push_back(begin + i * step);
  return list;
}

/** For each node itself, or the one that it is a copy of. */
std::vector<std::size_t> originals(const SurfaceDiscretization &surface)
{
  std::vector<std::size_t> original(surface.n_nodes);
  std::iota(original.begin(), original.end(), std::size_t(0));
  for (const auto &[copy, of] : surface.twins)
    original[copy] = of;
  return original;
}
} // namespace

SurfaceCells surface_cells(const SurfaceDiscretization &surface, const std::vector<std::size_t> &cells,
                           const std::size_t first_node)
{
  PELLICLE_ASSERT(surface.kind == SurfaceDiscretization::Kind::surface, "contact is between surfaces in space");
  std::vector<std::size_t> list = cells;
  if (list.empty())
  {
    list.resize(surface.n_cells);
    std::iota(list.begin(), list.end(), std::size_t(0));
  }
  SurfaceCells result;
  result.degree                           = surface.degree;
  const std::size_t n_local               = result.n_local();
  const std::vector<std::size_t> original = originals(surface);
  const auto local                        = [&](const std::size_t c, const std::size_t i)
  { return surface.cell_nodes[list[c] * n_local + i]; };
  const auto original_side = [&](const std::size_t c, const unsigned int side)
  {
    std::vector<std::size_t> key;
    for (const std::size_t i : side_nodes(side, surface.degree))
      key.push_back(original[local(c, i)]);
    std::sort(key.begin(), key.end());
    return key;
  };

  std::map<std::vector<std::size_t>, unsigned int> count;
  for (std::size_t c = 0; c < list.size(); ++c)
    for (unsigned int side = 0; side < 4; ++side)
      ++count[original_side(c, side)];

  const IrregularSides irregular(surface);
  std::set<std::size_t> rim_nodes;
  for (std::size_t c = 0; c < list.size(); ++c)
  {
    std::array<bool, 4> rim{};
    for (unsigned int side = 0; side < 4; ++side)
    {
      const std::vector<std::size_t> key = original_side(c, side);
      rim[side]                          = count[key] == 1 && !irregular.contains({list[c], side});
      if (rim[side])
        rim_nodes.insert(key.begin(), key.end());
    }
    result.rim_side.push_back(rim);
    for (std::size_t i = 0; i < n_local; ++i)
      result.cell_nodes.push_back(first_node + local(c, i));
  }
  const std::size_t k = surface.degree;
  for (std::size_t c = 0; c < list.size(); ++c)
  {
    std::array<bool, 4> rim{};
    for (unsigned int v = 0; v < 4; ++v)
      rim[v] = rim_nodes.count(original[local(c, (v % 2) * k + (v / 2) * k * (k + 1))]) > 0;
    result.rim_vertex.push_back(rim);
  }
  return result;
}
} // namespace pellicle

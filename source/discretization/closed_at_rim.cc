// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/closed_at_rim.h>

#include <cmath>
#include <limits>
#include <vector>

namespace pellicle
{
namespace
{
constexpr double same_place = 1e-8; // relative to the distance from the origin of coordinates

/** Numbers of the lower surface's nodes in the joined one: those on the rim are the upper surface's. */
std::vector<std::size_t> numbers_of_lower(const SurfaceDiscretization &upper, const SurfaceDiscretization &lower)
{
  constexpr std::size_t unknown = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> number(lower.n_nodes, unknown);
  for (const std::size_t node : lower.edges.front().cell_nodes)
  {
    double best = std::numeric_limits<double>::infinity(), size = 0.;
    for (const std::size_t candidate : upper.edges.front().cell_nodes)
    {
      double distance = 0.;
      for (unsigned int c = 0; c < 3; ++c)
        distance += std::pow(upper.positions[3 * candidate + c] - lower.positions[3 * node + c], 2);
      if (distance < best)
      {
        best         = distance;
        number[node] = candidate;
      }
    }
    for (unsigned int c = 0; c < 3; ++c)
      size += std::pow(lower.positions[3 * node + c], 2);
    PELLICLE_ASSERT(std::sqrt(best) <= same_place * std::sqrt(size), "the rims of two surfaces do not match");
  }
  std::size_t next = upper.n_nodes;
  for (std::size_t &n : number)
    if (n == unknown)
      n = next++;
  return number;
}

/** Local node at the place of local node i after the cell's orientation was turned round. */
std::size_t turned_round(const SurfaceDiscretization &surface, const std::size_t i)
{
  const std::size_t n = surface.degree + 1;
  return surface.kind == SurfaceDiscretization::Kind::meridian ? n - 1 - i : (i % n) * n + i / n;
}
} // namespace

SurfaceDiscretization closed_at_rim(const SurfaceDiscretization &upper, const SurfaceDiscretization &lower,
                                    const std::string &upper_name, const std::string &lower_name)
{
  PELLICLE_ASSERT(upper.edges.size() == 1 && lower.edges.size() == 1 && upper.degree == lower.degree &&
                      upper.kind == lower.kind,
                  "two open surfaces of one kind with one rim each");
  const bool meridian                   = upper.kind == SurfaceDiscretization::Kind::meridian;
  SurfaceDiscretization result          = upper;
  const std::vector<std::size_t> number = numbers_of_lower(upper, lower);
  for (std::size_t I = 0; I < lower.n_nodes; ++I)
    if (number[I] >= upper.n_nodes)
    {
      result.positions.insert(result.positions.end(), lower.positions.begin() + 3 * static_cast<std::ptrdiff_t>(I),
                              lower.positions.begin() + 3 * static_cast<std::ptrdiff_t>(I) + 3);
      if (!upper.admissible.empty())
        result.admissible.push_back(lower.admissible[I]);
    }
  result.n_nodes = result.positions.size() / 3;
  for (std::size_t c = 0; c < lower.n_cells; ++c)
  {
    // A meridian goes on where the upper one ends.
    const std::size_t cell = meridian ? lower.n_cells - 1 - c : c;
    for (std::size_t i = 0; i < lower.n_local(); ++i)
      result.cell_nodes.push_back(number[lower.cell_nodes[cell * lower.n_local() + turned_round(lower, i)]]);
  }
  result.n_cells = upper.n_cells + lower.n_cells;
  result.cell_region.assign(upper.n_cells, 0);
  result.cell_region.resize(result.n_cells, 1);
  result.region_names         = {upper_name, lower_name};
  result.edges.front().is_rim = false;
  result.mesh_reference       = result.positions;
  return result;
}
} // namespace pellicle

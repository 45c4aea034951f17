// SPDX-License-Identifier: LGPL-2.1-or-later
#include "joined_at_line.h"

#include <pellicle/base/exceptions.h>

#include <cmath>
#include <limits>

namespace pellicle
{
namespace
{
constexpr double same_place = 1e-8; // relative to the distance from the origin of coordinates

/** Numbers of the second surface's nodes in the joined one: those on the rim are the first surface's. */
std::vector<std::size_t> joined_numbers(const SurfaceDiscretization &first, const EdgeLoop &line,
                                        const SurfaceDiscretization &second, const EdgeLoop &rim)
{
  constexpr std::size_t unknown = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> number(second.n_nodes, unknown);
  for (const std::size_t node : rim.cell_nodes)
  {
    double best = std::numeric_limits<double>::infinity(), size = 0.;
    for (const std::size_t candidate : line.cell_nodes)
    {
      double distance = 0.;
      for (unsigned int c = 0; c < 3; ++c)
        distance += std::pow(first.positions[3 * candidate + c] - second.positions[3 * node + c], 2);
      if (distance < best)
      {
        best         = distance;
        number[node] = candidate;
      }
    }
    for (unsigned int c = 0; c < 3; ++c)
      size += std::pow(second.positions[3 * node + c], 2);
    PELLICLE_ASSERT(std::sqrt(best) <= same_place * std::sqrt(size), "the rims of two surfaces do not match");
  }
  std::size_t next = first.n_nodes;
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
/** Of a meridian, whose parts are patches one after the other; in space the cells of both sides of the line would have
 * to be cut together. */
void append_places(SurfaceDiscretization &first, const SurfaceDiscretization &second, const bool turned)
{
  if (first.kind != SurfaceDiscretization::Kind::meridian)
  {
    first.cell_places.clear();
    return;
  }
  const unsigned int patch = first.cell_places.back().patch + 1;
  for (std::size_t c = 0; c < second.n_cells; ++c)
  {
    CellPlace place = second.cell_places[turned ? second.n_cells - 1 - c : c];
    place.patch += patch;
    if (turned)
      place.u0 = 1. - place.u0 - place.size;
    first.cell_places.push_back(place);
  }
}
} // namespace

std::vector<std::size_t> append_at_line(SurfaceDiscretization &first, const EdgeLoop &line,
                                        const SurfaceDiscretization &second, const EdgeLoop &rim, const JoinedSide side)
{
  PELLICLE_ASSERT(first.degree == second.degree && first.kind == second.kind, "two surfaces of one kind and degree");
  const bool meridian = first.kind == SurfaceDiscretization::Kind::meridian, turned = side == JoinedSide::turned_round;
  const std::vector<std::size_t> number = joined_numbers(first, line, second, rim);
  const std::size_t n_before            = first.n_nodes;
  for (std::size_t I = 0; I < second.n_nodes; ++I)
    if (number[I] >= n_before)
    {
      first.positions.insert(first.positions.end(), second.positions.begin() + 3 * static_cast<std::ptrdiff_t>(I),
                             second.positions.begin() + 3 * static_cast<std::ptrdiff_t>(I) + 3);
      if (!first.admissible.empty())
        first.admissible.push_back(second.admissible[I]);
    }
  first.n_nodes = first.positions.size() / 3;
  for (std::size_t c = 0; c < second.n_cells; ++c)
  {
    const std::size_t cell = meridian && turned ? second.n_cells - 1 - c : c;
    for (std::size_t i = 0; i < second.n_local(); ++i)
      first.cell_nodes.push_back(
          number[second.cell_nodes[cell * second.n_local() + (turned ? turned_round(second, i) : i)]]);
  }
  first.n_cells += second.n_cells;
  append_places(first, second, turned);
  first.mesh_reference = first.positions;
  return number;
}
} // namespace pellicle

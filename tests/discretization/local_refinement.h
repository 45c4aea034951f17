// SPDX-License-Identifier: LGPL-2.1-or-later
// Meshes that are refined in places, and what must hold where cells of different sizes meet.
#pragma once

#include <pellicle/discretization/edge_loops.h>
#include <pellicle/discretization/hanging_nodes.h>
#include <pellicle/discretization/lagrange_line.h>
#include <pellicle/discretization/refinement.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <vector>

namespace pellicle::test
{
/** Places of the cells whose middle is where it is wanted. */
inline std::vector<CellPlace> cells_where(const SurfaceDiscretization &mesh,
                                          const std::function<bool(const Vector3<double> &)> &wanted)
{
  std::vector<CellPlace> places;
  for (std::size_t cell = 0; cell < mesh.n_cells; ++cell)
  {
    Vector3<double> x;
    for (std::size_t i = 0; i < mesh.n_local(); ++i)
      for (unsigned int c = 0; c < 3; ++c)
        x[c] += mesh.positions[3 * mesh.cell_nodes[cell * mesh.n_local() + i] + c] / mesh.n_local();
    if (wanted(x))
      places.push_back(mesh.cell_places[cell]);
  }
  return places;
}

/** Largest distance of the two polynomials at edges where cells of different sizes meet; infinite where an edge has no
 * large cell on its other side. */
inline double largest_crack(const SurfaceDiscretization &mesh, const NodalVectors &values)
{
  const std::size_t k           = mesh.degree;
  const std::vector<bool> hangs = hanging_flags(mesh);
  const IrregularSides irregular(mesh);
  std::vector<CellSide> small, large;
  for (std::size_t cell = 0; cell < mesh.n_cells; ++cell)
    for (unsigned int side = 0; side < 4; ++side)
      if (irregular.contains({cell, side}))
        (hangs[side_node(mesh, {cell, side}, 1)] ? small : large).push_back({cell, side});
  const LagrangeLine line(mesh.degree);
  const auto at = [&](const CellSide &side, const double s)
  {
    const LagrangeLine::Values N = line.at(s);
    Vector3<double> x;
    for (std::size_t i = 0; i <= k; ++i)
      for (unsigned int c = 0; c < 3; ++c)
        x[c] += N[0][i] * values[3 * side_node(mesh, side, i) + c];
    return x;
  };
  double crack = large.empty() && !mesh.hanging.empty() ? std::numeric_limits<double>::infinity() : 0.;
  for (const CellSide &side : small)
  {
    // Neighbours walk their common edge in opposite directions; the end that does not hang is common.
    const bool first_half = hangs[side_node(mesh, side, 0)];
    double nearest        = std::numeric_limits<double>::infinity();
    for (const CellSide &other : large)
      if (side_node(mesh, other, first_half ? 0 : k) == side_node(mesh, side, first_half ? k : 0))
      {
        double distance = 0.;
        for (const double s : {0., 0.13, 0.5, 0.77, 1.})
          distance = std::max(distance, norm(at(side, s) - at(other, 0.5 * ((first_half ? 1. : 2.) - s))));
        nearest = std::min(nearest, distance);
      }
    crack = std::max(crack, nearest);
  }
  return crack;
}

/** Whether every cell of the second mesh lies in one of the first. */
inline bool is_nested(const SurfaceDiscretization &coarse, const SurfaceDiscretization &fine)
{
  return std::all_of(fine.cell_places.begin(), fine.cell_places.end(),
                     [&](const CellPlace &inner)
                     {
                       return std::any_of(coarse.cell_places.begin(), coarse.cell_places.end(),
                                          [&](const CellPlace &outer) { return is_part_of(inner, outer); });
                     });
}

} // namespace pellicle::test

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ridge_plan.h"
#include "turned.h"

#include <pellicle/base/exceptions.h>

#include <cmath>

namespace pellicle
{
namespace
{
/** Column and row of the vertex of the core's boundary on plane `sector`, counterclockwise from the middle of the right
 * side, in a grid of n x n cells. */
std::array<unsigned int, 2> on_core_boundary(const unsigned int sector, const unsigned int n)
{
  const unsigned int along = sector + n / 2, side = along / n % 4, step = along % n;
  switch (side)
  {
  case 0:
    return {{n, step}};
  case 1:
    return {{n - step, n}};
  case 2:
    return {{0, n - step}};
  default:
    return {{step, 0}};
  }
}
} // namespace

RidgePlan::RidgePlan(const unsigned int around, const unsigned int rings, const bool half)
    : n_around(around)
    , n_core(around / 4)
    , n_core_rows(half ? n_core / 2 : n_core)
    , n_sectors(half ? around / 2 : around)
    , n_rings(rings)
{
  PELLICLE_ASSERT(around % 8 == 0 && around > 0, "a plan has a multiple of 8 cells around");
  const unsigned int first_row = n_core - n_core_rows, width = n_core + 1;
  const auto in_core = [&](const unsigned int i, const unsigned int j) { return (j - first_row) * width + i; };
  const unsigned int n_in_core = width * (n_core_rows + 1), n_on_ring = half ? n_sectors + 1 : n_sectors;
  const auto on_ring = [&](const unsigned int ring, const unsigned int sector)
  {
    if (ring > 0)
      return n_in_core + (ring - 1) * n_on_ring + sector % n_around;
    const auto [i, j] = on_core_boundary(sector, n_core);
    return in_core(i, j);
  };
  for (unsigned int j = first_row; j < n_core; ++j)
    for (unsigned int i = 0; i < n_core; ++i)
      quads.push_back({{in_core(i, j), in_core(i + 1, j), in_core(i, j + 1), in_core(i + 1, j + 1)}});
  for (unsigned int ring = 0; ring < n_rings; ++ring)
    for (unsigned int s = 0; s < n_sectors; ++s)
      quads.push_back({{on_ring(ring, s), on_ring(ring + 1, s), on_ring(ring, s + 1), on_ring(ring + 1, s + 1)}});
  n_vertices = n_in_core + n_rings * n_on_ring;
}

double RidgePlan::core_outline(const double azimuth_over_pi)
{
  const double quarter = 2. * azimuth_over_pi, t = 2. * (quarter - std::round(quarter));
  return 1. + .2 * (t * t - 1. / 3.);
}

Vector3<double> RidgePlan::at(const unsigned int patch, const double u, const double v, const Outline &outline) const
{
  const unsigned int n_in_core = n_core * n_core_rows;
  if (patch >= n_in_core)
  {
    const unsigned int ring = (patch - n_in_core) / n_sectors, sector = (patch - n_in_core) % n_sectors;
    const double azimuth = 2. * (sector + v) / n_around;
    return turned(outline(ring + u, azimuth), azimuth, 0.);
  }
  // Coons patch over the whole core, X and Y in [-1, 1]: its sides are the right one turned by quarters, so that most
  // terms cancel.
  const double X              = 2. * (patch % n_core + u) / n_core - 1.,
               Y              = 2. * (patch / n_core + (n_core - n_core_rows) + v) / n_core - 1.;
  const auto side             = [&](const double t) { return turned(outline(0., .25 * t), .25 * t, 0.); };
  const Vector3<double> right = side(Y), top = side(X);
  const double corner = side(1.)[0];
  return {X * (right[0] - corner) + top[1], Y * (top[0] - corner) + right[1], 0.};
}

SurfaceDiscretization RidgePlan::place(const Outline &outline, const unsigned int degree) const
{
  const auto point = [&](const unsigned int patch, const double u, const double v) { return at(patch, u, v, outline); };
  const RefinedQuads mesh = refine_quads(corner_points(quads, n_vertices, point), quads, 0, degree);
  for (std::size_t cell = 0; cell < mesh.n_cells; ++cell)
    PELLICLE_ASSERT(mesh.cell_places[cell].patch == cell, "cells that are not refined keep their order");
  SurfaceDiscretization result = place_nodes(mesh, quads, degree, point);
  result.rigid_motions.clear();
  return result;
}

std::vector<int> RidgePlan::ring_of_cell() const
{
  std::vector<int> rings(std::size_t(n_core) * n_core_rows, -1);
  for (unsigned int ring = 0; ring < n_rings; ++ring)
    rings.insert(rings.end(), n_sectors, static_cast<int>(ring));
  return rings;
}
} // namespace pellicle

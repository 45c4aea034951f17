// SPDX-License-Identifier: LGPL-2.1-or-later
#include "joined_at_line.h"

#include <pellicle/base/constants.h>
#include <pellicle/discretization/builders.h>
#include <pellicle/discretization/closed_at_rim.h>
#include <pellicle/discretization/liquid_lens.h>

#include <algorithm>
#include <cmath>

namespace pellicle
{
namespace
{
/** Cap over a circle of the given radius. */
SurfaceDiscretization cap_over(const double radius, const double angle, const unsigned int degree,
                               const unsigned int refinements, const bool axial)
{
  return cap(angle, pi * std::pow(radius / std::cos(0.5 * angle), 2), degree, refinements, axial);
}

void mirror_at_plane(SurfaceDiscretization &surface)
{
  for (std::size_t I = 0; I < surface.n_nodes; ++I)
    surface.positions[3 * I + 2] *= -1.;
}

AnnulusShape outer_shape(const LensShape &shape, const unsigned int refinements)
{
  AnnulusShape outer;
  outer.inner_radius  = shape.radius;
  outer.outer_radius  = shape.outer_radius;
  outer.n_radial      = 4;
  const double equal  = (shape.outer_radius - shape.radius) / std::ldexp(4., static_cast<int>(refinements)),
               of_cap = shape.upper_angle * shape.radius / std::sin(shape.upper_angle) /
                        std::ldexp(2., static_cast<int>(refinements));
  outer.smallest = of_cap < equal ? of_cap : 0.;
  return outer;
}

/** The edge loop with its nodes and cells numbered as in the joined surface. */
EdgeLoop renumbered(EdgeLoop loop, const std::vector<std::size_t> &number, const std::size_t first_cell)
{
  for (std::size_t &node : loop.cell_nodes)
    node = number[node];
  for (CellSide &side : loop.sides)
    side.cell += first_cell;
  return loop;
}
} // namespace

SurfaceDiscretization liquid_lens(const LensShape &shape, const unsigned int degree, const unsigned int refinements,
                                  const bool axial)
{
  const SurfaceDiscretization upper = cap_over(shape.radius, shape.upper_angle, degree, refinements, axial),
                              outer = annulus(outer_shape(shape, refinements), degree, refinements, axial);
  SurfaceDiscretization lower       = cap_over(shape.radius, shape.lower_angle, degree, refinements, axial);
  mirror_at_plane(lower);
  SurfaceDiscretization result = closed_at_rim(upper, lower, lens_upper_region, lens_lower_region);
  const std::size_t n_of_caps  = result.n_cells;
  const auto inner             = std::find_if(outer.edges.begin(), outer.edges.end(),
                                              [](const EdgeLoop &loop) { return loop.name == "tip"; }),
             rim               = std::find_if(outer.edges.begin(), outer.edges.end(),
                                              [](const EdgeLoop &loop) { return loop.name == "ring"; });
  const std::vector<std::size_t> number =
      append_at_line(result, EdgeLoop(result.edges.front()), outer, *inner, JoinedSide::as_it_is);
  result.region_names.emplace_back(lens_outer_region);
  result.cell_region.resize(result.n_cells, 2);
  result.edges.front().name        = lens_line;
  result.edges.front().is_junction = true;
  result.edges.push_back(renumbered(*rim, number, n_of_caps));
  result.edges.back().name = lens_rim;
  result.rigid_motions.clear();
  return result;
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "body_degree.h"
#include "meridian_line.h"
#include "ridge_fan.h"
#include "ridge_lines.h"

#include <pellicle/discretization/bodies.h>
#include <pellicle/discretization/edge_loops.h>
#include <pellicle/potentials/wetting/droplet_targets.h>
#include <pellicle/potentials/wetting/ridge_targets.h>

#include <algorithm>
#include <utility>

namespace pellicle
{
namespace
{
constexpr unsigned int highest_degree = 5;

/** Meridian of the cap from the pole to the ring. The drop is smooth up to the line: its cells need not be as small. */
SurfaceDiscretization cap_meridian(const RidgeShape &shape)
{
  constexpr double relative_size = 2., coarsest = .1;
  const CapOutline cap(shape);
  const double arc = cap.arc(), largest = coarsest * shape.ring_radius;
  const std::vector<double> ends =
      graded_ends(arc, std::min(relative_size * shape.cell_size, largest), shape.growth, coarsest, largest);
  const std::size_t n_cells    = ends.size() - 1;
  SurfaceDiscretization result = meridian_line(shape.degree, n_cells, {}, false,
                                               [&](const double t)
                                               {
                                                 // Within a cell at constant speed.
                                                 const std::size_t cell = std::min(n_cells - 1, std::size_t(t));
                                                 const double from      = ends[n_cells - cell],
                                                              to        = ends[n_cells - cell - 1];
                                                 const double left      = from + (t - double(cell)) * (to - from);
                                                 const auto [r, z]      = cap.at(1. - left / arc);
                                                 return Vector3<double>(r, 0., z);
                                               });
  put_on_axis(result, 0);
  return result;
}
} // namespace

SurfaceDiscretization axial_ridge(const RidgeShape &shape)
{
  check_ridge(shape);
  check_body_degree(shape.degree, highest_degree);
  const double a = shape.ring_radius;
  const RidgeFan fan(shape, a);
  CylinderShape lines               = {downwards(a, graded_ends(a, shape.cell_size, shape)), fan.column()};
  const std::size_t n_wetted        = lines.r.size() - 1;
  const std::vector<double> outside = graded_ends(shape.half_width - a, shape.cell_size, shape);
  for (std::size_t i = 1; i + 1 < outside.size(); ++i)
    lines.r.push_back(a + outside[i]);
  lines.r.push_back(shape.half_width);
  SurfaceDiscretization result = cylinder(substrate_body, lines, shape.degree);
  for (std::size_t I = 0; I < result.n_nodes; ++I) // upwards, column by column
    result.positions[3 * I + 2] = fan.height(I % fan.n_levels(), result.positions[3 * I]);
  result.tables               = make_meridian_tables(shape.degree, substrate_points(shape.degree), false);
  result.bulks.front().tables = make_revolved_quad_tables(shape.degree, substrate_points(shape.degree));

  const std::vector<std::size_t> top = std::move(result.cell_nodes);
  const std::size_t n_local = result.n_local(), ring = top[n_wetted * n_local];
  SurfaceDiscretization cap = cap_meridian(shape);
  // The cap's last node is the ring.
  result.cell_nodes.clear();
  for (const std::size_t node : cap.cell_nodes)
    result.cell_nodes.push_back(node + 1 == cap.n_nodes ? ring : result.n_nodes + node);
  result.positions.insert(result.positions.end(), cap.positions.begin(), cap.positions.end() - 3);
  result.admissible.insert(result.admissible.end(), cap.admissible.begin(), cap.admissible.end() - 1);
  result.n_nodes += cap.n_nodes - 1;
  result.cell_nodes.insert(result.cell_nodes.end(), top.rend() - static_cast<std::ptrdiff_t>(n_wetted * n_local),
                           top.rend()); // from the ring to the axis
  result.cell_nodes.insert(result.cell_nodes.end(), top.begin() + static_cast<std::ptrdiff_t>(n_wetted * n_local),
                           top.end());

  result.cell_region.assign(cap.n_cells, 0);
  result.cell_region.resize(cap.n_cells + n_wetted, 1);
  result.n_cells = cap.n_cells + lines.r.size() - 1;
  result.cell_region.resize(result.n_cells, 2);
  result.cell_places.clear();
  result.region_names              = {liquid_gas_region, solid_liquid_region, solid_gas_region};
  result.edges                     = {circle_loop(result, contact_line, cap.n_cells - 1, true, false)};
  result.edges.front().is_junction = true;
  result.mesh_reference            = result.positions;
  return result;
}
} // namespace pellicle

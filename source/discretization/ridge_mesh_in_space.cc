// SPDX-License-Identifier: LGPL-2.1-or-later
#include "body_degree.h"
#include "ridge_fan.h"
#include "ridge_lines.h"
#include "ridge_parts.h"

#include <pellicle/base/constants.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/bodies.h>
#include <pellicle/discretization/edge_loops.h>
#include <pellicle/discretization/refined_quads.h>
#include <pellicle/potentials/wetting/droplet_targets.h>
#include <pellicle/potentials/wetting/ridge_targets.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>

namespace pellicle
{
namespace
{
constexpr unsigned int highest_degree = 3;
constexpr double way_to_core          = .68;  ///< from the contact line to all cells around the axis, over its radius
constexpr double same_place           = 1e-9; ///< relative

/** Nodes on the contact line, counterclockwise. */
std::vector<std::size_t> ring_nodes(const SurfaceDiscretization &surface, const double ring_radius)
{
  std::map<double, std::size_t> nodes;
  for (std::size_t I = 0; I < surface.n_nodes; ++I)
  {
    const double *const x = surface.positions.data() + 3 * I;
    if (std::abs(std::hypot(x[0], x[1]) - ring_radius) + std::abs(x[2]) > same_place * ring_radius)
      continue;
    const double azimuth                                       = std::atan2(x[1], x[0]);
    nodes[azimuth < -same_place ? azimuth + 2. * pi : azimuth] = I;
  }
  std::vector<std::size_t> result;
  for (const auto &[azimuth, node] : nodes)
    result.push_back(node);
  return result;
}

/** Extrudes the top downwards: nodes of level k are those of the top plus k times as many, the last level being the
 * top. */
BulkPart extruded(const SurfaceDiscretization &top, const RidgeFan &fan)
{
  BulkPart body;
  body.name   = substrate_body;
  body.tables = make_hexahedron_tables(top.degree, substrate_points(top.degree));
  for (std::size_t layer = 0; layer + 1 < fan.n_levels(); layer += top.degree)
    for (std::size_t cell = 0; cell < top.n_cells; ++cell, ++body.n_cells)
      for (std::size_t k = 0; k <= top.degree; ++k)
        for (std::size_t s = 0; s < top.n_local(); ++s)
          body.cell_nodes.push_back((layer + k) * top.n_nodes + top.cell_nodes[cell * top.n_local() + s]);
  return body;
}

/** Nodes at all levels below those of the top. */
NodalVectors stacked(const NodalVectors &top, const RidgeFan &fan)
{
  NodalVectors positions;
  for (std::size_t level = 0; level < fan.n_levels(); ++level)
    for (std::size_t I = 0; I < top.size(); I += 3)
      positions.insert(positions.end(), {top[I], top[I + 1], fan.height(level, std::hypot(top[I], top[I + 1]))});
  return positions;
}

void name_faces(const RidgeShape &shape, const RidgePlanShape &plan, const NodalVectors &positions, BulkPart &body)
{
  const double reach = shape.half_width * (1. - same_place);
  const bool block   = plan.outline == RidgePlanShape::Outline::block;
  for (std::size_t I = 0; 3 * I < positions.size(); ++I)
  {
    const double x = positions[3 * I], y = positions[3 * I + 1], z = positions[3 * I + 2];
    const std::pair<const char *, bool> faces[] = {
        {"left", block && x < -reach},
        {"right", block && x > reach},
        {"front", block && y < -reach},
        {"back", block && y > reach},
        {"side", (block ? std::max(std::abs(x), std::abs(y)) : std::hypot(x, y)) > reach},
        {"bottom", z == -shape.thickness},
        {"top", z == 0.}};
    for (const auto &[name, is_on_it] : faces)
      if (is_on_it)
        body.faces[name].push_back(I);
  }
}

/** Adds the cells of a part of the top to the surface, turned round where they are within the contact line. */
void add_cells(const SurfacePart &top, const bool within, const std::size_t first_node, SurfaceDiscretization &result)
{
  const std::size_t n = top.surface.degree + 1;
  for (std::size_t cell = 0; cell < top.surface.n_cells; ++cell)
  {
    if (top.within[cell] != within)
      continue;
    for (std::size_t i = 0; i < n * n; ++i)
    {
      const std::size_t local = within ? i % n * n + i / n : i;
      result.cell_nodes.push_back(first_node + top.surface.cell_nodes[cell * n * n + local]);
    }
    result.cell_region.push_back(within ? 1 : 2);
    ++result.n_cells;
  }
}

void count_twice(SurfaceDiscretization &ridge)
{
  for (ShapeTables *const tables : {&ridge.tables, &ridge.edges.front().tables, &ridge.bulks.front().tables})
    for (double &weight : tables->weights)
      weight *= 2.;
}

void check_plan(const RidgeShape &shape, const RidgePlanShape &plan)
{
  check_ridge(shape);
  check_body_degree(shape.degree, highest_degree);
  if (plan.n_around < 8 || plan.n_around > 512 || plan.n_around % 8 != 0)
    throw UserError("Cells around the contact line = " + std::to_string(plan.n_around) +
                    ": it must be a multiple of 8 between 8 and 512.");
}
} // namespace

SurfaceDiscretization ridge_in_space(const RidgeShape &shape, const RidgePlanShape &plan)
{
  check_plan(shape, plan);
  const SurfacePart top = ridge_top(shape, plan);
  const RidgeFan fan(shape, way_to_core * shape.ring_radius);
  SurfaceDiscretization result    = ridge_cap(shape, plan); // for its loop; nodes of the body come first
  result.tables                   = make_surface_tables(shape.degree, substrate_points(shape.degree));
  const SurfaceDiscretization cap = result;

  BulkPart body                  = extruded(top.surface, fan);
  result.positions               = stacked(top.surface.positions, fan);
  const std::size_t first_on_top = result.positions.size() / 3 - top.surface.n_nodes;
  name_faces(shape, plan, result.positions, body);
  result.bulks.push_back(std::move(body));

  const std::vector<std::size_t> on_cap = ring_nodes(cap, shape.ring_radius),
                                 on_top = ring_nodes(top.surface, shape.ring_radius);
  PELLICLE_ASSERT(on_cap.size() == on_top.size(), "cap and substrate have the same nodes on the contact line");
  std::vector<std::size_t> number(cap.n_nodes, std::numeric_limits<std::size_t>::max());
  for (std::size_t i = 0; i < on_cap.size(); ++i)
    number[on_cap[i]] = first_on_top + on_top[i];
  for (std::size_t I = 0; I < cap.n_nodes; ++I)
    if (number[I] == std::numeric_limits<std::size_t>::max())
    {
      number[I] = result.positions.size() / 3;
      result.positions.insert(result.positions.end(), cap.positions.begin() + 3 * static_cast<std::ptrdiff_t>(I),
                              cap.positions.begin() + 3 * static_cast<std::ptrdiff_t>(I) + 3);
    }
  for (std::size_t &node : result.cell_nodes)
    node = number[node];
  result.n_nodes = result.positions.size() / 3;
  result.cell_region.assign(cap.n_cells, 0);
  add_cells(top, true, first_on_top, result);
  add_cells(top, false, first_on_top, result);
  result.region_names              = {liquid_gas_region, solid_liquid_region, solid_gas_region};
  result.mesh_reference            = result.positions;
  result.edges                     = find_region_boundary(result, 0, contact_line);
  result.edges.front().is_junction = true;

  if (plan.half)
  {
    std::vector<std::size_t> in_plane;
    for (std::size_t I = 0; I < result.n_nodes; ++I)
      if (result.positions[3 * I + 1] == 0.)
        in_plane.push_back(I);
    keep_on_plane(result, in_plane, {0., 1., 0.});
    count_twice(result);
  }
  return result;
}
} // namespace pellicle

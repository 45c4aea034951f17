// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ridge_lines.h"
#include "ridge_plan.h"
#include "turned.h"

#include <pellicle/base/constants.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/bodies.h>
#include <pellicle/discretization/edge_loops.h>
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
constexpr double core_radius          = .28; ///< mean, over the ring's
constexpr double round_part           = .3;  ///< of the way from the ring to the sides of a block: rings are circles
constexpr double same_place           = 1e-9;

/** Value of a piecewise linear function of t, whole numbers being its corners. */
double along(const std::vector<double> &corners, const double t)
{
  const std::size_t i = std::min(corners.size() - 2, static_cast<std::size_t>(t));
  const double f      = t - static_cast<double>(i);
  return (1. - f) * corners[i] + f * corners[i + 1];
}

/** Distance from the axis within the contact line: the rings' lines are circles but for the innermost, the core's. */
double radius_within(const std::vector<double> &radii, const double ring, const double azimuth_over_pi)
{
  const double core = std::max(0., 1. - ring) * radii.front();
  return along(radii, ring) + core * (RidgePlan::core_outline(azimuth_over_pi) - 1.);
}

/** Distance from the axis to the sides of the square of half width 1. */
double to_square(const double azimuth_over_pi)
{
  const Vector3<double> direction = turned(1., azimuth_over_pi, 0.);
  return 1. / std::max(std::abs(direction[0]), std::abs(direction[1]));
}

/** A surface seen from above: whether cells are within the contact line. */
struct SurfacePart
{
  SurfaceDiscretization surface;
  std::vector<bool> within;
};

/** The substrate's top, in z = 0. */
SurfacePart make_top(const RidgeShape &shape, const RidgePlanShape &plan)
{
  const double a                   = shape.ring_radius;
  std::vector<double> radii        = downwards(a, graded_ends((1. - core_radius) * a, shape.cell_size, shape));
  const std::size_t n_within       = radii.size() - 1;
  const std::vector<double> beyond = graded_ends(shape.half_width - a, shape.cell_size, shape);
  for (auto end = beyond.begin() + 1; end != beyond.end(); ++end)
    radii.push_back(a + *end);
  radii.back() = shape.half_width;

  // Beyond the last circle, lines go over to the square.
  const double last_circle =
      a + *std::lower_bound(beyond.begin(), beyond.end() - 2, round_part * (shape.half_width - a));
  const bool square  = plan.outline == RidgePlanShape::Outline::block;
  const auto outline = [&](const double ring, const double azimuth_over_pi)
  {
    const double circle = radius_within(radii, ring, azimuth_over_pi);
    const double excess = square ? shape.half_width * (to_square(azimuth_over_pi) - 1.) : 0.;
    return circle + std::max(0., circle - last_circle) / (shape.half_width - last_circle) * excess;
  };
  const RidgePlan rings(plan.n_around, static_cast<unsigned int>(radii.size() - 1), plan.half);
  SurfacePart top{rings.place(outline, shape.degree), {}};
  for (const int ring : rings.ring_of_cell())
    top.within.push_back(ring < static_cast<int>(n_within));
  return top;
}

/** The spherical cap: a disc whose distances from the axis become polar angles. The drop is smooth up to the line: its
 * cells need not be as small there as the substrate's. */
SurfaceDiscretization make_cap(const RidgeShape &shape, const RidgePlanShape &plan)
{
  constexpr double relative_size = 4.;
  const CapOutline cap(shape);
  const double stretch = cap.arc() / shape.ring_radius, largest = shape.coarsest * std::min(1., 1. / cap.angle());
  const double size = std::min(relative_size * shape.cell_size / (shape.ring_radius * stretch), largest);
  const std::vector<double> radii =
      downwards(1., graded_ends(1. - core_radius, size, shape.growth, shape.coarsest, largest));
  const RidgePlan rings(plan.n_around, static_cast<unsigned int>(radii.size() - 1), plan.half);
  SurfaceDiscretization result = rings.place([&](const double ring, const double azimuth_over_pi)
                                             { return radius_within(radii, ring, azimuth_over_pi); },
                                             shape.degree);
  for (std::size_t I = 0; I < result.n_nodes; ++I)
  {
    double *const x         = result.positions.data() + 3 * I;
    const double rho        = std::hypot(x[0], x[1]);
    const auto [r, z]       = cap.at(std::abs(rho - 1.) < same_place ? 1. : rho);
    const double lengthened = rho > 0. ? r / rho : 0.;
    x[0] *= lengthened;
    x[1] *= lengthened;
    x[2] = z;
  }
  return result;
}

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

/** Extrudes the top downwards: nodes of the layer at height z[k] are those of the top plus k times as many, the last
 * layer being the top. */
BulkPart extruded(const SurfaceDiscretization &top, const std::vector<double> &heights)
{
  BulkPart body;
  body.name   = substrate_body;
  body.tables = make_hexahedron_tables(top.degree, top.degree + 1);
  for (std::size_t layer = 0; layer + 1 < heights.size(); ++layer)
    for (std::size_t cell = 0; cell < top.n_cells; ++cell, ++body.n_cells)
      for (std::size_t k = 0; k <= top.degree; ++k)
        for (std::size_t s = 0; s < top.n_local(); ++s)
          body.cell_nodes.push_back((layer * top.degree + k) * top.n_nodes + top.cell_nodes[cell * top.n_local() + s]);
  return body;
}

/** Nodes at the given heights over or under those of a plane. */
NodalVectors stacked(const NodalVectors &plane, const std::vector<double> &heights, const unsigned int degree)
{
  const std::vector<double> unit = line_nodes(degree);
  NodalVectors positions;
  const auto add_layer = [&](const double z)
  {
    for (std::size_t I = 0; I < plane.size(); I += 3)
      positions.insert(positions.end(), {plane[I], plane[I + 1], z});
  };
  for (std::size_t layer = 0; layer + 1 < heights.size(); ++layer)
    for (unsigned int k = 0; k < degree; ++k)
      add_layer(heights[layer] + .5 * (1. + unit[k]) * (heights[layer + 1] - heights[layer]));
  add_layer(heights.back());
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
  if (shape.degree < 1 || shape.degree > highest_degree)
    throw UserError("Degree = " + std::to_string(shape.degree) + ": the cells of such a body have a degree from 1 to " +
                    std::to_string(highest_degree) + ".");
  if (plan.n_around < 8 || plan.n_around > 512 || plan.n_around % 8 != 0)
    throw UserError("Cells around the contact line = " + std::to_string(plan.n_around) +
                    ": it must be a multiple of 8 between 8 and 512.");
}
} // namespace

SurfaceDiscretization ridge_in_space(const RidgeShape &shape, const RidgePlanShape &plan)
{
  check_plan(shape, plan);
  const SurfacePart top             = make_top(shape, plan);
  const std::vector<double> heights = downwards(0., graded_ends(shape.thickness, shape.cell_size, shape));
  SurfaceDiscretization result      = make_cap(shape, plan); // for its tables; nodes of the body come first
  const SurfaceDiscretization cap   = result;

  BulkPart body                  = extruded(top.surface, heights);
  result.positions               = stacked(top.surface.positions, heights, shape.degree);
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
  result.region_names   = {liquid_gas_region, solid_liquid_region, solid_gas_region};
  result.mesh_reference = result.positions;
  result.edges          = find_region_boundary(result, 0, contact_line);

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

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "graded_line.h"
#include "meridian_line.h"
#include "polar_area.h"

#include <pellicle/base/constants.h>
#include <pellicle/discretization/balanced_disc.h>
#include <pellicle/discretization/builders.h>
#include <pellicle/discretization/edge_loops.h>

#include <algorithm>
#include <cmath>

namespace pellicle
{
namespace
{
const std::vector<std::string> names = {"membrane", "domain"};
constexpr unsigned int domain        = 1;
const std::string boundary_name      = "domain boundary";

/** The sphere that the shape is a map of, scaled to the shape's area. */
double sphere_radius(const SmoothShape &shape)
{
  return std::sqrt(shape.area / (4. * pi));
}

SurfaceDiscretization region_meridian(const SmoothShape &shape, const double boundary, const unsigned int degree,
                                      const Refinement &refinement)
{
  const double scale  = std::ldexp(1., static_cast<int>(refinement.uniform));
  const double within = scale * std::clamp(std::round(4. * boundary / pi), 1., 3.), beyond = 4. * scale - within;
  // The side with the smaller cells has equal ones; those of the other side grow away from the line.
  const double rest = pi - boundary, size = std::min(boundary / within, rest / beyond);
  const GradedLine towards(boundary, within, 0., size), away(rest, beyond, size, 0.);
  const auto direction = [&](const double t)
  {
    const double polar = t <= within ? towards.at(t) : boundary + away.at(t - within);
    return sphere_point(polar, 0.);
  };
  const std::size_t n_cells = static_cast<std::size_t>(4. * scale);
  SurfaceDiscretization result =
      meridian_line(degree, n_cells, refinement.cut, false, [&](const double t) { return shape.point(direction(t)); });
  put_on_axis(result, 0);
  put_on_axis(result, result.n_nodes - 1);
  free_along_axis(result);
  result.mesh_reference = result.positions;
  if (shape.even_mesh == SmoothShape::EvenMesh::sphere)
    result.mesh_reference = meridian_line(degree, n_cells, refinement.cut, false,
                                          [&](const double t) { return sphere_radius(shape) * direction(t); })
                                .positions;

  const auto n_within = static_cast<std::size_t>(
      std::count_if(result.cell_places.begin(), result.cell_places.end(),
                    [&](const CellPlace &place) { return (place.u0 + 0.5 * place.size) * n_cells < within; }));
  result.cell_region.assign(result.n_cells, 0);
  std::fill_n(result.cell_region.begin(), n_within, domain);
  result.region_names = names;
  result.edges        = {circle_loop(result, boundary_name, n_within - 1, true, false)};
  return result;
}

/** Length of the shape's meridian between polar angles of the sphere, in eighths of the circumference passed. */
double square_cells_between(const SmoothShape &shape, const double a, const double b)
{
  constexpr unsigned int n_steps = 200;
  double cells                   = 0.;
  for (unsigned int i = 0; i < n_steps; ++i)
  {
    const auto at = [&](const double s) { return shape.point(sphere_point(a + (b - a) * s / n_steps, 0.25)); };
    const Vector3<double> middle = at(i + 0.5);
    cells += norm(at(i + 1.) - at(i)) / (pi / 4. * std::hypot(middle[0], middle[1]));
  }
  return cells;
}

/** Angle from a pole at which a disc of 12 cells ends with cells about square: where the way from the pole is 1.3 times
 * the distance from the axis (1.22 on a sphere), not beyond the equator. */
double widest_disc(const SmoothShape &shape, const bool north)
{
  constexpr double step = 0.01, longest = 1.3;
  const auto at = [&](const double angle) { return shape.point(sphere_point(north ? angle : pi - angle, 0.25)); };
  double way    = 0.;
  for (double angle = step; angle < 0.5 * pi; angle += step)
  {
    const Vector3<double> x = at(angle);
    way += norm(x - at(angle - step));
    if (way > longest * std::hypot(x[0], x[1]))
      return angle;
  }
  return 0.5 * pi;
}

/**
 * The sphere in quadrilaterals: a disc around the north pole, rings of eight, a disc around the south pole. Rings are
 * equally thick on Mercator's chart, where they are square. One circle between rings (or at a disc's rim) lies at the
 * given polar angle.
 */
class RingedSphere
{
public:
  RingedSphere(const SmoothShape &shape, const double line)
      : boundary(line)
      , north_angle(std::min(line, widest_disc(shape, true)))
      , south_angle(std::min(pi - line, widest_disc(shape, false)))
      , n_north(rounded(square_cells_between(shape, north_angle, line)))
      , n_south(rounded(square_cells_between(shape, line, pi - south_angle)))
      , north(n_north == 0 ? line : north_angle) // a disc without rings goes as far as the line
      , south(n_south == 0 ? pi - line : south_angle)
  {
  }

  std::vector<QuadVertices> quads() const
  {
    std::vector<QuadVertices> result = BalancedDisc::quads();
    for (unsigned int j = 0; j < n_rings(); ++j)
      for (unsigned int a = 0; a < 8; ++a) // first southwards, second counterclockwise
        result.push_back({{circle(j, a), circle(j + 1, a), circle(j, a + 1), circle(j + 1, a + 1)}});
    const auto turned_down = [&](const unsigned int vertex)
    { return vertex < 9 ? BalancedDisc::n_vertices + 8 * n_rings() + vertex : circle(n_rings(), 8 - (vertex - 9)); };
    for (const QuadVertices &q : BalancedDisc::quads())
      result.push_back({{turned_down(q[0]), turned_down(q[1]), turned_down(q[2]), turned_down(q[3])}});
    return result;
  }

  unsigned int n_vertices() const { return BalancedDisc::n_vertices + 8 * n_rings() + 9; }

  bool within_line(const unsigned int quad) const { return quad < BalancedDisc::n_quads + 8 * n_north; }

  Vector3<double> at(const unsigned int quad, const double u, const double v) const
  {
    if (quad < BalancedDisc::n_quads)
      return on_disc(north, quad, u, v);
    const unsigned int ring = (quad - BalancedDisc::n_quads) / 8;
    if (ring < n_rings())
      return sphere_point(ring_angle(ring, u), 0.25 * (quad - BalancedDisc::n_quads - 8 * ring + v));
    // Half a turn about the x axis.
    const Vector3<double> x = on_disc(south, quad - BalancedDisc::n_quads - 8 * n_rings(), u, v);
    return {x[0], 0. - x[1], 0. - x[2]};
  }

private:
  static unsigned int rounded(const double cells) { return static_cast<unsigned int>(std::round(cells)); }
  unsigned int n_rings() const { return n_north + n_south; }

  /** Vertex on the circle between rings; the first is the rim of the northern disc. */
  static unsigned int circle(const unsigned int j, const unsigned int eighth)
  {
    return BalancedDisc::rim_vertex(eighth) + 8 * j;
  }

  static Vector3<double> on_disc(const BalancedDisc &disc, const unsigned int quad, const double u, const double v)
  {
    const DiscPoint p  = disc.at(quad, u, v);
    const double polar = disc.rim_angle() * p.radius, sine = std::sin(polar);
    return {sine * p.cosine, sine * p.sine, std::cos(polar)};
  }

  double ring_angle(const unsigned int ring, const double u) const
  {
    const bool first = ring < n_north;
    const double a = first ? north_angle : boundary, b = first ? boundary : pi - south_angle;
    const double w = first ? (ring + u) / n_north : (ring - n_north + u) / n_south;
    return 2. * std::atan(std::pow(std::tan(0.5 * a), 1. - w) * std::pow(std::tan(0.5 * b), w));
  }

  double boundary, north_angle, south_angle;
  unsigned int n_north, n_south; ///< rings on either side of the line
  BalancedDisc north, south;
};

SurfaceDiscretization region_surface(const SmoothShape &shape, const double boundary, const unsigned int degree,
                                     const Refinement &refinement)
{
  const RingedSphere sphere(shape, boundary);
  const std::vector<QuadVertices> quads = sphere.quads();
  const auto point                      = [&](const unsigned int patch, const double u, const double v)
  { return shape.point(sphere.at(patch, u, v)); };
  std::vector<unsigned int> regions;
  for (unsigned int patch = 0; patch < quads.size(); ++patch)
    regions.push_back(sphere.within_line(patch) ? domain : 0);
  const RefinedQuads mesh =
      refine_quads(corner_points(quads, sphere.n_vertices(), point), quads, refinement, degree, regions);
  SurfaceDiscretization result = place_nodes(mesh, quads, degree, point);
  result.mesh_reference        = result.positions;
  if (shape.even_mesh == SmoothShape::EvenMesh::sphere)
    result.mesh_reference = place_nodes(mesh, quads, degree,
                                        [&](const unsigned int patch, const double u, const double v)
                                        { return sphere_radius(shape) * sphere.at(patch, u, v); })
                                .positions;

  for (const auto &[patch, u0, v0, size] : mesh.cell_places)
    result.cell_region.push_back(regions[patch]);
  result.region_names = names;
  result.edges        = find_region_boundary(result, domain, boundary_name);
  return result;
}
} // namespace

SurfaceDiscretization with_polar_region(const SmoothShape &shape, const double area_fraction, const unsigned int degree,
                                        const Refinement &refinement, const bool axial)
{
  const double boundary = polar_angle_of_area(shape, area_fraction);
  return axial ? region_meridian(shape, boundary, degree, refinement)
               : region_surface(shape, boundary, degree, refinement);
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/constants.h>
#include <pellicle/discretization/balanced_disc.h>

#include <boost/math/special_functions/cos_pi.hpp>
#include <boost/math/special_functions/sin_pi.hpp>

#include <cmath>

namespace pellicle
{
namespace
{
/// Radii of the middle of a side of the block and of its corners: cells of about equal areas, and corners that share
/// the full angle with their two outer neighbours.
constexpr double side_radius = 0.528, corner_radius = 0.641;

/** Vertices of the block are the 3 x 3 points of a grid; those on its boundary, counterclockwise from azimuth 0. */
constexpr std::array<unsigned int, 8> block_boundary{{5, 8, 7, 6, 3, 0, 1, 2}};
} // namespace

BalancedDisc::BalancedDisc(const double rim_angle)
    : angle(rim_angle)
{
  // Circle through three points: a chord 2 w and the sagitta h above it.
  const Vector3<double> top = lifted(side_radius, 0.), end = lifted(corner_radius, 0.25);
  chord_middle                  = Vector3<double>(end[0], 0., end[2]);
  const Vector3<double> sagitta = top - chord_middle;
  const double w                = end[1];
  arc_sagitta                   = norm(sagitta);
  sagitta_direction             = sagitta / arc_sagitta;
  arc_radius                    = (w * w + arc_sagitta * arc_sagitta) / (2. * arc_sagitta);
  half_arc                      = 2. * std::atan2(arc_sagitta, w);
}

std::vector<QuadVertices> BalancedDisc::quads()
{
  std::vector<QuadVertices> result;
  for (unsigned int j = 0; j < 2; ++j)
    for (unsigned int i = 0; i < 2; ++i)
      result.push_back({{3 * j + i, 3 * j + i + 1, 3 * (j + 1) + i, 3 * (j + 1) + i + 1}});
  for (unsigned int a = 0; a < 8; ++a) // first outwards, second counterclockwise
    result.push_back({{block_boundary[a], rim_vertex(a), block_boundary[(a + 1) % 8], rim_vertex(a + 1)}});
  return result;
}

Vector3<double> BalancedDisc::lifted(const double radius, const double azimuth_over_pi) const
{
  const double c = boost::math::cos_pi(azimuth_over_pi), s = boost::math::sin_pi(azimuth_over_pi);
  if (angle == 0.)
    return {radius * c, radius * s, 0.};
  const double polar = angle * radius;
  return {std::sin(polar) * c, std::sin(polar) * s, std::cos(polar)};
}

std::array<double, 2> BalancedDisc::side(const double t) const
{
  Vector3<double> x =
      chord_middle + (arc_radius * std::cos(half_arc * t) - (arc_radius - arc_sagitta)) * sagitta_direction;
  x[1] = arc_radius * std::sin(half_arc * t);
  if (angle == 0.)
    return {{x[0], x[1]}};
  const double distance = std::hypot(x[0], x[1]);
  const double factor   = std::atan2(distance, x[2]) / (angle * distance);
  return {{factor * x[0], factor * x[1]}};
}

DiscPoint BalancedDisc::at(const unsigned int quad, const double u, const double v) const
{
  if (quad < 4)
  {
    // Coons patch over the whole block: its four sides are side() turned by quarters, so that most terms cancel.
    const double X = quad % 2 + u - 1., Y = quad / 2 + v - 1.; // in [-1, 1]
    const double corner = corner_radius * std::sqrt(0.5);
    const auto right = side(Y), top = side(X);
    const double x = X * (right[0] - corner) + top[1], y = Y * (top[0] - corner) + right[1];
    const double radius = std::hypot(x, y);
    return radius > 0. ? DiscPoint{radius, x / radius, y / radius} : DiscPoint{};
  }
  // The sides of the block are centred on azimuths 0, pi/2, ...: even quads lie counterclockwise of the middle.
  const unsigned int a = quad - 4;
  const double t       = a % 2 == 0 ? v : v - 1.;
  const auto inner     = side(t);
  const double even    = 0.25 * t; // azimuths over pi, from the middle of the side
  const double azimuth =
      0.5 * ((a + 1) / 2) + even + (1. - u) * (1. - u) * (std::atan2(inner[1], inner[0]) / pi - even);
  return {(1. - u) * std::hypot(inner[0], inner[1]) + u, boost::math::cos_pi(azimuth), boost::math::sin_pi(azimuth)};
}
} // namespace pellicle

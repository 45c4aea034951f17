// SPDX-License-Identifier: LGPL-2.1-or-later
// Closed surfaces for the tests of this room, and rigid motions of them.
#pragma once

#include <pellicle/discretization/builders.h>
#include <pellicle/discretization/refined_quads.h>

#include <array>
#include <cmath>

namespace pellicle::test_shapes
{
constexpr double pi = 3.141592653589793;

inline Vector3<double> node(const NodalVectors &positions, const std::size_t I)
{
  return {positions[3 * I], positions[3 * I + 1], positions[3 * I + 2]};
}

template <typename Map>
NodalVectors moved(const NodalVectors &positions, const Map &map)
{
  NodalVectors result;
  for (std::size_t I = 0; I < positions.size() / 3; ++I)
    for (const double x : map(node(positions, I)).components)
      result.push_back(x);
  return result;
}

/** By an angle about z, then by a vector. */
inline NodalVectors turned_and_shifted(const NodalVectors &positions, const double angle, const Vector3<double> &shift)
{
  const double c = std::cos(angle), s = std::sin(angle);
  return moved(positions, [&](const Vector3<double> &x)
               { return Vector3<double>(c * x[0] - s * x[1], s * x[0] + c * x[1], x[2]) + shift; });
}

/** A quarter turn about x: y becomes z. */
inline NodalVectors tipped_over(const NodalVectors &positions)
{
  return moved(positions, [](const Vector3<double> &x) { return Vector3<double>(x[0], -x[2], x[1]); });
}

/** Weighted mean of the four unit vectors on the sphere (Buss and Fillmore, ACM Trans. Graphics 20, 95-126, 2001). */
inline Vector3<double> spherical_mean(const std::array<Vector3<double>, 4> &points,
                                      const std::array<double, 4> &weights)
{
  Vector3<double> mean;
  for (unsigned int i = 0; i < 4; ++i)
    mean += weights[i] * points[i];
  for (unsigned int iteration = 0; iteration < 20; ++iteration)
  {
    mean = mean / norm(mean);
    Vector3<double> step;
    for (unsigned int i = 0; i < 4; ++i)
    {
      const double cosine           = dot(mean, points[i]);
      const Vector3<double> tangent = points[i] - cosine * mean;
      const double sine             = norm(tangent);
      if (sine > 0.)
        step += (weights[i] * std::atan2(sine, cosine) / sine) * tangent;
    }
    mean += step;
  }
  return mean / norm(mean);
}

/**
 * The cube's cells with nodes at spherical means of each cell's own vertices, so that edges are great circles run
 * through at constant speed. The interpolation error is then along the surface to leading order, and the curvature of
 * the interpolated sphere or ellipsoid is of order k.
 */
inline SurfaceDiscretization with_geodesic_cells(const SmoothShape &shape, const unsigned int degree,
                                                 const unsigned int refinements)
{
  const NodalVectors directions    = on_cube_sphere(ellipsoid({{1., 1., 1.}}), degree, refinements).positions;
  SurfaceDiscretization result     = on_cube_sphere(shape, degree, refinements);
  const std::vector<double> points = line_nodes(degree);
  const unsigned int n             = degree + 1;
  for (std::size_t cell = 0; cell < result.n_cells; ++cell)
  {
    const std::size_t *const nodes = &result.cell_nodes[cell * n * n];
    const auto vertex              = [&](const unsigned int i) { return node(directions, nodes[i]); };
    for (unsigned int i = 0; i < n * n; ++i)
    {
      const double u = 0.5 * (1. + points[i % n]), v = 0.5 * (1. + points[i / n]);
      const auto x = shape.point(spherical_mean({{vertex(0), vertex(degree), vertex(n * degree), vertex(n * n - 1)}},
                                                {{(1. - u) * (1. - v), u * (1. - v), (1. - u) * v, u * v}}));
      for (unsigned int c = 0; c < 3; ++c)
        result.positions[3 * nodes[i] + c] = x[c];
    }
  }
  return result;
}

inline SmoothShape sphere(const double R)
{
  return ellipsoid({{R, R, R}});
}
} // namespace pellicle::test_shapes

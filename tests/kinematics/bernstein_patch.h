// SPDX-License-Identifier: LGPL-2.1-or-later
// Patches of Q_k with random shape, and closest points on them by a plain Newton iteration.
#pragma once

#include <pellicle/kinematics/closest_point.h>

#include <random>

namespace pellicle::test
{
/** Derivative number `order` of the Bernstein polynomial B_i of degree k at s. */
inline double bernstein(const int i, const int k, const double s, const int order)
{
  if (i < 0 || i > k)
    return 0.;
  if (order > 0)
    return k * (bernstein(i - 1, k - 1, s, order - 1) - bernstein(i, k - 1, s, order - 1));
  if (k == 0)
    return 1.;
  return (1. - s) * bernstein(i, k - 1, s, 0) + s * bernstein(i - 1, k - 1, s, 0);
}

/** A patch and a point x near it: coordinates of x, then of the control points, rows as in ClosestPoint. */
struct PatchAndPoint
{
  unsigned int degree = 2;
  std::vector<double> coordinates;

  std::size_t n_nodes() const { return (degree + 1) * (degree + 1); }
  std::size_t n_rows() const { return 3 * (1 + n_nodes()); }
  double &at(const std::size_t node, const unsigned int component)
  {
    return coordinates[component * (1 + n_nodes()) + node];
  }

  Vector3<double> point() const
  {
    return {coordinates[0], coordinates[1 + n_nodes()], coordinates[2 * (1 + n_nodes())]};
  }
  void set_point(const Vector3<double> &x)
  {
    for (unsigned int i = 0; i < 3; ++i)
      at(0, i) = x[i];
  }

  /** Derivative of the shape functions, orders[a] times in parameter a. */
  std::vector<double> shapes(const std::array<double, 2> &xi, const std::array<int, 2> &orders) const
  {
    std::vector<double> m;
    for (unsigned int j = 0; j <= degree; ++j)
      for (unsigned int i = 0; i <= degree; ++i)
        m.push_back(bernstein(i, degree, xi[0], orders[0]) * bernstein(j, degree, xi[1], orders[1]));
    return m;
  }
  Vector3<double> interpolate(const std::vector<double> &m) const
  {
    Vector3<double> x;
    for (std::size_t K = 0; K < m.size(); ++K)
      for (unsigned int i = 0; i < 3; ++i)
        x[i] += m[K] * coordinates[i * (1 + n_nodes()) + 1 + K];
    return x;
  }

  /** `free`: parameters that are. */
  MasterPoint master(const std::array<double, 2> &xi, const std::vector<unsigned int> &free) const
  {
    const auto derivative = [&](const std::vector<unsigned int> &with_respect_to)
    {
      std::array<int, 2> orders{};
      for (const unsigned int a : with_respect_to)
        ++orders[free[a]];
      return shapes(xi, orders);
    };
    MasterPoint p;
    p.n_parameters = free.size();
    p.values       = derivative({});
    p.x            = interpolate(p.values);
    p.outward      = cross(interpolate(shapes(xi, {{1, 0}})), interpolate(shapes(xi, {{0, 1}})));
    for (unsigned int a = 0; a < free.size(); ++a)
    {
      p.first_values[a] = derivative({a});
      p.first[a]        = interpolate(p.first_values[a]);
      for (unsigned int b = a; b < free.size(); ++b)
      {
        p.second_values[a + b] = derivative({a, b});
        p.second(a, b)         = interpolate(p.second_values[a + b]);
        for (unsigned int c = b; c < free.size(); ++c)
          p.third[a + b + c] = interpolate(derivative({a, b, c}));
      }
    }
    return p;
  }

  /** Newton's iteration for the closest point among the free parameters from xi, which becomes the solution. */
  MasterPoint closest(std::array<double, 2> &xi, const std::vector<unsigned int> &free) const
  {
    for (unsigned int iteration = 0; iteration < 30; ++iteration)
    {
      const MasterPoint p = master(xi, free);
      const ClosestPoint geometry(point(), p);
      const Vector3<double> r = point() - p.x;
      for (unsigned int a = 0; a < free.size(); ++a)
        for (unsigned int b = 0; b < free.size(); ++b)
          xi[free[a]] += geometry.c(a, b) * dot(r, geometry.base[b]);
    }
    return master(xi, free);
  }
};

/** Unit square with bumps and uneven control points. */
inline PatchAndPoint random_patch(const unsigned int degree, std::mt19937 &generator)
{
  std::uniform_real_distribution<double> uniform(-1., 1.);
  PatchAndPoint patch;
  patch.degree = degree;
  patch.coordinates.assign(patch.n_rows(), 0.);
  for (unsigned int j = 0; j <= degree; ++j)
    for (unsigned int i = 0; i <= degree; ++i)
    {
      const std::size_t node = 1 + j * (degree + 1) + i;
      patch.at(node, 0)      = double(i) / degree + 0.1 * uniform(generator);
      patch.at(node, 1)      = double(j) / degree + 0.1 * uniform(generator);
      patch.at(node, 2)      = 0.25 * uniform(generator);
    }
  return patch;
}
} // namespace pellicle::test

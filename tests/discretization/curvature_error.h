// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/edge_loops.h>

#include <cmath>
#include <functional>
#include <vector>

namespace pellicle
{
/** Unit conormal at a point of a rim. */
using ConormalField = std::function<Vector3<double>(const Vector3<double> &)>;

/** Root mean square of a field over the surface. */
inline double mean_norm(const SurfaceDiscretization &surface, const NodalVectors &field)
{
  double sum = 0., area = 0.;
  std::vector<double> x(surface.tables.n_points * 18), v(x);
  for (std::size_t cell = 0; cell < surface.n_cells; ++cell)
  {
    const std::size_t *const nodes = &surface.cell_nodes[cell * surface.n_local()];
    evaluate_field(surface.tables, nodes, surface.positions, 3, x.data());
    evaluate_field(surface.tables, nodes, field, 1, v.data());
    for (unsigned int q = 0; q < surface.tables.n_points; ++q)
    {
      const double *const a = &x[q * 18 + 3], *const f = &v[q * 18];
      const double weight =
          surface.tables.weights[q] * norm(cross(Vector3<double>(a[0], a[1], a[2]), Vector3<double>(a[3], a[4], a[5])));
      sum += weight * (f[0] * f[0] + f[1] * f[1] + f[2] * f[2]);
      area += weight;
    }
  }
  return std::sqrt(sum / area);
}

/**
 * The field h of degree k that solves
 *
 *     integral of h.y dA = integral of grad x : grad y dA - line integral of nu.y over the rims   for all y of degree
 * k;
 *
 * h = -2 H n in the limit. nu is the given function of position, or else the conormal of the cells themselves.
 * Conjugate gradients on the mass matrix.
 */
inline NodalVectors curvature_vector(const SurfaceDiscretization &surface, const ConormalField &conormal = {})
{
  const ShapeTables &tables = surface.tables;
  const std::size_t n = tables.n_nodes, n_values = 3 * surface.n_nodes;
  std::vector<double> inputs(tables.n_points * 18), weights;
  NodalVectors h(n_values, 0.), residual(n_values, 0.);
  const auto slot = [](const std::vector<double> &in, const unsigned int q, const unsigned int s)
  { return Vector3<double>(in[(q * 6 + s) * 3], in[(q * 6 + s) * 3 + 1], in[(q * 6 + s) * 3 + 2]); };

  for (std::size_t cell = 0; cell < surface.n_cells; ++cell)
  {
    const std::size_t *const nodes = &surface.cell_nodes[cell * n];
    evaluate_field(tables, nodes, surface.positions, 3, inputs.data());
    for (unsigned int q = 0; q < tables.n_points; ++q)
    {
      const Vector3<double> a1 = slot(inputs, q, 1), a2 = slot(inputs, q, 2), a3 = cross(a1, a2);
      const Vector3<double> dual1 = cross(a2, a3) / dot(a3, a3), dual2 = cross(a3, a1) / dot(a3, a3);
      weights.push_back(tables.weights[q] * norm(a3));
      for (std::size_t i = 0; i < n; ++i)
        for (unsigned int c = 0; c < 3; ++c)
          residual[3 * nodes[i] + c] +=
              weights.back() * (tables.tables[1][q * n + i] * dual1[c] + tables.tables[2][q * n + i] * dual2[c]);
    }
  }
  for (const EdgeLoop &rim : surface.edges)
  {
    if (!rim.is_rim)
      continue;
    const std::vector<Vector3<double>> nu = conormals(surface, rim, surface.positions);
    std::vector<double> along(rim.tables.n_points * 18);
    const std::size_t m = rim.tables.n_nodes;
    for (std::size_t edge = 0; edge < rim.n_cells; ++edge)
    {
      evaluate_field(rim.tables, &rim.cell_nodes[edge * m], surface.positions, 2, along.data());
      for (unsigned int q = 0; q < rim.tables.n_points; ++q)
      {
        const Vector3<double> out = conormal ? conormal(slot(along, q, 0)) : nu[edge * rim.tables.n_points + q];
        for (std::size_t i = 0; i < m; ++i)
          for (unsigned int c = 0; c < 3; ++c)
            residual[3 * rim.cell_nodes[edge * m + i] + c] -=
                rim.tables.weights[q] * norm(slot(along, q, 1)) * rim.tables.tables[0][q * m + i] * out[c];
      }
    }
  }

  const auto times_mass = [&](const NodalVectors &p)
  {
    NodalVectors result(n_values, 0.);
    for (std::size_t cell = 0; cell < surface.n_cells; ++cell)
    {
      const std::size_t *const nodes = &surface.cell_nodes[cell * n];
      evaluate_field(tables, nodes, p, 1, inputs.data());
      for (unsigned int q = 0; q < tables.n_points; ++q)
        for (std::size_t i = 0; i < n; ++i)
          for (unsigned int c = 0; c < 3; ++c)
            result[3 * nodes[i] + c] +=
                weights[cell * tables.n_points + q] * tables.tables[0][q * n + i] * slot(inputs, q, 0)[c];
    }
    return result;
  };
  NodalVectors p(residual);
  const auto squared = [](const NodalVectors &v)
  {
    double sum = 0.;
    for (const double x : v)
      sum += x * x;
    return sum;
  };
  double rr = squared(residual);
  for (const double goal = 1e-24 * rr; rr > goal;)
  {
    const NodalVectors mass_p = times_mass(p);
    double p_mass_p           = 0.;
    for (std::size_t i = 0; i < n_values; ++i)
      p_mass_p += p[i] * mass_p[i];
    for (std::size_t i = 0; i < n_values; ++i)
    {
      h[i] += rr / p_mass_p * p[i];
      residual[i] -= rr / p_mass_p * mass_p[i];
    }
    const double next = squared(residual);
    for (std::size_t i = 0; i < n_values; ++i)
      p[i] = residual[i] + next / rr * p[i];
    rr = next;
  }

  return h;
}

/** Error of -2 H = h.n, in the root mean square, where the nodes lie on a sphere of radius R about a centre. */
inline double curvature_error(const SurfaceDiscretization &surface, const double R, const Vector3<double> &centre,
                              const ConormalField &conormal = {})
{
  NodalVectors error = curvature_vector(surface, conormal);
  for (std::size_t i = 0; i < error.size(); i += 3)
  {
    const double *const x   = &surface.positions[i];
    const Vector3<double> n = (Vector3<double>(x[0], x[1], x[2]) - centre) / R;
    const double difference = dot(Vector3<double>(error[i], error[i + 1], error[i + 2]), n) - 2. / R;
    for (unsigned int c = 0; c < 3; ++c)
      error[i + c] = difference * n[c];
  }
  return mean_norm(surface, error);
}
} // namespace pellicle

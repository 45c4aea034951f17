// SPDX-License-Identifier: LGPL-2.1-or-later
// Surfaces made of a few cells, without a mesh library.
#pragma once

#include <pellicle/discretization/surface_discretization.h>
#include <pellicle/kinematics/vector3.h>

#include <pellicle/discretization/lagrange_line.h>

#include <cmath>

namespace pellicle::test
{
/** n x n cells of degree k on the unit square, shape(u, v) giving positions; open, no edge loops listed. */
template <typename Shape>
SurfaceDiscretization sheet(const unsigned int degree, const unsigned int n, const Shape &shape)
{
  const LagrangeLine line(degree);
  SurfaceDiscretization s;
  s.degree                   = degree;
  s.tables                   = make_surface_tables(degree, degree + 1);
  s.n_cells                  = std::size_t(n) * n;
  const std::size_t n_across = std::size_t(n) * degree + 1;
  s.n_nodes                  = n_across * n_across;
  const auto coordinate      = [&](const std::size_t i)
  { return i == n_across - 1 ? 1. : (i / degree + line.points()[i % degree]) / n; };
  for (std::size_t j = 0; j < n_across; ++j)
    for (std::size_t i = 0; i < n_across; ++i)
    {
      const Vector3<double> x = shape(coordinate(i), coordinate(j));
      s.positions.insert(s.positions.end(), x.components.begin(), x.components.end());
    }
  for (std::size_t c = 0; c < s.n_cells; ++c)
    for (std::size_t j = 0; j <= degree; ++j)
      for (std::size_t i = 0; i <= degree; ++i)
        s.cell_nodes.push_back(((c / n) * degree + j) * n_across + (c % n) * degree + i);
  return s;
}

/** The surface of a box, bilinear cells, normals outward. */
inline SurfaceDiscretization box(const Vector3<double> &size)
{
  SurfaceDiscretization s;
  s.degree  = 1;
  s.tables  = make_surface_tables(1, 2);
  s.n_cells = 6;
  s.n_nodes = 8;
  for (unsigned int v = 0; v < 8; ++v)
    for (unsigned int c = 0; c < 3; ++c)
      s.positions.push_back(((v >> c) & 1) * size[c]);
  s.cell_nodes = {0, 4, 2, 6, 1, 3, 5, 7, 0, 1, 4, 5, 2, 6, 3, 7, 0, 2, 1, 3, 4, 5, 6, 7};
  return s;
}
} // namespace pellicle::test

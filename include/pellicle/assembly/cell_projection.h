// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/lagrange_line.h>
#include <pellicle/kinematics/closest_point.h>

#include <array>
#include <cstddef>

namespace pellicle
{
/** A cell as it stands: shape functions in each direction, and positions of its nodes, lexicographic. */
struct CellShape
{
  const LagrangeLine &line;
  const Vector3<double> *nodes;

  std::size_t n_nodes() const { return std::size_t(line.degree() + 1) * (line.degree() + 1); }
};

/** The point of a cell that is closest to a point x, among all with 0 <= xi^a <= 1. */
struct CellProjection
{
  std::array<double, 2> xi{};
  /** Whether the parameter is free: (x - x_p) . a_a = 0. If not it is 0 or 1, where the distance would fall beyond. */
  std::array<bool, 2> free{{true, true}};
  Vector3<double> foot;    ///< x_p
  Vector3<double> outward; ///< a_1 x a_2
  double distance = 0.;

  unsigned int n_free() const { return (free[0] ? 1u : 0u) + (free[1] ? 1u : 0u); }
};

/**
 * Newton's method for the smallest distance from the best of the cell's nodes, with the Gauss-Newton matrix a_ab where
 * a_ab - (x - x_p) . a_a,b is not positive definite, backtracking, and parameters held at 0 and 1 as long as the
 * distance would fall beyond (theory: Sauer 2014 (18) with bounds). A parameter at its bound counts as free when its
 * slope vanishes up to 1e-9, so that points above an edge belong to the cells' interior. Finds a local minimum: the
 * closest one for points within the radius of curvature. Throws SolveError without convergence.
 */
CellProjection project_on_cell(const Vector3<double> &x, const CellShape &cell);

/** What variations need at a point of a cell: parameters that are not free are left out. */
MasterPoint master_point(const CellShape &cell, const CellProjection &at);
} // namespace pellicle

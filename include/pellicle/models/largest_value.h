// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/models/cell_geometry.h>

namespace pellicle
{
/** f(x) = linear . (x - origin) + 1/2 sum_i diagonal_i (x_i - origin_i)^2. */
struct QuadraticFunction
{
  Vector3<double> linear;
  Vector3<double> diagonal;
  Vector3<double> origin;

  double value(const Vector3<double> &x) const;
  Vector3<double> gradient(const Vector3<double> &x) const;
};

/**
 * Largest value of f on the surface (on a meridian: on the line itself, not revolved), wherever in its cells that is.
 * Every cell whose samples come near the largest one is searched from its best sample by Newton's method on the unit
 * cell, with bounds.
 */
double largest_value(const CellGeometry &geometry, const QuadraticFunction &f);
} // namespace pellicle

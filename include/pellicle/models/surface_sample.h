// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace pellicle
{
/** One named field at the points of a SurfaceSample, in the user's units. */
struct SampledField
{
  std::string name;
  unsigned int n_components = 1; ///< 1 or 3
  std::vector<double> values;    ///< point after point in the order of SurfaceSample::points, components together
};

/**
 * A surface in R^3 as output sees it: cells of degree k given by their values at (k+1)^2 points, whatever the
 * discretisation was. The points of a cell are equidistant on the unit square, (i/k, j/k), lexicographic with i
 * fastest; point p of cell c is number c (k+1)^2 + p. Neighbouring cells repeat their shared points. A surface of
 * revolution comes already revolved.
 */
struct SurfaceSample
{
  unsigned int degree = 3; ///< k >= 1
  std::size_t n_cells = 0;
  std::vector<double> points; ///< three coordinates a point, in the user's units
  std::vector<SampledField> fields;

  std::size_t points_per_cell() const { return std::size_t(degree + 1) * (degree + 1); }
  std::size_t n_points() const { return n_cells * points_per_cell(); }
};
} // namespace pellicle

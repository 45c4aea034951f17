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
  unsigned int n_components = 1; ///< 1, 3 or 9 (a tensor, row after row)
  std::vector<double> values;    ///< point after point in the order of SurfaceSample::points, components together
};

/**
 * A surface in R^3 as output sees it: cells of degree k given by their values at (k+1)^2 points, whatever the
 * discretisation was. The points of a cell are equidistant on the unit square, (i/k, j/k), lexicographic with i
 * fastest; point p of cell c is number c (k+1)^2 + p. Neighbouring cells repeat their shared points. A surface of
 * revolution comes already revolved. A body is sampled in the same way, by hexahedra with points (i/k, j/k, l/k), or by
 * the quadrilaterals of its section if it is one of revolution.
 */
struct SurfaceSample
{
  unsigned int dimension = 2; ///< of the cells: 2 or 3
  unsigned int degree    = 3; ///< k >= 1
  std::size_t n_cells    = 0;
  std::vector<double> points; ///< three coordinates a point, in the user's units
  std::vector<SampledField> fields;

  std::size_t points_per_cell() const
  {
    return std::size_t(degree + 1) * (degree + 1) * (dimension == 3 ? degree + 1 : 1);
  }
  std::size_t n_points() const { return n_cells * points_per_cell(); }
};

/** The sample of a body and the first part of its files' names. */
struct NamedSample
{
  std::string name;
  SurfaceSample sample;
};
} // namespace pellicle

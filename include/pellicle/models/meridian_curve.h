// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>

namespace pellicle
{
/** A point of a meridian, and how its radius changes along the cell. */
struct MeridianPoint
{
  double r = 0., z = 0., slope_of_r = 0.; ///< dr/dxi
};

/** The curve of a meridian, cell by cell; xi in [0, 1] runs through a cell. Keeps references. */
class MeridianCurve
{
public:
  MeridianCurve(const SurfaceDiscretization &meridian, const NodalVectors &positions);

  MeridianPoint at(std::size_t cell, double xi) const;
  /** The same as at(cell, 0) and at(cell, 1), without tabulating the shape functions anew. */
  MeridianPoint begin_of(const std::size_t cell) const { return evaluate(ends, cell, 0); }
  MeridianPoint end_of(const std::size_t cell) const { return evaluate(ends, cell, 1); }

private:
  MeridianPoint evaluate(const ShapeTables &tables, std::size_t cell, unsigned int point) const;

  const SurfaceDiscretization &meridian;
  const NodalVectors &positions;
  const ShapeTables ends;
};
} // namespace pellicle

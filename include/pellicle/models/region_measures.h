// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>

#include <vector>

namespace pellicle
{
/** p = P + f . x. */
struct LiquidPressure
{
  double at_origin = 0.;
  Vector3<double> force;

  double operator()(const Vector3<double> &x) const { return at_origin + dot(force, x); }
};

/** What a region of the surface measures: its area, its share of the volume, z component of the pressure's push
 * outwards. */
struct RegionMeasures
{
  double area = 0., volume = 0., push = 0.;
};

/** One for each region, in their order; one for a surface without regions. */
std::vector<RegionMeasures> measure_regions(const SurfaceDiscretization &surface, const NodalVectors &positions,
                                            const LiquidPressure &pressure = {});
} // namespace pellicle

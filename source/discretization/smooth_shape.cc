// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/constants.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/smooth_shape.h>

#include <cmath>

namespace pellicle
{
double SmoothShape::reduced_volume() const
{
  const double four_pi = 4. * pi;
  return 3. * volume / (four_pi * std::pow(area / four_pi, 1.5));
}

SmoothShape scaled_to_area(const SmoothShape &shape, const double area)
{
  const double factor = std::sqrt(area / shape.area);
  SmoothShape result  = shape;
  result.area         = area;
  result.volume       = shape.volume * factor * factor * factor;
  result.point        = [point = shape.point, factor](const Vector3<double> &u) { return factor * point(u); };
  return result;
}
} // namespace pellicle

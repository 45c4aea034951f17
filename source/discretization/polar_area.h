// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/smooth_shape.h>

namespace pellicle
{
/** Point of the unit sphere at the polar angle and at azimuth phi. */
Vector3<double> sphere_point(double polar, double azimuth_over_pi);

/** Polar angle of the sphere that a shape is a map of, within which the shape has the given fraction of its area, to
 * about 1e-12. Throws UserError unless 0 < fraction < 1. */
double polar_angle_of_area(const SmoothShape &shape, double fraction);
} // namespace pellicle

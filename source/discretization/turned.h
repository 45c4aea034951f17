// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/kinematics/vector3.h>

#include <boost/math/special_functions/cos_pi.hpp>
#include <boost/math/special_functions/sin_pi.hpp>

namespace pellicle
{
/** The point (r, 0, z) turned about the z axis; exact for azimuths that are multiples of pi/2. */
inline Vector3<double> turned(const double r, const double azimuth_over_pi, const double z)
{
  return {r * boost::math::cos_pi(azimuth_over_pi), r * boost::math::sin_pi(azimuth_over_pi), z};
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/function_of_place.h>
#include <pellicle/kinematics/gap.h>

#include <memory>
#include <string>

namespace pellicle
{
/**
 * The body z < H(x, y), e.g. a rough substrate.
 *
 * With base vectors a_1 = (1, 0, H_x), a_2 = (0, 1, H_y), metric a_ab, curvature b_ab = H_ab/|(-H_x, -H_y, 1)| and
 * upward normal n of the surface at the foot,
 *
 *     Hess g = -a_a [(a - g b)^-1 b a^-1]^ab a_b,
 *
 * (115) of Sauer 2014 for a rigid body.
 *
 * The foot is found from the place vertically below or above the point, downhill in distance; that is the closest point
 * of all as long as |g| is less than the radii of curvature around. Farther out the gap is that of a locally closest
 * point (on the axis of a trough, of one of two), which does for a point that is not in contact.
 *
 * gap() throws SolveError where H is not smooth or not finite, where the search fails, at the centres of curvature
 * (1 - g k = 0 for a principal curvature k), and inside the body also where the foot is no minimum of the distance,
 * because there is no telling which way is out.
 */
class HeightField : public RigidBody
{
public:
  /** H in internal units. */
  explicit HeightField(std::shared_ptr<const FunctionOfPlace> height);
  GapSample gap(const Vector3<double> &x) const override;
  const std::string &name() const override { return description; }

private:
  std::shared_ptr<const FunctionOfPlace> height;
  std::string description;
};
} // namespace pellicle

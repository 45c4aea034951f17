// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/kinematics/gap.h>

#include <memory>
#include <vector>

namespace pellicle
{
/** Half space (x - origin) . normal < 0. */
class HalfSpace : public RigidBody
{
public:
  /** `normal` need not be a unit vector. */
  HalfSpace(const Vector3<double> &origin, const Vector3<double> &normal);
  GapSample gap(const Vector3<double> &x) const override;
  const std::string &name() const override;

private:
  Vector3<double> origin, normal;
};

/** Ball |x - centre| < radius; or, hollow, everything but the ball, so that x is inside a cavity. */
class Ball : public RigidBody
{
public:
  Ball(const Vector3<double> &centre, double radius, bool hollow = false);
  GapSample gap(const Vector3<double> &x) const override;
  const std::string &name() const override;

private:
  Vector3<double> centre;
  double radius;
  bool hollow;
};

/** Several bodies as one: of their gaps the least counts. At least one body. */
class NearestBody : public RigidBody
{
public:
  explicit NearestBody(std::vector<std::shared_ptr<const RigidBody>> bodies);
  GapSample gap(const Vector3<double> &x) const override;
  const std::string &name() const override { return names; }

private:
  std::vector<std::shared_ptr<const RigidBody>> bodies;
  std::string names;
};
} // namespace pellicle

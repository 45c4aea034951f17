// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/kinematics/rigid_bodies.h>

namespace pellicle
{
HalfSpace::HalfSpace(const Vector3<double> &origin, const Vector3<double> &normal)
    : origin(origin)
    , normal((1. / norm(normal)) * normal)
{
}

GapSample HalfSpace::gap(const Vector3<double> &x) const
{
  const double g = dot(x - origin, normal);
  return {g, normal, identity3(0.), x - g * normal};
}

const std::string &HalfSpace::name() const
{
  static const std::string text = "plane";
  return text;
}

Ball::Ball(const Vector3<double> &centre, const double radius, const bool hollow)
    : centre(centre)
    , radius(radius)
    , hollow(hollow)
{
}

// Of a ball g = |x - c| - R with the Hessian (1 - n n^T)/|x - c|; of a cavity minus that.
GapSample Ball::gap(const Vector3<double> &x) const
{
  const Vector3<double> from_centre = x - centre;
  const double distance             = norm(from_centre);
  if (distance == 0.)
    throw SolveError("A point is at the centre of the " + name() + ": there is no closest point of its surface.");
  const Vector3<double> radial = (1. / distance) * from_centre;
  const double side            = hollow ? -1. : 1.;
  return {side * (distance - radius), side * radial, (side / distance) * (identity3(1.) - outer(radial, radial)),
          centre + radius * radial};
}

const std::string &Ball::name() const
{
  static const std::string ball = "sphere", cavity = "spherical cavity";
  return hollow ? cavity : ball;
}
} // namespace pellicle

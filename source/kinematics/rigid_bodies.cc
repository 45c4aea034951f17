// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/base/text.h>
#include <pellicle/kinematics/rigid_bodies.h>

#include <utility>

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

NearestBody::NearestBody(std::vector<std::shared_ptr<const RigidBody>> bodies)
    : bodies(std::move(bodies))
{
  PELLICLE_ASSERT(!this->bodies.empty(), "there must be a body");
  std::vector<std::string> each;
  for (const auto &body : this->bodies)
    each.push_back(body->name());
  names = joined(each, " and ");
}

GapSample NearestBody::gap(const Vector3<double> &x) const
{
  GapSample nearest = bodies.front()->gap(x);
  for (std::size_t i = 1; i < bodies.size(); ++i)
  {
    const GapSample other = bodies[i]->gap(x);
    if (other.gap < nearest.gap)
      nearest = other;
  }
  return nearest;
}
} // namespace pellicle

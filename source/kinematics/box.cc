// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/kinematics/box.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pellicle
{
namespace
{
/** Two faces count as equally near when their distances differ by less than this part of the box. */
constexpr double rounding = 1e-13;
} // namespace

Box::Box(const Vector3<double> &centre, const Vector3<double> &half_lengths, const std::array<Vector3<double>, 3> &axes)
    : centre(centre)
    , half_lengths(half_lengths)
    , axes(axes)
{
  PELLICLE_ASSERT(std::min({half_lengths[0], half_lengths[1], half_lengths[2]}) > 0., "a box has a volume");
}

const std::string &Box::name() const
{
  static const std::string text = "box";
  return text;
}

// One formula for faces, edges and vertices: r has components along the axes in which x is beyond the faces, and the
// foot stays where it is when x moves along these, up to the length of r. So Hess g = (Q - n n^T)/|r| with the
// projector Q onto these axes, n n^T itself for one axis.
GapSample Box::gap(const Vector3<double> &x) const
{
  Vector3<double> local, r;
  Matrix3 projector;
  for (unsigned int i = 0; i < 3; ++i)
  {
    local[i]            = dot(x - centre, axes[i]);
    const double beyond = std::abs(local[i]) - half_lengths[i];
    if (beyond > 0.)
    {
      r += std::copysign(beyond, local[i]) * axes[i];
      projector = projector + outer(axes[i], axes[i]);
    }
  }
  const double distance = norm(r);
  if (distance == 0.)
    return from_inside(x, local);
  const Vector3<double> normal = (1. / distance) * r;
  return {distance, normal, (1. / distance) * (projector - outer(normal, normal)), x - r};
}

GapSample Box::from_inside(const Vector3<double> &x, const Vector3<double> &local) const
{
  // Distances to the six faces, negative; the opposite of the nearest of a pair matters on the plane between them only.
  unsigned int nearest = 0;
  double gap = std::abs(local[0]) - half_lengths[0], second = -std::abs(local[0]) - half_lengths[0];
  for (unsigned int i = 1; i < 3; ++i)
  {
    const double near_face = std::abs(local[i]) - half_lengths[i], far_face = -std::abs(local[i]) - half_lengths[i];
    second = std::max({second, far_face, std::min(gap, near_face)});
    if (near_face > gap)
    {
      gap     = near_face;
      nearest = i;
    }
  }
  if (gap - second <= rounding * std::max({half_lengths[0], half_lengths[1], half_lengths[2]}))
  {
    char point[100];
    std::snprintf(point, sizeof point, "(%.6g, %.6g, %.6g)", x[0], x[1], x[2]);
    throw SolveError("The point " + std::string(point) + " inside or on the " + name() +
                     " is equally near to two of its faces: there is no closest point of its surface, or no normal. "
                     "(Coordinates in units of the scene's length.)");
  }
  const Vector3<double> normal = std::copysign(1., local[nearest]) * axes[nearest];
  return {gap, normal, identity3(0.), x - gap * normal};
}
} // namespace pellicle

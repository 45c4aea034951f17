// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/kinematics/gap.h>

#include <array>

namespace pellicle
{
/**
 * Cuboid with sharp edges and vertices. With r = x - x_p, the closest point may be
 *
 * | of                 | gap                    | Hess g                      |
 * |--------------------|------------------------|-----------------------------|
 * | a face             | distance to its plane  | 0                           |
 * | an edge, tangent t | norm(r), n = r/norm(r) | (1 - n n^T - t t^T)/norm(r) |
 * | a vertex           | norm(r), n = r/norm(r) | (1 - n n^T)/norm(r)         |
 *
 * from outside, and is of the nearest face from inside. Outside, the gap and its normal are continuous; the Hessian
 * jumps where the closest point enters an edge or a vertex, and has no bound near them. Inside, the normal jumps, too:
 * points pressed into an edge are pushed out of one of its faces. gap() throws SolveError where two faces are equally
 * near, inside and on the edges.
 */
class Box : public RigidBody
{
public:
  /**
   * @param half_lengths  from the centre to the faces, along the axes; all > 0.
   * @param axes          orthonormal.
   */
  Box(const Vector3<double> &centre, const Vector3<double> &half_lengths,
      const std::array<Vector3<double>, 3> &axes = {{{1., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}}});
  GapSample gap(const Vector3<double> &x) const override;
  const std::string &name() const override;

private:
  /** Of the nearest face; throws when there are two. */
  GapSample from_inside(const Vector3<double> &x, const Vector3<double> &local) const;

  Vector3<double> centre, half_lengths;
  std::array<Vector3<double>, 3> axes;
};
} // namespace pellicle

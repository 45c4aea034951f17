// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/kinematics/matrix3.h>
#include <pellicle/kinematics/vector3.h>

#include <string>

namespace pellicle
{
/**
 * Where a point x stands relative to a rigid body: gap g_n = (x - x_p) . n_p to the closest point x_p of the body's
 * surface, (16) of Sauer 2014, positive outside, and how it changes when x moves.
 *
 * | code    | symbol                                                  |
 * |---------|---------------------------------------------------------|
 * | gap     | g_n                                                     |
 * | normal  | n_p, outward of the body: dg_n = n_p . dx               |
 * | hessian | d2 g_n/dx dx; annihilates n_p                           |
 * | foot    | x_p = x - g_n n_p                                       |
 *
 * At g_n = 0 the closest point moves along a tangent t by x_p(x + s t) = x + s t - (s^2/2) (t . hessian t) n_p + ...:
 * that is how nodes which stay on the body follow its curvature.
 */
struct GapSample
{
  double gap = 0.;
  Vector3<double> normal;
  Matrix3 hessian;
  Vector3<double> foot;
};

/** A rigid body that others touch. */
class RigidBody
{
public:
  virtual ~RigidBody() = default;

  /** Of any point at which the closest point is unique; else throws SolveError naming the body and the point. */
  virtual GapSample gap(const Vector3<double> &x) const = 0;

  /** For messages: "plane", "sphere", "height field 0.1*sin(x)". */
  virtual const std::string &name() const = 0;
};
} // namespace pellicle

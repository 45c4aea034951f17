// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/kinematics/vector3.h>

#include <array>

namespace pellicle
{
/** Base vectors X,1 X,2 X,3 of the reference configuration of a body at a point. */
struct ReferenceBasis
{
  std::array<Vector3<double>, 3> dual; ///< G^a: G^a . X,b = delta^a_b, so that F = x,a (x) G^a
  double volume = 1.;                  ///< J_ref = X,1 . (X,2 x X,3) > 0

  ReferenceBasis(const Vector3<double> &X1, const Vector3<double> &X2, const Vector3<double> &X3)
      : volume(dot(X1, cross(X2, X3)))
  {
    dual = {{(1. / volume) * cross(X2, X3), (1. / volume) * cross(X3, X1), (1. / volume) * cross(X1, X2)}};
  }

  /** G^ab = G^a . G^b. */
  double metric(const unsigned int a, const unsigned int b) const { return dot(dual[a], dual[b]); }
};
} // namespace pellicle

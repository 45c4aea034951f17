// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/kinematics/vector3.h>

#include <array>

namespace pellicle
{
/**
 * Base vectors X,1 X,2 X,3 of the reference configuration of a body at a point. They are numbers where the reference is
 * given, and carry derivatives where it is a field.
 */
template <typename Number>
struct BasicReferenceBasis
{
  std::array<Vector3<Number>, 3> dual; ///< G^a: G^a . X,b = delta^a_b, so that F = x,a (x) G^a
  Number volume;                       ///< J_ref = X,1 . (X,2 x X,3) > 0

  BasicReferenceBasis(const Vector3<Number> &X1, const Vector3<Number> &X2, const Vector3<Number> &X3)
      : volume(dot(X1, cross(X2, X3)))
  {
    const Number scale = 1. / volume;
    dual               = {{scale * cross(X2, X3), scale * cross(X3, X1), scale * cross(X1, X2)}};
  }

  /** G^ab = G^a . G^b. */
  Number metric(const unsigned int a, const unsigned int b) const { return dot(dual[a], dual[b]); }
};

using ReferenceBasis = BasicReferenceBasis<double>;
} // namespace pellicle

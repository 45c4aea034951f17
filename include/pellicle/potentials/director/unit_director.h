// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/kinematics/surface_point.h>
#include <pellicle/potentials/point_inputs.h>

namespace pellicle
{
/** The normalised interpolation d = O/|O| and its derivatives at a point, for terms that mind that |O| differs from 1
 * between the nodes. */
template <typename Number>
struct UnitDirector
{
  Vector3<Number> d;
  FirstDerivatives<Number> derivatives; ///< d,1 d,2, orthogonal to d

  explicit UnitDirector(const FieldAtPoint<Number> &O)
  {
    const Number inverse_length = 1. / norm(O.value());
    d                           = inverse_length * O.value();
    derivatives                 = {rate(O.d1(), inverse_length), rate(O.d2(), inverse_length)};
  }

private:
  Vector3<Number> rate(const Vector3<Number> &O_a, const Number &inverse_length) const
  {
    return inverse_length * (O_a - dot(d, O_a) * d);
  }
};
} // namespace pellicle

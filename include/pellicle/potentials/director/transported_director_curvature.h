// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/kinematics/surface_operators.h>
#include <pellicle/potentials/director/director_fields.h>
#include <pellicle/potentials/director/director_history.h>
#include <pellicle/potentials/director/unit_director.h>

#include <memory>

namespace pellicle
{
/**
 * The same addition to the energy as SpontaneousDirectorCurvature for b_a that material points carry along, without the
 * null term of d alone:
 *
 *     mu_1 (2 a^ab d,a . b_b + a^ab b_a . b_b) + mu_2 e^ab (2 (d,a x b_b) . d + (b_a x b_b) . d),
 *
 * with b_a those of the history carried on to the present state, in one step. So the force at the state of the history
 * is that of (44), with its couple of zeta: the derivative at fixed b_a would leave that out. b_a . d = 0 makes the
 * torque on O that of (45).
 */
struct TransportedDirectorCurvature
{
  static constexpr std::array<FieldUse, 2> fields{
      {{"position", Derivatives::first, FieldRole::independent}, director_field(Derivatives::first)}};
  static constexpr bool reparametrisation_invariant = false; ///< the points carry their b_a

  double mu_1 = 0.5;                                           ///< K/2
  double mu_2 = 0.5;                                           ///< (K + kappa_G)/2
  std::shared_ptr<const std::vector<DirectorHistory>> history; ///< by PointData::index

  template <typename Number>
  Number density(const PointInputs<Number, 2> &inputs, const PointData &data) const
  {
    const TangentPlane<Number> p(inputs[0].d1(), inputs[0].d2());
    const UnitDirector<Number> O(inputs[1]);
    const FirstDerivatives<Number> b = transported((*history)[data.index], p, O.d);
    const Number gradient            = 2. * gradient_product(p, O.derivatives, b) + gradient_product(p, b, b);
    // J e^ab c_ab = c_12 - c_21
    const Vector3<Number> turned = cross(O.derivatives[0], b[1]) - cross(O.derivatives[1], b[0]) + cross(b[0], b[1]);
    return p.jacobian * mu_1 * gradient + 2. * mu_2 * dot(O.d, turned);
  }
};
} // namespace pellicle

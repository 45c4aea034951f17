// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/kinematics/surface_operators.h>
#include <pellicle/potentials/director/director_fields.h>
#include <pellicle/potentials/director/director_targets.h>
#include <pellicle/potentials/director/unit_director.h>
#include <pellicle/potentials/potential.h>

namespace pellicle
{
/**
 * What spontaneous curvature adds to the director energy, in the constitutive form b_a = B (I - d d) a_a of the vectors
 * b_a in (43) of Hu, Zhang & E 2007 (there they are history): with P_a = d,a + b_a,
 *
 *     mu_1 a^ab P_a . P_b + mu_2 e^ab (P_a x P_b) . d - (the same for b_a = 0)
 *       = 2 mu_1 B div_s d + mu_1 B^2 (2 - |d_tan|^2) + 2 mu_2 B e^ab (d,a x a_b) . d + 2 mu_2 B^2 d . n,
 *
 * B uniform. At d = n it is -4 k_1 B H + 2 k_1 B^2, so that together with the gradient's and the null term the energy
 * is (K/2) (2H + C0)^2 + kappa_G K_G + 2 k_1 eps_1 B^2/K, C0 = -2 k_1 B/K: that of Helfrich but for a constant per
 * area. No term of it is null: mu_2 acts here.
 */
struct SpontaneousDirectorCurvature
{
  static constexpr std::array<FieldUse, 2> fields{
      {{"position", Derivatives::first, FieldRole::independent}, director_field(Derivatives::first)}};
  static constexpr bool reparametrisation_invariant = true;

  double divergence  = 0.; ///< 2 mu_1 B
  double permutation = 0.; ///< 2 mu_2 B
  double projection  = 0.; ///< mu_1 B^2
  double normal_part = 0.; ///< 2 mu_2 B^2

  /** Coefficients for a spontaneous curvature C0 of the reduced model. */
  static SpontaneousDirectorCurvature of(const DirectorLaw &law, const double C0)
  {
    const double B = law.isotropic_curvature(C0), K = law.bending_modulus;
    return {K * B, law.null_modulus() * B, 0.5 * K * B * B, law.null_modulus() * B * B};
  }

  /** Derivative of the coefficients with respect to C0. */
  static SpontaneousDirectorCurvature rate_of(const DirectorLaw &law, const double C0)
  {
    const double B = law.isotropic_curvature(C0), rate = law.isotropic_curvature(1.), K = law.bending_modulus;
    return {K * rate, law.null_modulus() * rate, K * B * rate, 2. * law.null_modulus() * B * rate};
  }

  template <typename Number>
  Number density(const PointInputs<Number, 2> &inputs, const PointData & /*data*/) const
  {
    const TangentPlane<Number> p(inputs[0].d1(), inputs[0].d2());
    const UnitDirector<Number> O(inputs[1]);
    const Number dn = dot(O.d, p.normal);
    // J e^ab (d,a x a_b) . d = ((d,1 x a_2) - (d,2 x a_1)) . d
    const Number mixed = dot(O.d, cross(O.derivatives[0], p.base[1]) - cross(O.derivatives[1], p.base[0]));
    return p.jacobian *
               (divergence * surface_divergence(p, O.derivatives) + projection * (1. + dn * dn) + normal_part * dn) +
           permutation * mixed;
  }

  void add_derivatives(const PointInputs<double, 2> &inputs, const PointData &data,
                       const PointDerivativeView &view) const;
};
} // namespace pellicle

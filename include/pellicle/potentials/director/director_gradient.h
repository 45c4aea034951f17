// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/director/director_fields.h>
#include <pellicle/potentials/potential.h>

namespace pellicle
{
/**
 * (K/2) |grad O|^2 = (K/2) a^ab O,a . O,b per area: the second term of (23) of Hu, Zhang & E 2007, K = k_1 + eps_1. For
 * O = n it is (K/2) (2H)^2 - K K_G, with K_G the curvature of Gauss.
 *
 * | code   | symbol                                                                   |
 * |--------|--------------------------------------------------------------------------|
 * | S      | a22 |O,1|^2 - 2 a12 O,1.O,2 + a11 |O,2|^2 = J^2 a^ab O,a.O,b             |
 * | J      | |x,1 x x,2|                                                              |
 */
struct DirectorGradientEnergy
{
  static constexpr std::array<FieldUse, 2> fields{
      {{"position", Derivatives::first, FieldRole::independent}, director_field(Derivatives::first)}};
  static constexpr bool reparametrisation_invariant = true;

  double modulus = 1.; ///< K, internal units

  template <typename Number>
  Number density(const PointInputs<Number, 2> &inputs, const PointData & /*data*/) const
  {
    const Vector3<Number> &x1 = inputs[0].d1(), &x2 = inputs[0].d2();
    const Vector3<Number> &O1 = inputs[1].d1(), &O2 = inputs[1].d2();
    const Number S = dot(x2, x2) * dot(O1, O1) - 2. * dot(x1, x2) * dot(O1, O2) + dot(x1, x1) * dot(O2, O2);
    return 0.5 * modulus * S / norm(cross(x1, x2));
  }

  void add_derivatives(const PointInputs<double, 2> &inputs, const PointData &data,
                       const PointDerivativeView &view) const;
};

/**
 * mu_2 e^ab (O,a x O,b) . O per area, the third term of (23) of Hu, Zhang & E 2007 with mu_2 = (k_1 - eps_1)/2 =
 * (K + kappa_G)/2: of the normalised interpolation O/|O|, of which the integral does not change under any variation
 * (4 pi (K + kappa_G) deg O on a closed surface, 1 the degree of the normals of a sphere). Only reported: of the plain
 * interpolation it would not be null.
 */
struct NullLagrangian
{
  static constexpr std::array<FieldUse, 1> fields{{director_field(Derivatives::first)}};
  static constexpr bool reparametrisation_invariant = true;

  double modulus = 1.; ///< 2 mu_2 = K + kappa_G, internal units

  template <typename Number>
  Number density(const PointInputs<Number, 1> &inputs, const PointData & /*data*/) const
  {
    const Vector3<Number> &O = inputs[0].value();
    const Number length      = norm(O);
    return modulus * dot(O, cross(inputs[0].d1(), inputs[0].d2())) / (length * length * length);
  }
};
} // namespace pellicle

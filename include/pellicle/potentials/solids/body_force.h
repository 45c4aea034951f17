// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/bulk_measures.h>
#include <pellicle/potentials/density_potential.h>

namespace pellicle
{
/**
 * Energy of a force f = rho b per present volume in a body, - integral of f . x dv: Gravity of a closed surface as an
 * integral over what is inside.
 *
 * Beside an IncompressibleLiquid it is the full system of Sauer 2014, (70), with a pressure that takes part in weight:
 * with p_f = p + f . x, p the liquid's field, p_f (1 - J) - f . x = p (1 - J) - f . x J per reference volume. So p_f,
 * which obeys grad p_f = f (84), is found exactly by constants p. Were p_f the field itself, beside a dead load - f . x
 * per reference volume, its gradient could not be f in the cells' own polynomials, and the difference would push nodes
 * that nothing holds (doc/numerics.md, "Full and reduced systems").
 *
 * Beside a CompressibleLiquid it leaves J uniform: weight does not compress the liquid. That neglects rho g h beside K.
 */
struct BodyForce
{
  static constexpr std::array<FieldUse, 1> fields{{{"position", Derivatives::bulk, FieldRole::independent}}};
  static constexpr bool reparametrisation_invariant = true;

  Vector3<double> force; ///< f, internal units

  template <typename Number>
  Number density(const PointInputs<Number, 1> &inputs, const PointData & /*data*/) const
  {
    const Vector3<Number> &x = inputs[0].value();
    return -1. * (force[0] * x[0] + force[1] * x[1] + force[2] * x[2]) * bulk_volume_density(inputs[0]);
  }

  void add_derivatives(const PointInputs<double, 1> &inputs, const PointData & /*data*/,
                       const PointDerivativeView &view) const
  {
    const BulkVolumeDerivatives volume(inputs[0]);
    const double depth = dot(force, inputs[0].value());
    view.add_gradient(0, 0, -volume.j * force);
    for (unsigned int a = 0; a < 3; ++a)
      view.add_gradient(0, 1 + a, -depth * volume.j_x[a]);
    if (!view.wants_hessian())
      return;
    for (unsigned int a = 0; a < 3; ++a)
    {
      view.add_hessian(0, 0, 0, 1 + a, -1. * outer(force, volume.j_x[a]));
      for (unsigned int b = a + 1; b < 3; ++b)
        view.add_hessian(0, 1 + a, 0, 1 + b, -depth * volume.j_xx(a, b));
    }
  }
};

} // namespace pellicle

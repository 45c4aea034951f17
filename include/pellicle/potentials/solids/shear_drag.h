// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/bulk_measures.h>
#include <pellicle/potentials/density_potential.h>

namespace pellicle
{
/**
 * What holds the nodes inside a liquid on their way to equilibrium: the second variation of a neo-Hookean solid at its
 * own reference, the present configuration whatever it is,
 *
 *     mu integral of (tr(grad dx grad Dx) + tr(grad dx^T grad Dx)) dv,
 *
 * added to the tangent alone. There is neither energy nor force, so that Newton's method ends in an equilibrium of the
 * liquid by itself, whichever mu: the drag of Levenberg and Marquardt, with shear as its measure of length. Among all
 * motions inside that leave the energy as it is, a step takes the one with least shear.
 */
struct ShearDrag
{
  static constexpr std::array<FieldUse, 1> fields{{{"position", Derivatives::bulk, FieldRole::independent}}};
  static constexpr bool reparametrisation_invariant = true;

  double modulus = 1.; ///< mu, energy/length^3

  template <typename Number>
  Number density(const PointInputs<Number, 1> & /*inputs*/, const PointData & /*data*/) const
  {
    return Number(0.);
  }

  void add_derivatives(const PointInputs<double, 1> &inputs, const PointData & /*data*/,
                       const PointDerivativeView &view) const
  {
    if (!view.wants_hessian())
      return;
    const BulkVolumeDerivatives volume(inputs[0]);
    const double factor = modulus / volume.j; // dual base vectors g^a = j_x[a]/j
    for (unsigned int b = 0; b < 3; ++b)
      for (unsigned int a = 0; a <= b; ++a)
        view.add_hessian(0, 1 + a, 0, 1 + b,
                         identity3(factor * dot(volume.j_x[a], volume.j_x[b])) +
                             factor * outer(volume.j_x[b], volume.j_x[a]));
  }
};
} // namespace pellicle

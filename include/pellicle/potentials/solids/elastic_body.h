// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/bulk_measures.h>
#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/solids/body_density.h>

#include <limits>

namespace pellicle
{
/**
 * Elasticity of a body, E = integral of J_ref W(I1, J) over the parameters: W is an energy per volume of the reference,
 * I1 = tr(F^T F), J = det F, F = x,a (x) G^a. First Piola-Kirchhoff stress P = 2 W_I1 F + J W_J F^-T, Cauchy stress
 * (2/J) W_I1 F F^T + W_J 1. Solids depend on both invariants, liquids on J alone, with the pressure p = -W_J. A law is
 * a class with
 *
 *     template <typename Number>
 *     Number energy(const Number &I1, const Number &J) const;   // W
 *
 * Where J <= 0 the energy is not a number, so that no line search goes there.
 *
 * Derivatives by the chain rule over two invariants take a fortieth of the time of automatic ones over twelve inputs.
 */
template <typename Law>
struct ElasticEnergy
{
  static constexpr std::array<FieldUse, 1> fields{{{"position", Derivatives::bulk, FieldRole::independent}}};

  Law law; ///< moduli in internal units

  template <typename Number, typename Reference>
  Number density(const BasicReferenceBasis<Reference> &G, const PointInputs<Number, 1> &inputs) const
  {
    const Number J = bulk_volume_density(inputs[0]) / G.volume;
    if (!(value_of(J) > 0.))
      return Number(std::numeric_limits<double>::quiet_NaN());
    return G.volume * law.energy(first_invariant(inputs[0], G), J);
  }

  void add_derivatives(const ReferenceBasis &G, const PointInputs<double, 1> &inputs,
                       const PointDerivativeView &view) const
  {
    const FieldAtPoint<double> &x = inputs[0];
    const BulkVolumeDerivatives volume(x);
    using Number   = SecondOrder<2>;
    const Number W = law.energy(seed<Number>(0, first_invariant(x, G)), seed<Number>(1, volume.j / G.volume));
    // W(I1, j/J_ref) times J_ref, differentiated by I1 and j
    const double W_I = G.volume * W.val().dx(0), W_j = W.val().dx(1), W_II = G.volume * W.dx(0).dx(0),
                 W_Ij = W.dx(0).dx(1), W_jj = W.dx(1).dx(1) / G.volume;

    std::array<Vector3<double>, 3> I_x; // dI1/dx,a = 2 G^ab x,b
    for (unsigned int a = 0; a < 3; ++a)
      for (unsigned int b = 0; b < 3; ++b)
        I_x[a] += (2. * G.metric(a, b)) * x.slots[1 + b];
    for (unsigned int a = 0; a < 3; ++a)
      view.add_gradient(0, 1 + a, W_I * I_x[a] + W_j * volume.j_x[a]);
    if (!view.wants_hessian())
      return;
    for (unsigned int b = 0; b < 3; ++b)
    {
      const Vector3<double> W_I_x = W_II * I_x[b] + W_Ij * volume.j_x[b];
      const Vector3<double> W_j_x = W_Ij * I_x[b] + W_jj * volume.j_x[b];
      for (unsigned int a = 0; a <= b; ++a)
        view.add_hessian(0, 1 + a, 0, 1 + b,
                         identity3(2. * W_I * G.metric(a, b)) + W_j * volume.j_xx(a, b) + outer(I_x[a], W_I_x) +
                             outer(volume.j_x[a], W_j_x));
    }
  }
};

/** The same on a given reference: `ElasticBody<Law>{law, reference}`. */
template <typename Law>
using ElasticBody = OnGivenReference<ElasticEnergy<Law>>;
} // namespace pellicle

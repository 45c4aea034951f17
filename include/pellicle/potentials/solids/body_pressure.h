// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/kinematics/automatic_differentiation.h>
#include <pellicle/potentials/bulk_measures.h>
#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/solids/body_density.h>

namespace pellicle
{
/**
 * Energy of a change of volume in mixed form, f(p) - p h(J) per reference volume with a pressure p, a multiplier at the
 * pressure nodes of the body (see add_pressure_nodes()). At its stationary p it is U(J) of the law (volume_laws.h),
 * cell by cell in the mean only: asked for at every quadrature point, a nearly constant volume is more than cells can
 * do (they lock).
 *
 * With f = p, h = J it makes volume stationary, and -p 1 is the Cauchy stress. (With the corrected sign of (130) in
 * Sauer 2014: second variation -p [div dx div Dx - tr(grad dx grad Dx)] per present volume.)
 */
template <typename VolumeLaw>
struct BodyPressure
{
  static constexpr std::array<FieldUse, 2> fields{
      {{"position", Derivatives::bulk, FieldRole::independent},
       {"body pressure", Derivatives::none, FieldRole::multiplier, FieldSpace::bulk_scalars}}};

  VolumeLaw law; ///< modulus in internal units

  template <typename Number, typename Reference>
  Number density(const BasicReferenceBasis<Reference> &G, const PointInputs<Number, 2> &inputs) const
  {
    const Number &p = inputs[1].value()[0];
    const Number J  = bulk_volume_density(inputs[0]) / G.volume;
    return G.volume * (law.dual(p) - p * law.measure(J));
  }

  void add_derivatives(const ReferenceBasis &G, const PointInputs<double, 2> &inputs,
                       const PointDerivativeView &view) const
  {
    const BulkVolumeDerivatives volume(inputs[0]);
    const double p = inputs[1].value()[0];
    using Number   = SecondOrder<1>;
    const Number f = law.dual(seed<Number>(0, p)), h = law.measure(seed<Number>(0, volume.j / G.volume));
    const double f_p = f.val().dx(0), f_pp = f.dx(0).dx(0), h_J = h.val().dx(0), h_JJ = h.dx(0).dx(0);
    const Vector3<double> first(1., 0., 0.); // the pressure's component of its vector

    view.add_gradient(1, 0, (G.volume * (f_p - h.val().val())) * first);
    for (unsigned int a = 0; a < 3; ++a)
      view.add_gradient(0, 1 + a, (-p * h_J) * volume.j_x[a]);
    if (!view.wants_hessian())
      return;
    if (f_pp != 0.)
      view.add_hessian(1, 0, 1, 0, (G.volume * f_pp) * outer(first, first));
    for (unsigned int a = 0; a < 3; ++a)
    {
      view.add_hessian(0, 1 + a, 1, 0, -h_J * outer(volume.j_x[a], first));
      for (unsigned int b = a; b < 3; ++b)
        if (a != b || h_JJ != 0.)
          view.add_hessian(0, 1 + a, 0, 1 + b,
                           (-p * h_J) * volume.j_xx(a, b) +
                               (-p * h_JJ / G.volume) * outer(volume.j_x[a], volume.j_x[b]));
    }
  }
};
} // namespace pellicle

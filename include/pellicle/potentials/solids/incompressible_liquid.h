// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/exceptions.h>
#include <pellicle/potentials/bulk_measures.h>

#include <memory>
#include <vector>

namespace pellicle
{
/**
 * p_f (1 - J) per reference volume with the pressure p_f, a multiplier at the pressure nodes of the body (see
 * add_pressure_nodes()): it makes volume stationary cell by cell, -p_f 1 is the Cauchy stress. (With the corrected sign
 * of (130) in Sauer 2014: second variation -p_f [div dx div Dx - tr(grad dx grad Dx)] per present volume.)
 *
 * With a compliance 1/K > 0 the liquid is compressible, p_f (1 - J) - p_f^2/(2 K): stationary at the pressure K (1 - J)
 * of CompressibleLiquid, but cell by cell in the mean only. A liquid at rest has one J everywhere; asked for at every
 * quadrature point, that is more than cells near a curved surface can do.
 *
 * Alone a liquid, without stiffness against shear (see ShearDrag); beside a neo-Hookean solid with lambda = 0, an
 * incompressible solid whose pressure is p_f.
 */
struct IncompressibleLiquid
{
  static constexpr std::array<FieldUse, 2> fields{
      {{"position", Derivatives::bulk, FieldRole::independent},
       {"liquid pressure", Derivatives::none, FieldRole::multiplier, FieldSpace::bulk_scalars}}};
  static constexpr bool reparametrisation_invariant = false;

  std::shared_ptr<const std::vector<ReferenceBasis>> reference; ///< by PointData::index
  double compliance = 0.;                                       ///< 1/K

  template <typename Number>
  Number density(const PointInputs<Number, 2> &inputs, const PointData &data) const
  {
    const Number &p     = inputs[1].value()[0];
    const double volume = reference_at(data).volume;
    return p * (volume - bulk_volume_density(inputs[0])) - 0.5 * compliance * volume * p * p;
  }

  void add_derivatives(const PointInputs<double, 2> &inputs, const PointData &data,
                       const PointDerivativeView &view) const
  {
    const BulkVolumeDerivatives volume(inputs[0]);
    const double p = inputs[1].value()[0];
    const Vector3<double> first(1., 0., 0.); // the pressure's component of its vector
    const double reference_volume = reference_at(data).volume;
    view.add_gradient(1, 0, (reference_volume * (1. - compliance * p) - volume.j) * first);
    for (unsigned int a = 0; a < 3; ++a)
      view.add_gradient(0, 1 + a, -p * volume.j_x[a]);
    if (!view.wants_hessian())
      return;
    if (compliance != 0.)
      view.add_hessian(1, 0, 1, 0, (-compliance * reference_volume) * outer(first, first));
    for (unsigned int a = 0; a < 3; ++a)
    {
      view.add_hessian(0, 1 + a, 1, 0, -1. * outer(volume.j_x[a], first));
      for (unsigned int b = a + 1; b < 3; ++b)
        view.add_hessian(0, 1 + a, 0, 1 + b, -p * volume.j_xx(a, b));
    }
  }

private:
  const ReferenceBasis &reference_at(const PointData &data) const
  {
    PELLICLE_ASSERT(reference && data.index < reference->size(), "a body needs its reference basis");
    return (*reference)[data.index];
  }
};
} // namespace pellicle

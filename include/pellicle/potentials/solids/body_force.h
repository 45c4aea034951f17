// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/exceptions.h>
#include <pellicle/potentials/bulk_measures.h>
#include <pellicle/potentials/density_potential.h>

#include <memory>
#include <vector>

namespace pellicle
{
/**
 * Energy of a force f = rho b per present volume in a body, - integral of f . x dv: Gravity of a closed surface as an
 * integral over what is inside.
 *
 * The energy depends on the outline alone, so that the field of an IncompressibleLiquid beside it is the part p_v of
 * the pressure p_f = p_v + f . x: constant, hence exact with any pressure nodes.
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

/** The same per reference volume, - integral of f . x dV: the weight goes with the material (dead load, (136) of Sauer
 * 2014). Beside it the field of an IncompressibleLiquid is the whole pressure p_f, with grad p_f = f (84). */
struct DeadBodyForce
{
  static constexpr std::array<FieldUse, 1> fields{{{"position", Derivatives::bulk, FieldRole::independent}}};
  static constexpr bool reparametrisation_invariant = false;

  Vector3<double> force;                                        ///< rho_0 b, internal units
  std::shared_ptr<const std::vector<ReferenceBasis>> reference; ///< by PointData::index

  template <typename Number>
  Number density(const PointInputs<Number, 1> &inputs, const PointData &data) const
  {
    const Vector3<Number> &x = inputs[0].value();
    return -reference_at(data).volume * (force[0] * x[0] + force[1] * x[1] + force[2] * x[2]);
  }

  void add_derivatives(const PointInputs<double, 1> & /*inputs*/, const PointData &data,
                       const PointDerivativeView &view) const
  {
    view.add_gradient(0, 0, -reference_at(data).volume * force);
  }

private:
  const ReferenceBasis &reference_at(const PointData &data) const
  {
    PELLICLE_ASSERT(reference && data.index < reference->size(), "a body needs its reference basis");
    return (*reference)[data.index];
  }
};
} // namespace pellicle

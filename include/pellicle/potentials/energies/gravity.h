// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/effect.h>
#include <pellicle/potentials/surface_measures.h>

namespace pellicle
{
/**
 * Energy of a uniform body force f = rho b on the liquid inside, as an integral over its surface:
 *
 *     E = - integral of f . x dv = -(1/4) closed integral of (f . x)(x . n) da        (E3 of the theory)
 *
 * zero level at the origin. Its force on the surface is the hydrostatic pressure f . x. Parts of a closed surface may
 * be left out where x . n = 0, as on a plane through the origin. The tangent is symmetric on closed surfaces if
 * quadrature is exact: 2k points a direction (doc/numerics.md).
 */
struct Gravity
{
  static constexpr std::array<FieldUse, 1> fields{{{"position", Derivatives::first, FieldRole::independent}}};
  static constexpr bool reparametrisation_invariant = true;

  Vector3<double> force; ///< f, internal units

  template <typename Number>
  Number density(const PointInputs<Number, 1> &inputs, const PointData & /*data*/) const
  {
    const Vector3<Number> &x = inputs[0].value();
    const Number depth       = force[0] * x[0] + force[1] * x[1] + force[2] * x[2];
    return -0.75 * depth * volume_density(inputs[0]);
  }

  void add_derivatives(const PointInputs<double, 1> &inputs, const PointData & /*data*/,
                       const PointDerivativeView &view) const;
};

/** The effect "gravity": f from Droplet/Bond number and Droplet/Inclination. */
class GravityEffect : public Effect
{
public:
  const std::string &name() const override;
  std::string description() const override;
  std::vector<ParameterDerivative> derivatives(const Scales &scales, const SceneTargets &targets) const override;
  void contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const override;
};
} // namespace pellicle

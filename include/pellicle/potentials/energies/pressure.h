// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/effect.h>
#include <pellicle/potentials/surface_measures.h>

namespace pellicle
{
/** E = -P V with a prescribed pressure P (inside minus outside): it inflates for P > 0. Closed surfaces. */
struct Pressure
{
  static constexpr std::array<FieldUse, 1> fields{{{"position", Derivatives::first, FieldRole::independent}}};
  static constexpr bool reparametrisation_invariant = true;

  double pressure = 0.; ///< P, internal units

  template <typename Number>
  Number density(const PointInputs<Number, 1> &inputs, const PointData & /*data*/) const
  {
    return -pressure * volume_density(inputs[0]);
  }

  void add_derivatives(const PointInputs<double, 1> &inputs, const PointData & /*data*/,
                       const PointDerivativeView &view) const
  {
    add_volume_derivatives(inputs[0], 0, -pressure, view);
  }
};

struct PressureParameters
{
  double pressure = 0.;

  void bind(ParameterSection &section);
};

/** The effect "pressure". */
class PressureEffect : public Effect
{
public:
  const std::string &name() const override;
  std::string description() const override;
  void bind(ParameterSection &section) override { parameters.bind(section); }
  std::vector<ParameterDerivative> derivatives(const Scales &scales, const SceneTargets &targets) const override;
  void contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const override;

  PressureParameters parameters;
};
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/effect.h>
#include <pellicle/potentials/surface_measures.h>

namespace pellicle
{
/** g = V, the volume enclosed by a closed surface: one third of the integral of x . n. */
struct EnclosedVolume
{
  static constexpr std::array<FieldUse, 1> fields{{{"position", Derivatives::first, FieldRole::independent}}};
  static constexpr bool reparametrisation_invariant = true;

  template <typename Number>
  Number density(const PointInputs<Number, 1> &inputs, const PointData & /*data*/) const
  {
    return volume_density(inputs[0]);
  }

  void add_derivatives(const PointInputs<double, 1> &inputs, const PointData & /*data*/,
                       const PointDerivativeView &view) const
  {
    add_volume_derivatives(inputs[0], 0, 1., view);
  }
};

struct VolumeConstraintParameters
{
  double stiffness = std::numeric_limits<double>::infinity();

  void bind(ParameterSection &section);
};

/** The effect "volume constraint": V from `Vesicle/Reduced volume`; multiplier "pressure" P of E - P (V - V0). */
class VolumeConstraintEffect : public Effect
{
public:
  const std::string &name() const override;
  std::string description() const override;
  void bind(ParameterSection &section) override { parameters.bind(section); }
  std::vector<ParameterDerivative> derivatives(const Scales &scales, const SceneTargets &targets) const override;
  void contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const override;

  VolumeConstraintParameters parameters;
};
} // namespace pellicle

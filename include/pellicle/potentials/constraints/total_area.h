// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/effect.h>
#include <pellicle/potentials/surface_measures.h>

namespace pellicle
{
/** g = A, the area of the surface. */
struct TotalArea
{
  static constexpr std::array<FieldUse, 1> fields{{{"position", Derivatives::first, FieldRole::independent}}};
  static constexpr bool reparametrisation_invariant = true;

  template <typename Number>
  Number density(const PointInputs<Number, 1> &inputs, const PointData & /*data*/) const
  {
    return area_density(inputs[0]);
  }

  void add_derivatives(const PointInputs<double, 1> &inputs, const PointData & /*data*/,
                       const PointDerivativeView &view) const
  {
    add_area_derivatives(inputs[0], 0, 1., view);
  }
};

struct AreaConstraintParameters
{
  double stiffness = std::numeric_limits<double>::infinity();

  void bind(ParameterSection &section);
};

/** The effect "area constraint": A = `Vesicle/Area`; multiplier "tension" sigma of E + sigma (A - A0). */
class AreaConstraintEffect : public Effect
{
public:
  const std::string &name() const override;
  std::string description() const override;
  void bind(ParameterSection &section) override { parameters.bind(section); }
  void contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const override;

  AreaConstraintParameters parameters;
};
} // namespace pellicle

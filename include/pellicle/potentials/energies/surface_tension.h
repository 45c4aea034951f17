// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/effect.h>
#include <pellicle/potentials/surface_measures.h>

namespace pellicle
{
/** E = sigma A with a prescribed tension sigma: (54) of Sauer 2014 with W = gamma J. */
struct SurfaceTension
{
  static constexpr std::array<FieldUse, 1> fields{{{"position", Derivatives::first, FieldRole::independent}}};
  static constexpr bool reparametrisation_invariant = true;

  double tension = 1.; ///< sigma, internal units

  template <typename Number>
  Number density(const PointInputs<Number, 1> &inputs, const PointData & /*data*/) const
  {
    return tension * area_density(inputs[0]);
  }

  void add_derivatives(const PointInputs<double, 1> &inputs, const PointData & /*data*/,
                       const PointDerivativeView &view) const
  {
    add_area_derivatives(inputs[0], 0, tension, view);
  }
};

struct SurfaceTensionParameters
{
  double tension = 1.;

  void bind(ParameterSection &section);
};

/** The effect "surface tension". */
class SurfaceTensionEffect : public Effect
{
public:
  const std::string &name() const override;
  std::string description() const override;
  void bind(ParameterSection &section) override { parameters.bind(section); }
  std::optional<double> typical_energy(double length) const override;
  std::vector<ParameterDerivative> derivatives(const Scales &scales, const SceneTargets &targets) const override;
  void contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const override;

  SurfaceTensionParameters parameters;
};
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/effect.h>

namespace pellicle
{
/** lambda times the length of an edge loop. */
struct LineTension
{
  static constexpr std::array<FieldUse, 1> fields{{{"position", Derivatives::first, FieldRole::independent}}};
  static constexpr bool reparametrisation_invariant = true;

  double line_tension = 0.; ///< lambda

  template <typename Number>
  Number density(const PointInputs<Number, 1> &inputs, const PointData & /*data*/) const
  {
    return line_tension * norm(inputs[0].d1());
  }
};

struct LineTensionParameters
{
  double line_tension = 1.;

  void bind(ParameterSection &section);
};

/** The effect "line tension": on all edges that can move, free rims and the lines around regions. Throws UserError if
 * there are none. */
class LineTensionEffect : public Effect
{
public:
  const std::string &name() const override;
  std::string description() const override;
  void bind(ParameterSection &section) override { parameters.bind(section); }
  std::optional<double> typical_energy(double length) const override
  {
    return std::abs(parameters.line_tension) * length;
  }
  std::vector<ParameterDerivative> derivatives(const Scales &scales, const SceneTargets &targets) const override;
  void contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const override;

  LineTensionParameters parameters;
};
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/constants.h>
#include <pellicle/potentials/effect.h>

namespace pellicle
{
/** factor times the mean height of the tip's rim, integral of z ds over its length. */
struct TipHeight
{
  static constexpr std::array<FieldUse, 1> fields{{{"position", Derivatives::first, FieldRole::independent}}};
  static constexpr bool reparametrisation_invariant = true;

  double rim_length = 1.; ///< of the rim as it is discretised, which never changes
  double factor     = 1.;

  template <typename Number>
  Number density(const PointInputs<Number, 1> &inputs, const PointData & /*data*/) const
  {
    return factor * inputs[0].value()[2] * norm(inputs[0].d1()) / rim_length;
  }
};

struct TetherParameters
{
  std::string control = "length";
  double length       = 15.;
  double force        = 0.;
  double ring_radius  = 20.;
  double tip_radius   = 0.2;
  double tension      = 0.5;

  void bind(ParameterSection &section);
};

/**
 * The effect "tether": a flat membrane under the tension sigma, clamped flat at an outer ring, out of which a rigid
 * flat disc, at whose rim the membrane is clamped flat, too, is pulled to the height Tether/Length. It makes the start
 * shape. Its multiplier is the force on the tip, positive when it pulls the membrane out. Throws UserError without
 * bending.
 */
class TetherEffect : public Effect
{
public:
  const std::string &name() const override;
  std::string description() const override;
  void bind(ParameterSection &section) override { parameters.bind(section); }
  void check() const override;
  std::vector<ParameterDerivative> derivatives(const Scales &scales, const SceneTargets &targets) const override;
  void contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const override;

  TetherParameters parameters;
};
} // namespace pellicle

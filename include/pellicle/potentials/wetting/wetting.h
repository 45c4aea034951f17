// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/effect.h>

namespace pellicle
{
/**
 * The effect "wetting": energy -gamma cos(theta) per wetted area, gamma cos(theta) = gamma_SG - gamma_SL (110 of Sauer
 * 2014), as an integral along the contact line. Young's law follows.
 */
class WettingEffect : public Effect
{
public:
  const std::string &name() const override;
  std::string description() const override;
  std::vector<ParameterDerivative> derivatives(const Scales &scales, const SceneTargets &targets) const override;
  void contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const override;
};
} // namespace pellicle

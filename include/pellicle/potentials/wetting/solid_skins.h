// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/effect.h>

namespace pellicle
{
/**
 * The effect "solid skins": energy gamma_SL per present area of the wetted top of the substrate, gamma_SG of the dry
 * one, (52) of Sauer 2014. Both act on the body's own nodes, with Tensions/Solid liquid and Tensions/Solid gas.
 */
class SolidSkinsEffect : public Effect
{
public:
  const std::string &name() const override;
  std::string description() const override;
  /** By both tensions. */
  std::vector<ParameterDerivative> derivatives(const Scales &scales, const SceneTargets &targets) const override;
  void contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const override;
};
} // namespace pellicle

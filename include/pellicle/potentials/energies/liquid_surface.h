// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/effect.h>

namespace pellicle
{
/** The effect "liquid surface": energy gamma times the area of the liquid-gas surface, (52) of Sauer 2014; gamma is
 * Droplet/Surface tension, on a soft substrate Tensions/Liquid gas. */
class LiquidSurfaceEffect : public Effect
{
public:
  const std::string &name() const override;
  std::string description() const override;
  /** On a soft substrate, by Tensions/Liquid gas. */
  std::vector<ParameterDerivative> derivatives(const Scales &scales, const SceneTargets &targets) const override;
  void contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const override;
};
} // namespace pellicle

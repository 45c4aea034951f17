// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/effect.h>

namespace pellicle
{
struct LipidDomainParameters
{
  double area_fraction         = 0.1;
  double bending_rigidity      = 1.;
  double spontaneous_curvature = 0.;

  void bind(ParameterSection &section);
};

/**
 * The effect "lipid domain": a patch of other lipids around the north pole of the start shape, with its own rigidity
 * and spontaneous curvature; a membrane with directors has moduli of the domain in section Director. Its area is held, its boundary moves within the membrane: so the domain is no property of
 * material points, and tangential motion stays a gauge everywhere but across that line (contract 5). The multiplier of
 * the domain's area is the difference of tensions: inside the domain the tension is sigma + domain_tension.
 * (Juelicher and Lipowsky, Phys. Rev. E 53, 2670 (1996).)
 */
class LipidDomainEffect : public Effect
{
public:
  const std::string &name() const override;
  std::string description() const override;
  void bind(ParameterSection &section) override { parameters.bind(section); }
  void prepare(const Scales &scales, SceneTargets &targets) const override;
  std::vector<ParameterDerivative> derivatives(const Scales &scales, const SceneTargets &targets) const override;
  void contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const override;

  LipidDomainParameters parameters;
};
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/effect.h>

namespace pellicle
{
struct SpontaneousDirectorCurvatureParameters
{
  double spontaneous_curvature = 0.;
  std::string form             = "constitutive";

  void bind(ParameterSection &section);
};

/**
 * The effect "spontaneous director curvature": what the vectors b_a of (43) of Hu, Zhang & E 2007 add to the energy of
 * the effect "director". Constitutive: a function of the present state (SpontaneousDirectorCurvature). Transported: b_a
 * of the start state, carried along with the material (TransportedDirectorCurvature).
 */
class SpontaneousDirectorCurvatureEffect : public Effect
{
public:
  const std::string &name() const override;
  std::string description() const override;
  void bind(ParameterSection &section) override { parameters.bind(section); }
  /** By Spontaneous director curvature/Spontaneous curvature, in the constitutive form. */
  std::vector<ParameterDerivative> derivatives(const Scales &scales, const SceneTargets &targets) const override;
  void contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const override;

  SpontaneousDirectorCurvatureParameters parameters;

private:
  void add_to_region(std::size_t region, const Scales &scales, const SceneTargets &targets, PotentialSet &set) const;
};
} // namespace pellicle

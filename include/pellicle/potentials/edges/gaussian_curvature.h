// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/effect.h>

namespace pellicle
{
struct GaussianCurvatureParameters
{
  double gaussian_modulus  = -1.;
  double domain_difference = 0.;

  void bind(ParameterSection &section);
};

/**
 * The effect "gaussian curvature": kappa_G times the integral of K. On a closed surface it is the constant 2 pi chi
 * kappa_G and costs nothing; with free or hinged rims it acts there, by the geodesic curvature (see GeodesicCurvature),
 * and so it does on the line around a domain of another modulus.
 */
class GaussianCurvatureEffect : public Effect
{
public:
  const std::string &name() const override;
  std::string description() const override;
  void bind(ParameterSection &section) override { parameters.bind(section); }
  void prepare(const Scales &scales, SceneTargets &targets) const override;
  void contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const override;

  GaussianCurvatureParameters parameters;
};
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/edges/edge_bending.h>
#include <pellicle/potentials/edges/gaussian_curvature.h>

namespace pellicle
{
void GaussianCurvatureParameters::bind(ParameterSection &section)
{
  section.number(
      "Gaussian modulus", gaussian_modulus, Range::any(), dimensions::energy,
      "Gaussian modulus kappa_G in kappa_G K per area. A flat free membrane is stable for -2 kappa < kappa_G "
      "< 0 only.");
}

const std::string &GaussianCurvatureEffect::name() const
{
  static const std::string text = "gaussian curvature";
  return text;
}

std::string GaussianCurvatureEffect::description() const
{
  return "Energy kappa_G K per area: a constant on closed surfaces, at work on free and hinged rims.";
}

void GaussianCurvatureEffect::prepare(const Scales &scales, SceneTargets &targets) const
{
  targets.gaussian_modulus = scaled(parameters, scales).gaussian_modulus;
}

void GaussianCurvatureEffect::contribute(const Scales & /*scales*/, const SceneTargets &targets,
                                         PotentialSet &set) const
{
  if (!targets.has_bending())
    throw UserError("The effect 'gaussian curvature' needs the bending energy besides it: add 'helfrich bending' to "
                    "Effects.");
  constexpr double two_pi = 6.283185307179586;
  set.constants.push_back(
      {"gaussian_energy", two_pi * targets.euler_characteristic * targets.gaussian_modulus, dimensions::energy});
  for (const SceneEdge &edge : targets.edges)
    if (edge.support == EdgeSupport::free || edge.support == EdgeSupport::hinged)
      set.energies.push_back(std::make_shared<DensityPotential<GeodesicCurvature>>(
          name(), GeodesicCurvature{targets.gaussian_modulus}, Where{Where::Part::edge, edge.name}));
}
} // namespace pellicle

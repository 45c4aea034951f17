// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/constants.h>
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
  section.number("Domain difference", domain_difference, Range::any(), dimensions::energy,
                 "Gaussian modulus of a lipid domain minus that of the membrane around it. By the theorem of Gauss and "
                 "Bonnet it acts on the line between them.");
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
  const GaussianCurvatureParameters p = scaled(parameters, scales);
  targets.gaussian_modulus            = p.gaussian_modulus;
  targets.gaussian_difference         = p.domain_difference;
}

void GaussianCurvatureEffect::contribute(const Scales & /*scales*/, const SceneTargets &targets,
                                         PotentialSet &set) const
{
  if (!targets.has_bending())
    throw UserError("The effect 'gaussian curvature' needs the bending energy besides it: add 'helfrich bending' to "
                    "Effects.");
  constexpr double two_pi = 2. * pi;
  set.constants.push_back(
      {"gaussian_energy", two_pi * targets.euler_characteristic * targets.gaussian_modulus, dimensions::energy});
  const auto on_edge = [&](const double modulus, const SceneEdge &edge)
  {
    set.energies.push_back(std::make_shared<DensityPotential<GeodesicCurvature>>(name(), GeodesicCurvature{modulus},
                                                                                 Where{Where::Part::edge, edge.name}));
  };
  bool has_line = false;
  for (const SceneEdge &edge : targets.edges)
    if (edge.support == EdgeSupport::free || edge.support == EdgeSupport::hinged)
      on_edge(targets.gaussian_modulus, edge);
    else if (edge.support == EdgeSupport::inner && targets.gaussian_difference != 0.)
    {
      has_line = true;
      on_edge(targets.gaussian_difference, edge);
      set.constants.push_back({"gaussian_energy", two_pi * targets.gaussian_difference, dimensions::energy}); // a disc
    }
  if (targets.gaussian_difference != 0. && !has_line)
    throw UserError("Gaussian curvature/Domain difference needs the effect 'lipid domain', which makes a domain.");
}
} // namespace pellicle

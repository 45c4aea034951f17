// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/energies/surface_tension.h>

namespace pellicle
{
void SurfaceTensionParameters::bind(ParameterSection &section)
{
  section.number("Surface tension", tension, Range::any(), dimensions::tension,
                 "Prescribed surface tension sigma in E = sigma A. Positive: the surface wants to shrink.");
}

const std::string &SurfaceTensionEffect::name() const
{
  static const std::string text = "surface tension";
  return text;
}

std::string SurfaceTensionEffect::description() const
{
  return "Energy sigma A of a prescribed surface tension sigma.";
}

std::optional<double> SurfaceTensionEffect::typical_energy(const double length) const
{
  if (parameters.tension == 0.)
    return std::nullopt;
  return std::abs(parameters.tension) * length * length;
}

void SurfaceTensionEffect::contribute(const Scales &scales, const SceneTargets & /*targets*/, PotentialSet &set) const
{
  const double tension = scaled(parameters, scales).tension;
  set.energies.push_back(std::make_shared<DensityPotential<SurfaceTension>>(name(), SurfaceTension{tension}));
  set.prescribed.push_back({"tension", tension, dimensions::tension});
}

std::vector<ParameterDerivative> SurfaceTensionEffect::derivatives(const Scales &scales,
                                                                   const SceneTargets & /*targets*/) const
{
  return {
      {"Surface tension/Surface tension",
       std::make_shared<DensityPotential<SurfaceTension>>(name(), SurfaceTension{1. / scales.of(dimensions::tension)}),
       "", 0.}};
}
} // namespace pellicle

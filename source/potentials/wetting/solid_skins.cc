// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/energies/surface_tension.h>
#include <pellicle/potentials/wetting/solid_skins.h>

#include <utility>

namespace pellicle
{
namespace
{
std::shared_ptr<const Potential> tension_on(const std::string &name, const double tension, const char *region)
{
  return std::make_shared<DensityPotential<SurfaceTension>>(name, SurfaceTension{tension},
                                                            Where{Where::Part::region, region});
}
} // namespace

const std::string &SolidSkinsEffect::name() const
{
  static const std::string text = "solid skins";
  return text;
}

std::string SolidSkinsEffect::description() const
{
  return "Surface energy of the substrate's top, Tensions/Solid liquid per wetted and Tensions/Solid gas per dry area.";
}

void SolidSkinsEffect::contribute(const Scales & /*scales*/, const SceneTargets &targets, PotentialSet &set) const
{
  const RidgeTargets &substrate = targets.soft_substrate();
  set.energies.push_back(tension_on(name(), substrate.solid_liquid_tension, solid_liquid_region));
  set.energies.push_back(tension_on(name(), substrate.solid_gas_tension, solid_gas_region));
}

std::vector<ParameterDerivative> SolidSkinsEffect::derivatives(const Scales &scales, const SceneTargets &targets) const
{
  const RidgeTargets &substrate = targets.soft_substrate();
  const double slope            = substrate.load / scales.of(dimensions::tension);
  std::vector<ParameterDerivative> list{
      {"Tensions/Solid liquid", tension_on(name(), slope, solid_liquid_region), "", 0.},
      {"Tensions/Solid gas", tension_on(name(), slope, solid_gas_region), "", 0.}};
  if (substrate.load > 0.)
    for (const auto &[tension, region] : {std::make_pair(substrate.solid_liquid_tension, solid_liquid_region),
                                          std::make_pair(substrate.solid_gas_tension, solid_gas_region)})
      list.push_back({"Tensions/Scale", tension_on(name(), tension / substrate.load, region), "", 0.});
  return list;
}
} // namespace pellicle

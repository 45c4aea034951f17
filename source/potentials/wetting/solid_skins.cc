// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/energies/neo_hookean_skin.h>
#include <pellicle/potentials/energies/surface_tension.h>
#include <pellicle/potentials/moving_skin.h>
#include <pellicle/potentials/wetting/solid_skins.h>

#include <algorithm>
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

/** The part of the energy that depends on strain. */
std::shared_ptr<const Potential> elastic_part(const std::string &name, const double modulus, const char *region,
                                              const RidgeTargets &substrate)
{
  const Where where{Where::Part::region, region};
  const NeoHookeanSkin law{modulus};
  if (substrate.line_is_free)
    return std::make_shared<DensityPotential<MovingSkin<NeoHookeanSkin>>>(name, MovingSkin<NeoHookeanSkin>{law}, where);
  return std::make_shared<DensityPotential<ElasticSkin<NeoHookeanSkin>>>(
      name, ElasticSkin<NeoHookeanSkin>{law, substrate.skin_reference}, where);
}
} // namespace

void SolidSkinsParameters::bind(ParameterSection &section)
{
  const std::string text = "part of the top: mu_s in (mu_s/2)(l1^2 + l2^2 - 2 - 2 ln(l1 l2)) per undeformed area, l1 "
                           "and l2 the principal stretches, beside the tension's gamma l1 l2. 0: its stress is gamma, "
                           "whatever the strain.";
  section.number("Shear modulus solid liquid", solid_liquid_modulus, Range::non_negative(), dimensions::tension,
                 "Shear modulus of the surface of the wetted " + text);
  section.number("Shear modulus solid gas", solid_gas_modulus, Range::non_negative(), dimensions::tension,
                 "Shear modulus of the surface of the dry " + text);
}

const std::string &SolidSkinsEffect::name() const
{
  static const std::string text = "solid skins";
  return text;
}

std::string SolidSkinsEffect::description() const
{
  return "Surface energy of the substrate's top, Tensions/Solid liquid per wetted and Tensions/Solid gas per dry area; "
         "with a shear modulus mu_s also (mu_s/2)(l1^2 + l2^2 - 2 - 2 ln(l1 l2)) per undeformed area, l1 and l2 the "
         "principal stretches.";
}

std::optional<double> SolidSkinsEffect::typical_energy(const double length) const
{
  const double modulus = std::max(parameters.solid_liquid_modulus, parameters.solid_gas_modulus);
  if (modulus == 0.)
    return std::nullopt;
  return modulus * length * length;
}

void SolidSkinsEffect::contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const
{
  const RidgeTargets &substrate = targets.soft_substrate();
  set.energies.push_back(tension_on(name(), substrate.solid_liquid_tension, solid_liquid_region));
  set.energies.push_back(tension_on(name(), substrate.solid_gas_tension, solid_gas_region));
  const SolidSkinsParameters internal = scaled(parameters, scales);
  if (internal.solid_liquid_modulus > 0.)
    set.energies.push_back(elastic_part(name(), internal.solid_liquid_modulus, solid_liquid_region, substrate));
  if (internal.solid_gas_modulus > 0.)
    set.energies.push_back(elastic_part(name(), internal.solid_gas_modulus, solid_gas_region, substrate));
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

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/potentials/constraints/enclosed_volume.h>
#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/wetting/base_integral.h>

#include <cmath>

namespace pellicle
{
void VolumeConstraintParameters::bind(ParameterSection &section)
{
  section.number(
      "Stiffness", stiffness, Range::positive().or_infinite(), {1, -6},
      "Stiffness c of the penalty energy (c/2)(V - V0)^2, V0 from Vesicle/Reduced volume or Droplet/Volume: a "
      "liquid of bulk modulus K = c V0, whose pressure is K (1 - V/V0). inf: the volume is held exactly by a "
      "Lagrange multiplier. Either way the pressure P = c (V0 - V), inside minus outside, is reported.");
}

const std::string &VolumeConstraintEffect::name() const
{
  static const std::string text = "volume constraint";
  return text;
}

std::string VolumeConstraintEffect::description() const
{
  return "Holds the volume at the one of Vesicle/Reduced volume or Droplet/Volume; its multiplier is the pressure P in "
         "E - P (V - V0).";
}

void VolumeConstraintEffect::contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const
{
  Constraint volume;
  const std::vector<Where> boundary = boundary_of_liquid(targets);
  const auto part_on                = [&](const Where &where)
  { return std::make_shared<DensityPotential<EnclosedVolume>>(name(), EnclosedVolume{}, where); };
  volume.measure = part_on(boundary.front());
  for (std::size_t p = 1; p < boundary.size(); ++p)
    volume.further_parts.push_back(part_on(boundary[p]));
  volume.target = targets.volume;
  if (targets.droplet)
    for (const WettedBase &base : targets.droplet->bases)
      if (auto part = make_base_volume(name(), base.chart, base.line))
        volume.further_parts.push_back(std::move(part));
  volume.stiffness = scaled(parameters, scales).stiffness;
  volume.quantity  = "volume";
  if (targets.droplet && std::isfinite(volume.stiffness))
    volume.energy = "compression_energy"; // of a liquid, not a penalty
  volume.multiplier      = "pressure";
  volume.multiplier_sign = -1.;
  volume.dimension       = dimensions::volume;
  set.constraints.push_back(volume);
}

std::vector<ParameterDerivative> VolumeConstraintEffect::derivatives(const Scales & /*scales*/,
                                                                     const SceneTargets &targets) const
{
  if (targets.droplet)
    return {{"Droplet/Volume", nullptr, "volume", std::pow(targets.droplet->unit_of_place, -3)}};
  return {{"Vesicle/Reduced volume", nullptr, "volume", targets.volume_of_sphere}};
}
} // namespace pellicle

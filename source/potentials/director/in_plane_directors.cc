// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/director/in_plane_directors.h>

#include <memory>

namespace pellicle
{
namespace
{
const std::string normal_energy = "normal director";
} // namespace

void InPlaneDirectorsParameters::bind(ParameterSection &section)
{
  section.number(
      "Modulus", modulus, Range::non_negative(), dimensions::tension,
      "Modulus k_n in (k_n/2) (O.n)^2 per area. Around a defect directors leave the surface over a length of "
      "about sqrt(K/k_n), which the mesh has to resolve. Take Director/Tilt modulus = 0 beside it.");
}

const std::string &InPlaneDirectorsEffect::name() const
{
  static const std::string text = "in-plane directors";
  return text;
}

std::string InPlaneDirectorsEffect::description() const
{
  return "Directors that prefer to lie in the surface: energy (k_n/2) (O.n)^2 per area.";
}

void InPlaneDirectorsEffect::contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const
{
  targets.director_law(); // there are directors
  set.energies.push_back(std::make_shared<DensityPotential<NormalDirectorEnergy>>(
      normal_energy, NormalDirectorEnergy{scaled(parameters, scales).modulus}));
}

std::vector<ParameterDerivative> InPlaneDirectorsEffect::derivatives(const Scales &scales,
                                                                     const SceneTargets & /*targets*/) const
{
  const double per_unit = 1. / scales.of(dimensions::tension);
  return {{"In-plane directors/Modulus",
           std::make_shared<DensityPotential<NormalDirectorEnergy>>(normal_energy, NormalDirectorEnergy{per_unit}), "",
           0.}};
}
} // namespace pellicle

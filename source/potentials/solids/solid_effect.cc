// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/potentials/solids/body_pressure.h>
#include <pellicle/potentials/solids/moving_reference.h>
#include <pellicle/potentials/solids/solid_effect.h>
#include <pellicle/potentials/solids/volume_laws.h>

namespace pellicle
{
namespace
{
using Terms = std::vector<std::shared_ptr<const Potential>>;

/** One density of the substrate on its reference, which moves where the contact line does. */
template <typename BodyDensity>
void add_term(const std::string &name, const BodyDensity &density, const RidgeTargets &substrate, Terms &terms)
{
  const Where body{Where::Part::bulk, substrate_body};
  if (substrate.line_is_free)
    terms.push_back(std::make_shared<DensityPotential<OnMovingReference<BodyDensity>>>(
        name, OnMovingReference<BodyDensity>{density}, body));
  else
    terms.push_back(std::make_shared<DensityPotential<OnGivenReference<BodyDensity>>>(
        name, OnGivenReference<BodyDensity>{density, substrate.bulk_reference}, body));
}

/** lambda of small strains; infinite for nu = 1/2. */
double first_lame_constant(const double E, const double nu)
{
  return E * nu / ((1. + nu) * (1. - 2. * nu));
}

/** What resists shear; with the energy of changes of volume, unless that is in mixed form. */
NeoHookeanSolid elastic_law(const double E, const double nu, const VolumetricLaw law)
{
  const double mu = E / (2. * (1. + nu));
  return {mu, SolidEffect::uses_pressure(nu) ? 0. : first_lame_constant(E, nu), law};
}
} // namespace

void SolidParameters::bind(ParameterSection &section)
{
  section.choice(
      "Volumetric law", volumetric_law, {"logarithmic", "quadratic"},
      "Energy of changes of volume J per reference volume: (lambda/2)(ln J)^2 (logarithmic) or (lambda/4)(J^2 "
      "- 1 - 2 ln J) (quadratic), lambda = E nu/((1 + nu)(1 - 2 nu)). The same for small strains.");
}

const std::string &SolidEffect::name() const
{
  static const std::string text = "solid";
  return text;
}

std::string SolidEffect::description() const
{
  return "Neo-Hookean substrate: (mu/2)(I1 - 3 - 2 ln J) + U(J) per reference volume, mu = E/(2(1 + nu)), E and nu "
         "those of section Substrate; nu = 1/2 is incompressible.";
}

VolumetricLaw SolidEffect::law() const
{
  return parameters.volumetric_law == "quadratic" ? VolumetricLaw::quadratic : VolumetricLaw::logarithmic;
}

void SolidEffect::contribute(const Scales & /*scales*/, const SceneTargets &targets, PotentialSet &set) const
{
  const RidgeTargets &substrate = targets.soft_substrate();
  const double E = substrate.young_modulus, nu = substrate.poisson_ratio;
  add_term(name(), ElasticEnergy<NeoHookeanSolid>{elastic_law(E, nu, law())}, substrate, set.energies);
  if (!uses_pressure(nu))
    return;
  const double compliance = (1. + nu) * (1. - 2. * nu) / (E * nu); // 1/lambda
  if (compliance == 0.)
    add_term(name(), BodyPressure<LinearVolumeLaw>{{0.}}, substrate, set.energies);
  else if (law() == VolumetricLaw::quadratic)
    add_term(name(), BodyPressure<QuadraticVolumeLaw>{{compliance}}, substrate, set.energies);
  else
    add_term(name(), BodyPressure<LogarithmicVolumeLaw>{{compliance}}, substrate, set.energies);
}

// The energy is proportional to E, but for the one in terms of a pressure; that has a derivative only where it is J
// = 1.
std::vector<ParameterDerivative> SolidEffect::derivatives(const Scales &scales, const SceneTargets &targets) const
{
  const RidgeTargets &substrate = targets.soft_substrate();
  const double nu               = substrate.poisson_ratio;
  if (uses_pressure(nu) && nu != 0.5)
    return {};
  Terms terms;
  add_term(name(), ElasticEnergy<NeoHookeanSolid>{elastic_law(1. / scales.of(dimensions::pressure), nu, law())},
           substrate, terms);
  return {{"Substrate/Young modulus", terms[0], "", 0.}};
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exact_text.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/director/spontaneous_curvature_effect.h>
#include <pellicle/potentials/director/spontaneous_director_curvature.h>
#include <pellicle/potentials/director/transported_director_curvature.h>

namespace pellicle
{
void SpontaneousDirectorCurvatureParameters::bind(ParameterSection &section)
{
  section.number("Spontaneous curvature", spontaneous_curvature, Range::any(), dimensions::curvature,
                 "Spontaneous curvature C0 of the limit of normal directors, (K/2)(2H + C0)^2: positive favours convex "
                 "outward. The vectors b_a = B (I - O O) x,a of the model have B = -C0 K/(2 K + kappa_G).");
  section.choice("Form", form, {"constitutive", "transported"},
                 "constitutive: b_a = B (I - O O) x,a of the present shape. transported: of the start shape, stretched "
                 "and turned with the material from there; depends on the way taken.");
}

const std::string &SpontaneousDirectorCurvatureEffect::name() const
{
  static const std::string text = "spontaneous director curvature";
  return text;
}

std::string SpontaneousDirectorCurvatureEffect::description() const
{
  return "Spontaneous curvature of directors: O,a + b_a in the place of O,a in the energy of 'director' and in the "
         "null "
         "Lagrangian, which then acts.";
}

void SpontaneousDirectorCurvatureEffect::contribute(const Scales &scales, const SceneTargets &targets,
                                                    PotentialSet &set) const
{
  targets.director_law(); // there are directors
  for (std::size_t region = 0; region < targets.directors.size(); ++region)
    add_to_region(region, scales, targets, set);
}

void SpontaneousDirectorCurvatureEffect::add_to_region(const std::size_t region, const Scales &scales,
                                                       const SceneTargets &targets, PotentialSet &set) const
{
  const DirectorLaw &law = targets.directors[region];
  const Where where      = targets.region_of_directors(region);
  if (!(law.k_1() > 0.))
    throw UserError("The effect 'spontaneous director curvature' needs Director/Gaussian modulus > -2 Director/Bending "
                    "modulus: with K + kappa_G/2 = " +
                    exact_text(law.k_1() * scales.of(dimensions::energy)) +
                    " there is no spontaneous curvature C0 in the limit of normal directors.");
  const double C0 = scaled(parameters, scales).spontaneous_curvature;
  if (parameters.form == "constitutive")
  {
    set.energies.push_back(std::make_shared<DensityPotential<SpontaneousDirectorCurvature>>(
        name(), SpontaneousDirectorCurvature::of(law, C0), where));
    return;
  }
  const auto history = targets.director_start ? std::make_shared<const std::vector<DirectorHistory>>(isotropic_history(
                                                    *targets.director_start, law.isotropic_curvature(C0)))
                                              : nullptr;
  set.energies.push_back(std::make_shared<DensityPotential<TransportedDirectorCurvature>>(
      name(), TransportedDirectorCurvature{0.5 * law.bending_modulus, 0.5 * law.null_modulus(), history}, where));
}

std::vector<ParameterDerivative> SpontaneousDirectorCurvatureEffect::derivatives(const Scales &scales,
                                                                                 const SceneTargets &targets) const
{
  if (parameters.form != "constitutive")
    return {};
  const double C0       = scaled(parameters, scales).spontaneous_curvature;
  const double per_unit = 1. / scales.of(dimensions::curvature);
  std::vector<ParameterDerivative> all;
  for (std::size_t region = 0; region < targets.directors.size(); ++region)
  {
    SpontaneousDirectorCurvature rate = SpontaneousDirectorCurvature::rate_of(targets.directors[region], C0);
    for (double *coefficient : {&rate.divergence, &rate.permutation, &rate.projection, &rate.normal_part})
      *coefficient *= per_unit;
    all.push_back({"Spontaneous director curvature/Spontaneous curvature",
                   std::make_shared<DensityPotential<SpontaneousDirectorCurvature>>(
                       name(), rate, targets.region_of_directors(region)),
                   "", 0.});
  }
  return all;
}
} // namespace pellicle

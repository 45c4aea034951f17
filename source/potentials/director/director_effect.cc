// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/director/director_effect.h>
#include <pellicle/potentials/director/director_gradient.h>
#include <pellicle/potentials/director/tilt_energy.h>

#include <algorithm>
#include <cmath>

namespace pellicle
{
namespace
{
const std::string tilt_energy = "tilt", gradient_energy = "director gradient", domain_energy = "domain null lagrangian";

/** c and d of k_0 = min(c K/h^2, d k_t). On a surface that is held small shares are the most accurate; one that moves
 * needs k_0 above its (negative) tension, or cells wrinkle (doc/numerics.md, "Directors"). */
constexpr double share_if_held = 0.1, share_if_free = 1., largest_share = 0.9;

/** Derivative of MixedTiltEnergy with respect to k_t, of which k_0 = d k_t takes its part where it is not bounded by
 * the cell's size. */
struct MixedTiltDerivative
{
  static constexpr std::array<FieldUse, 3> fields   = MixedTiltEnergy::fields;
  static constexpr bool reparametrisation_invariant = true;

  double factor;
  double tilt_modulus;
  std::shared_ptr<const std::vector<double>> direct;

  template <typename Number>
  Number density(const PointInputs<Number, 3> &inputs, const PointData &data) const
  {
    const double k_0 = (*direct)[data.index], k_t = tilt_modulus;
    const bool is_share   = k_0 >= largest_share * k_t; // of k_t, else of the cell's size
    const double k_0_rate = factor * (is_share ? largest_share : 0.),
                 t_rate   = factor * (is_share ? 0. : k_0 / (k_t * k_t));
    const double compliance_rate =
        factor * (is_share ? largest_share - 1. : 2. * k_0 / k_t - 1.) / (k_t * k_t); // of t/k_t
    const double normal_rate = -MixedTiltEnergy::normal_weight * k_0_rate / (k_0 * k_0);
    TangentialForm<2> rate;
    rate.alpha = {{{k_0_rate, t_rate}, {t_rate, -compliance_rate}}};
    rate.beta  = {{{k_0_rate, t_rate}, {t_rate, normal_rate}}};
    return rate.density(inputs[0], std::array<Vector3<Number>, 2>{inputs[1].value(), inputs[2].value()});
  }
};
} // namespace

void DirectorParameters::bind(ParameterSection &section)
{
  section.number("Tilt modulus", tilt_modulus, Range::non_negative().or_infinite(), dimensions::tension,
                 "Tilt modulus k_t in (k_t/2) |O - (O.n) n|^2 per area. inf: the directors stay normal, and the model "
                 "is that of Helfrich with bending rigidity K. 0: no energy of tilt.");
  section.number("Bending modulus", bending_modulus, Range::positive(), dimensions::energy,
                 "Bending modulus K = k_1 + eps_1 in (K/2) |grad O|^2 per area.");
  section.number(
      "Gaussian modulus", gaussian_modulus, Range::any(), dimensions::energy,
      "Gaussian modulus kappa_G = -2 eps_1 of the model with normal directors. It weighs the null Lagrangian "
      "(K + kappa_G)/2 e^ab (O,a x O,b).O, which is only reported, and the spontaneous curvature.");
  section.number("Domain tilt ratio", domain_tilt, Range::positive(), dimensions::none,
                 "Tilt modulus inside a `lipid domain` over that of the membrane. 1: the same.");
  section.number("Domain bending ratio", domain_bending, Range::positive(), dimensions::none,
                 "Bending modulus K inside a `lipid domain` over that of the membrane. 1: the same. The Gaussian modulus "
                 "is the same on both sides.");
  section.choice(
      "Shear", shear, {"mixed", "direct"},
      "mixed: the force that holds the tilt is a field of its own, for any tilt modulus. direct: without it; loses "
      "accuracy as k_t h^2/K grows above 1, h the distance of nodes.");
}

bool DirectorParameters::shear_jumps() const
{
  return domain_tilt != 1. && tilt_modulus > 0. && std::isfinite(tilt_modulus) && shear == "mixed";
}

std::vector<DirectorLaw> DirectorParameters::laws() const
{
  std::vector<DirectorLaw> list{{tilt_modulus, bending_modulus, gaussian_modulus}};
  if (has_domain())
    list.push_back({domain_tilt * tilt_modulus, domain_bending * bending_modulus, gaussian_modulus});
  return list;
}

const std::string &DirectorEffect::name() const
{
  static const std::string text = "director";
  return text;
}

std::string DirectorEffect::description() const
{
  return "Unit directors O on the membrane: energy of tilt (k_t/2) |O - (O.n) n|^2 and of their gradient (K/2) |grad "
         "O|^2 per area.";
}

void DirectorEffect::check() const
{
  if (parameters.shear == "direct" && std::isinf(parameters.tilt_modulus))
    throw UserError(
        "Director/Tilt modulus = inf needs Director/Shear = mixed: in the direct form it would be a stiffness "
        "without bound. Choose mixed or a finite modulus.");
}

std::optional<double> DirectorEffect::typical_energy(double /*length*/) const
{
  return parameters.bending_modulus;
}

void DirectorEffect::prepare(const Scales &scales, SceneTargets &targets) const
{
  targets.directors = scaled(parameters, scales).laws();
}

void DirectorEffect::contribute(const Scales & /*scales*/, const SceneTargets &targets, PotentialSet &set) const
{
  for (std::size_t region = 0; region < targets.directors.size(); ++region)
  {
    const DirectorLaw &law = targets.directors[region];
    const Where where      = targets.region_of_directors(region);
    const bool is_held     = law.tilt_modulus > 0.;
    if (is_held && parameters.shear == "mixed")
      set.energies.push_back(std::make_shared<DensityPotential<MixedTiltEnergy>>(
          tilt_energy, MixedTiltEnergy{law.tilt_modulus, direct_tilt_modulus(law, targets)}, where));
    else if (is_held)
      set.energies.push_back(
          std::make_shared<DensityPotential<TiltEnergy>>(tilt_energy, TiltEnergy{law.tilt_modulus}, where));
    set.energies.push_back(std::make_shared<DensityPotential<DirectorGradientEnergy>>(
        gradient_energy, DirectorGradientEnergy{law.bending_modulus}, where));
    // mu_2 = mu_2 of the membrane everywhere, which has no variation, and the difference inside the domain.
    const double difference = law.null_modulus() - targets.director_law().null_modulus();
    if (difference != 0.)
      set.energies.push_back(
          std::make_shared<DensityPotential<NullLagrangian>>(domain_energy, NullLagrangian{difference}, where));
  }
}

std::vector<ParameterDerivative> DirectorEffect::derivatives(const Scales &scales, const SceneTargets &targets) const
{
  if (std::isinf(parameters.tilt_modulus) || parameters.tilt_modulus == 0.)
    return {};
  const std::vector<DirectorLaw> laws = scaled(parameters, scales).laws();
  std::vector<ParameterDerivative> all;
  for (std::size_t region = 0; region < laws.size(); ++region)
  {
    const DirectorLaw &law = laws[region];
    const Where where      = targets.region_of_directors(region);
    const double factor    = law.tilt_modulus / laws[0].tilt_modulus / scales.of(dimensions::tension);
    std::shared_ptr<const Potential> energy;
    if (parameters.shear == "direct")
      energy = std::make_shared<DensityPotential<TiltEnergy>>(tilt_energy, TiltEnergy{factor}, where);
    else
      energy = std::make_shared<DensityPotential<MixedTiltDerivative>>(
          tilt_energy, MixedTiltDerivative{factor, law.tilt_modulus, direct_tilt_modulus(law, targets)}, where);
    all.push_back({"Director/Tilt modulus", energy, "", 0.});
  }
  return all;
}

std::shared_ptr<const std::vector<double>> direct_tilt_modulus(const DirectorLaw &law, const SceneTargets &targets)
{
  if (!targets.cell_sizes)
    return nullptr;
  auto direct = std::make_shared<std::vector<double>>();
  direct->reserve(targets.cell_sizes->size());
  const double share = targets.surface_is_held ? share_if_held : share_if_free;
  for (const double h_squared : *targets.cell_sizes)
    direct->push_back(std::min(share * law.bending_modulus / h_squared, largest_share * law.tilt_modulus));
  return direct;
}

std::shared_ptr<const Potential> null_lagrangian(const DirectorLaw &law)
{
  return std::make_shared<DensityPotential<NullLagrangian>>("null lagrangian", NullLagrangian{law.null_modulus()});
}
} // namespace pellicle

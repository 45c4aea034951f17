// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/constants.h>
#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/surface_measures.h>
#include <pellicle/potentials/wetting/base_integral.h>
#include <pellicle/potentials/wetting/wetting.h>

#include <cmath>

namespace pellicle
{
namespace
{
/** The same energy of a base that is a membrane of its own: tension gamma_SL - gamma_SG = -gamma cos(theta). */
struct BaseMembrane
{
  static constexpr std::array<FieldUse, 1> fields{{{"position", Derivatives::first, FieldRole::independent}}};
  static constexpr bool reparametrisation_invariant = true;

  WettingIntegrand integrand;

  template <typename Number>
  Number density(const PointInputs<Number, 1> &inputs, const PointData & /*data*/) const
  {
    const Vector3<Number> &x = inputs[0].value();
    return integrand.factor * integrand.cosine(x[0], x[1]) * area_density(inputs[0]);
  }
};

std::vector<std::shared_ptr<const Potential>> terms(const std::string &name, const DropletTargets &drop,
                                                    const WettingIntegrand &integrand)
{
  std::vector<std::shared_ptr<const Potential>> list;
  for (const WettedBase &base : drop.bases)
    list.push_back(make_wetting(name, base.chart, integrand, base.line));
  if (drop.has_base_membrane)
    list.push_back(std::make_shared<DensityPotential<BaseMembrane>>(name, BaseMembrane{integrand},
                                                                    Where{Where::Part::region, base_region}));
  return list;
}
} // namespace

const std::string &WettingEffect::name() const
{
  static const std::string text = "wetting";
  return text;
}

std::string WettingEffect::description() const
{
  return "Energy -gamma cos(theta) per wetted area of the substrate, theta the contact angle through the liquid.";
}

void WettingEffect::contribute(const Scales & /*scales*/, const SceneTargets &targets, PotentialSet &set) const
{
  const DropletTargets &drop = targets.drop();
  const WettingIntegrand integrand{-drop.surface_tension, {std::cos(drop.contact_angle), drop.contact_angle_field}};
  for (auto &term : terms(name(), drop, integrand))
    set.energies.push_back(std::move(term));
}

std::vector<ParameterDerivative> WettingEffect::derivatives(const Scales & /*scales*/,
                                                            const SceneTargets &targets) const
{
  const DropletTargets &drop = targets.drop();
  if (drop.contact_angle_field)
    return {};
  const WettingIntegrand slope{drop.surface_tension * std::sin(drop.contact_angle) * pi / 180., {1., nullptr}};
  std::vector<ParameterDerivative> list;
  for (auto &term : terms(name(), drop, slope))
    list.push_back({"Droplet/Contact angle", std::move(term), "", 0.});
  return list;
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/constants.h>
#include <pellicle/potentials/wetting/base_integral.h>
#include <pellicle/potentials/wetting/wetting.h>

#include <cmath>

namespace pellicle
{
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
  set.energies.push_back(make_wetting(name(), drop.substrate, integrand, contact_line));
}

std::vector<ParameterDerivative> WettingEffect::derivatives(const Scales & /*scales*/,
                                                            const SceneTargets &targets) const
{
  const DropletTargets &drop = targets.drop();
  if (drop.contact_angle_field)
    return {};
  const WettingIntegrand slope{drop.surface_tension * std::sin(drop.contact_angle) * pi / 180., {1., nullptr}};
  return {{"Droplet/Contact angle", make_wetting(name(), drop.substrate, slope, contact_line), "", 0.}};
}
} // namespace pellicle

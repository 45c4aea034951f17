// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/energies/liquid_surface.h>
#include <pellicle/potentials/energies/surface_tension.h>

namespace pellicle
{
namespace
{
std::shared_ptr<const Potential> tension_on_cap(const std::string &name, const double tension,
                                                const DropletTargets &drop)
{
  Where where;
  if (drop.has_base_membrane)
    where = {Where::Part::region, liquid_gas_region};
  return std::make_shared<DensityPotential<SurfaceTension>>(name, SurfaceTension{tension}, where);
}
} // namespace

const std::string &LiquidSurfaceEffect::name() const
{
  static const std::string text = "liquid surface";
  return text;
}

std::string LiquidSurfaceEffect::description() const
{
  return "Energy gamma times the area of the liquid-gas surface, gamma = Droplet/Surface tension, or Tensions/Liquid "
         "gas "
         "on a soft substrate.";
}

void LiquidSurfaceEffect::contribute(const Scales & /*scales*/, const SceneTargets &targets, PotentialSet &set) const
{
  set.energies.push_back(tension_on_cap(name(), targets.drop().surface_tension, targets.drop()));
}

std::vector<ParameterDerivative> LiquidSurfaceEffect::derivatives(const Scales &scales,
                                                                  const SceneTargets &targets) const
{
  if (!targets.substrate)
    return {};
  const double load = targets.substrate->load, slope = load / scales.of(dimensions::tension);
  std::vector<ParameterDerivative> list{{"Tensions/Liquid gas", tension_on_cap(name(), slope, targets.drop()), "", 0.}};
  if (load > 0.)
    list.push_back(
        {"Tensions/Scale", tension_on_cap(name(), targets.drop().surface_tension / load, targets.drop()), "", 0.});
  return list;
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/energies/liquid_surface.h>
#include <pellicle/potentials/energies/surface_tension.h>

namespace pellicle
{
const std::string &LiquidSurfaceEffect::name() const
{
  static const std::string text = "liquid surface";
  return text;
}

std::string LiquidSurfaceEffect::description() const
{
  return "Energy gamma times the area of the liquid-gas surface, gamma = Droplet/Surface tension.";
}

void LiquidSurfaceEffect::contribute(const Scales & /*scales*/, const SceneTargets &targets, PotentialSet &set) const
{
  const DropletTargets &drop = targets.drop();
  Where where;
  if (drop.has_base_membrane)
    where = {Where::Part::region, liquid_gas_region};
  set.energies.push_back(
      std::make_shared<DensityPotential<SurfaceTension>>(name(), SurfaceTension{drop.surface_tension}, where));
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/potentials/constraints/total_area.h>
#include <pellicle/potentials/density_potential.h>

namespace pellicle
{
void AreaConstraintParameters::bind(ParameterSection &section)
{
  section.number(
      "Stiffness", stiffness, Range::positive().or_infinite(), {1, -4},
      "Stiffness c of the penalty energy (c/2)(A - A0)^2, A0 = Vesicle/Area. inf: the area is held exactly by a "
      "Lagrange "
      "multiplier. Either way the tension sigma = c (A - A0) is reported, positive when the surface is stretched.");
}

const std::string &AreaConstraintEffect::name() const
{
  static const std::string text = "area constraint";
  return text;
}

std::string AreaConstraintEffect::description() const
{
  return "Holds the area at Vesicle/Area; its multiplier is the tension sigma in E + sigma (A - A0).";
}

void AreaConstraintEffect::contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const
{
  Constraint area;
  area.measure    = std::make_shared<DensityPotential<TotalArea>>(name(), TotalArea{});
  area.target     = targets.area;
  area.stiffness  = scaled(parameters, scales).stiffness;
  area.quantity   = "area";
  area.multiplier = "tension";
  area.dimension  = dimensions::area;
  set.constraints.push_back(area);
}
} // namespace pellicle

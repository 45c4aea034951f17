// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/potentials/constraints/lipid_domain.h>
#include <pellicle/potentials/constraints/total_area.h>
#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/energies/helfrich_bending.h>

#include <algorithm>

namespace pellicle
{
void LipidDomainParameters::bind(ParameterSection &section)
{
  section.number("Area fraction", area_fraction, Range::between(1e-3, 0.999), dimensions::none,
                 "Area of the domain relative to Vesicle/Area. The domain starts around the north pole.");
  section.number("Bending rigidity", bending_rigidity, Range::positive(), dimensions::energy,
                 "Bending rigidity kappa inside the domain.");
  section.number(
      "Spontaneous curvature", spontaneous_curvature, Range::any(), dimensions::curvature,
      "Spontaneous curvature C0 inside the domain, in (kappa/2)(2H + C0)^2. Positive: the domain wants to bulge "
      "outwards.");
}

const std::string &LipidDomainEffect::name() const
{
  static const std::string text = "lipid domain";
  return text;
}

std::string LipidDomainEffect::description() const
{
  return "A patch of given area with its own bending rigidity and spontaneous curvature; its boundary is free to move.";
}

void LipidDomainEffect::prepare(const Scales &scales, SceneTargets &targets) const
{
  const LipidDomainParameters p = scaled(parameters, scales);
  targets.bending.resize(std::max<std::size_t>(targets.bending.size(), 2));
  targets.bending[1] = {p.bending_rigidity, p.spontaneous_curvature};
}

void LipidDomainEffect::contribute(const Scales & /*scales*/, const SceneTargets &targets, PotentialSet &set) const
{
  if (!targets.has_bending() && targets.directors.empty())
    throw UserError("The effect 'lipid domain' changes the bending energy on a part of the membrane: add 'helfrich "
                    "bending' to Effects.");
  if (targets.surface_is_held)
    return; // nothing changes the area
  Constraint area;
  area.measure =
      std::make_shared<DensityPotential<TotalArea>>(name(), TotalArea{}, Where{Where::Part::region, region_name(1)});
  area.target          = parameters.area_fraction * targets.area;
  area.quantity        = "domain_area";
  area.is_own_quantity = true;
  area.multiplier      = "domain_tension";
  area.dimension       = dimensions::area;
  set.constraints.push_back(area);
}

std::vector<ParameterDerivative> LipidDomainEffect::derivatives(const Scales &scales, const SceneTargets &targets) const
{
  std::vector<ParameterDerivative> all;
  if (!targets.surface_is_held)
    all.push_back({"Lipid domain/Area fraction", nullptr, "domain_area", targets.area});
  const Where domain{Where::Part::region, region_name(1)};
  if (targets.has_bending())
    all.push_back({"Lipid domain/Spontaneous curvature",
                   spontaneous_curvature_derivative(1. / scales.of(dimensions::curvature), domain), "", 0.});
  return all;
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/energies/gravity.h>
#include <pellicle/potentials/wetting/base_integral.h>

namespace pellicle
{
// E = -(3/4) d v with d = f . x and v = x . (x,1 x x,2)/3.
void Gravity::add_derivatives(const PointInputs<double, 1> &inputs, const PointData & /*data*/,
                              const PointDerivativeView &view) const
{
  const FieldAtPoint<double> &x = inputs[0];
  const double depth            = dot(force, x.value());
  add_volume_derivatives(x, 0, -0.75 * depth, view);
  view.add_gradient(0, 0, -0.75 * volume_density(x) * force);
  if (!view.wants_hessian())
    return;
  const Vector3<double> dv[3] = {1. / 3. * cross(x.d1(), x.d2()), 1. / 3. * cross(x.d2(), x.value()),
                                 1. / 3. * cross(x.value(), x.d1())};
  view.add_hessian(0, 0, 0, 0, -0.75 * (outer(force, dv[0]) + outer(dv[0], force)));
  for (unsigned int a = 1; a < 3; ++a)
    view.add_hessian(0, 0, 0, a, -0.75 * outer(force, dv[a]));
}

const std::string &GravityEffect::name() const
{
  static const std::string text = "gravity";
  return text;
}

std::string GravityEffect::description() const
{
  return "Weight of the liquid: energy -integral of rho b . x, hydrostatic pressure p = P + rho b . x.";
}

void GravityEffect::contribute(const Scales & /*scales*/, const SceneTargets &targets, PotentialSet &set) const
{
  const DropletTargets &drop = targets.drop();
  for (const Where &where : boundary_of_liquid(targets))
    set.energies.push_back(std::make_shared<DensityPotential<Gravity>>(name(), Gravity{drop.body_force}, where));
  for (const WettedBase &base : drop.bases)
    if (auto part = make_base_gravity(name(), base.chart, drop.body_force, base.line))
      set.energies.push_back(std::move(part));
}

// The force is proportional to the Bond number, or on a soft substrate to the body force.
std::vector<ParameterDerivative> GravityEffect::derivatives(const Scales & /*scales*/,
                                                            const SceneTargets &targets) const
{
  const DropletTargets &drop          = targets.drop();
  const Vector3<double> per_unit_bond = drop.force_per_bond_number;
  const char *const parameter         = targets.substrate ? "Droplet/Body force" : "Droplet/Bond number";
  std::vector<ParameterDerivative> list;
  for (const Where &where : boundary_of_liquid(targets))
    list.push_back(
        {parameter, std::make_shared<DensityPotential<Gravity>>(name(), Gravity{per_unit_bond}, where), "", 0.});
  for (const WettedBase &base : drop.bases)
    if (auto part = make_base_gravity(name(), base.chart, per_unit_bond, base.line))
      list.push_back({parameter, std::move(part), "", 0.});
  return list;
}
} // namespace pellicle

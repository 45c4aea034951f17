// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/models/headline.h>

#include <cmath>

namespace pellicle
{
namespace
{
constexpr double smallest_energy = 1e-6; ///< of the scene's energy

bool is_energy(const std::string &quantity)
{
  const std::string end = "_energy";
  return quantity.size() > end.size() && quantity.compare(quantity.size() - end.size(), end.size(), end) == 0;
}
} // namespace

double headline_of(const SurfaceModel &model, const std::string &quantity)
{
  for (const auto &[name, value] : model.quantities())
    if (name == quantity)
      return value;
  PELLICLE_ASSERT(false, "a scene's headline quantity is reported by its model");
  return 0.;
}

double headline_near(const SurfaceModel &model, const std::string &quantity)
{
  const double value = headline_of(model, quantity);
  if (!is_energy(quantity))
    return value;
  const SurfaceProblem &problem = model.equilibrium();
  double excess                 = 0.;
  for (std::size_t k = 0; k < problem.potentials().constraints.size(); ++k)
  {
    const Constraint &constraint = problem.potentials().constraints[k];
    if (!std::isfinite(constraint.stiffness) && !constraint.self_term)
      excess += problem.state().multipliers[k] * (problem.values().constraints[k] - constraint.target);
  }
  return value + excess * model.scales().of(dimensions::energy);
}

double smallest_headline(const SurfaceScene &scene)
{
  return is_energy(scene.headline_quantity()) ? smallest_energy * scene.scales().of(dimensions::energy) : 0.;
}
} // namespace pellicle

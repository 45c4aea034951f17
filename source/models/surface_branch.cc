// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/models/surface_branch.h>

#include <numeric>
#include <utility>
#include <vector>

namespace pellicle
{
SurfaceBranch::SurfaceBranch(SurfaceProblem &problem, SceneParameter parameter, const PositionChart chart,
                             const NodalVectors &mesh_reference)
    : problem(problem)
    , scene_parameter(std::move(parameter))
    , chart(chart)
    , mesh_reference(mesh_reference)
{
  problem.renew_chart_on_the_way(false);
  use_own_chart();
}

void SurfaceBranch::set_parameter(const double value)
{
  PotentialSet set;
  try
  {
    set = scene_parameter.potentials(value);
  }
  catch (const UserError &error)
  {
    throw SolveError(error.what()); // a step too far is no mistake of the user's
  }
  scene_parameter.value = value;
  problem.set_potentials(std::move(set));
}

std::vector<double> SurfaceBranch::residual_derivative()
{
  const std::vector<Constraint> &constraints = problem.potentials().constraints;
  PotentialSet energies;
  std::vector<double> targets(constraints.size(), 0.);
  std::vector<PotentialSet> measures(constraints.size());
  for (const ParameterDerivative &derivative : scene_parameter.derivatives(scene_parameter.value))
  {
    if (derivative.energy)
      energies.energies.push_back(derivative.energy);
    for (std::size_t k = 0; k < constraints.size(); ++k)
      if (constraints[k].quantity == derivative.quantity)
      {
        targets[k] += derivative.target;
        if (derivative.measure)
          measures[k].energies.push_back(derivative.measure);
      }
  }
  const std::size_t n_nodal  = problem.numbering().n_nodal;
  std::vector<double> result = problem.gradient_of(energies);
  for (std::size_t k = 0; k < constraints.size(); ++k)
  {
    result[n_nodal + k] = -targets[k];
    if (measures[k].energies.empty())
      continue;
    const std::vector<double> gradient = problem.gradient_of(measures[k]);
    for (std::size_t i = 0; i < n_nodal; ++i)
      result[i] += problem.state().multipliers[k] * gradient[i];
    result[n_nodal + k] += problem.value_of(measures[k]);
  }
  return result;
}

// Sums to one over a uniform normal displacement by the length.
std::vector<double> SurfaceBranch::weights() const
{
  std::vector<double> weights = problem.area_weights();
  const double area           = std::accumulate(weights.begin(), weights.end(), 0.);
  for (double &weight : weights)
    weight /= area;
  return weights;
}

bool SurfaceBranch::begin_step()
{
  use_own_chart();
  return true;
}

void SurfaceBranch::remember()
{
  remembered       = problem.state();
  remembered_value = scene_parameter.value;
}

void SurfaceBranch::recall()
{
  set_parameter(remembered_value);
  problem.set_state(remembered);
}
} // namespace pellicle

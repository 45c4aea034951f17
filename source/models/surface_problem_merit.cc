// SPDX-License-Identifier: LGPL-2.1-or-later
// What Newton's method goes down: the reduced energy and the constraints.
#include <pellicle/models/surface_problem.h>

#include <algorithm>

namespace pellicle
{
namespace
{
constexpr double largest_merit_penalty = 10.; // rho, internal units

double merit_penalty(const Constraint &constraint)
{
  return std::min(largest_merit_penalty, 0.5 * constraint.stiffness);
}
} // namespace

std::vector<double> SurfaceProblem::full_step_multipliers(const std::vector<double> &direction) const
{
  std::vector<double> multipliers = current.multipliers;
  for (std::size_t k = 0; k < multipliers.size(); ++k)
    multipliers[k] += direction[system->numbering().n_nodal + k];
  return multipliers;
}

// E + sum of lambda_1 v - lambda_1^2/(2 c) + rho (v - lambda_1/c)^2, v = g - g0, lambda_1 after the full step: an
// augmented Lagrangian. With rho = c/2 it is the energy (c/2) v^2, which guides well where the stiffness c is small; in
// the narrow valley of a large one every step along it would be a small one. The values belong to a state with
// multipliers `of_state`.
double SurfaceProblem::merit_of(const TermValues &values, const std::vector<double> &of_state,
                                const std::vector<double> &direction) const
{
  const std::vector<double> multipliers = full_step_multipliers(direction);
  double merit                          = energy_of_self_terms(values, of_state);
  for (const double energy : values.energies)
    merit += energy;
  for (const double energy : values.pairs)
    merit += energy;
  for (const double dissipated : values.dissipations)
    merit += dissipated;
  for (std::size_t k = 0; k < multipliers.size(); ++k)
  {
    const Constraint &constraint = set.constraints[k];
    const double lambda          = multipliers[k];
    const double violation       = values.constraints[k] - constraint.target;
    const double residual        = constraint_residual(k, values, lambda);
    merit +=
        lambda * (violation - 0.5 * lambda / constraint.stiffness) + merit_penalty(constraint) * residual * residual;
  }
  return merit;
}

// Values where the fields that are multipliers have taken their full step, and nothing else has.
TermValues SurfaceProblem::at_full_multiplier_fields(const std::vector<double> &direction) const
{
  SurfaceState with_full_step = current;
  bool has_multiplier_fields  = false;
  for (std::size_t f = 0; f < field_layout.fields().size(); ++f)
    if (is_multiplier(f))
    {
      has_multiplier_fields = true;
      system->prolongate(direction, 1., f, with_full_step.fields[f]);
    }
  return has_multiplier_fields ? evaluate(with_full_step) : current_values;
}

double SurfaceProblem::merit(const std::vector<double> &direction) const
{
  return merit_of(at_full_multiplier_fields(direction), current.multipliers, direction);
}

double SurfaceProblem::merit_slope(const std::vector<double> &direction) const
{
  // The residual holds dE/dx + lambda dg/dx with the present lambda; the moment's residual is zero, so the sum over all
  // unknowns is the derivative of the reduced energy.
  const std::vector<double> multipliers = full_step_multipliers(direction);
  const std::size_t n                   = system->numbering().n_nodal;
  double slope                          = 0.;
  for (std::size_t i = 0; i < n; ++i)
    slope += system->residual()[i] * direction[i];
  // A multiplier field p is at its full step all along: dp . B dx in the place of r_p . dp, where B dx = -r_p + C dp.
  // The energies are quadratic in p (up to dp^3), E(p + dp) - E(p) = r_p . dp - dp . C dp/2.
  const std::vector<double> stepped = at_full_multiplier_fields(direction).energies;
  for (std::size_t e = 0; e < stepped.size(); ++e)
    slope += 2. * (current_values.energies[e] - stepped[e]);
  for (std::size_t k = 0; k < multipliers.size(); ++k)
  {
    const double factor =
        multipliers[k] - current.multipliers[k] +
        2. * merit_penalty(set.constraints[k]) * constraint_residual(k, current_values, multipliers[k]);
    // The internal fields' share of the direction answers to the new multiplier as well, by -r: taken out again.
    double along = current_values.compliances[k] * (current.multipliers[k] - multipliers[k]);
    for (std::size_t i = 0; i < n; ++i)
      along += system->constraint_gradient(k)[i] * direction[i];
    slope += factor * along;
  }
  return slope;
}
} // namespace pellicle

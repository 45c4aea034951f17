// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/field_charts.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/models/internal_elimination.h>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace pellicle
{
namespace
{
constexpr int max_iterations = 10;
constexpr double tolerance   = 1e-11; // of the residual relative to the cells' contributions
} // namespace

InternalElimination::InternalElimination(const SurfaceDiscretization &discretization, const FieldLayout &layout,
                                         const PotentialSet &set, const NodalConditions &conditions,
                                         const FieldValues &start, const Communicator &communicator,
                                         const std::string &linear_solver, Timing &timing)
    : discretization(discretization)
    , layout(layout)
    , conditions(conditions)
    , assembler(discretization, layout, set, communicator, Assembler::internal(set, layout))
    , system(discretization, Numbering(charts(start), 0, 0), communicator)
    , n_unknowns(system.numbering().size())
    , solver(make_linear_solver(linear_solver))
    , timing(timing)
{
}

std::vector<NodalChart> InternalElimination::charts(const FieldValues &values) const
{
  std::vector<NodalChart> list;
  for (std::size_t f = 0; f < layout.fields().size(); ++f)
    list.push_back(layout.fields()[f].role == FieldRole::internal
                       ? chart_of_field(discretization, layout.fields()[f], values[0], values[f], conditions)
                       : NodalChart{});
  return list;
}

int InternalElimination::negative_eigenvalues() const
{
  if (n_unknowns == 0)
    return 0;
  const std::optional<Inertia> inertia = solver->inertia();
  return inertia ? inertia->negative : static_cast<int>(n_unknowns);
}

double InternalElimination::relative_residual(const PotentialSet &set, const std::vector<double> &multipliers,
                                              const FieldValues &values, const Order order)
{
  const Timing::Scope scope(timing, "assembly");
  system.begin();
  assembler.loop(set, values, multipliers, order,
                 [&](const Cell &cell, const Element &element, const auto &constraint_gradients)
                 {
                   if (order == Order::hessian)
                     system.add_cell(cell, element, constraint_gradients, nullptr);
                   else
                     system.add_cell_residual(cell, element, constraint_gradients, nullptr);
                 });
  system.finish();
  return system.residual_norm() / system.contribution_norm();
}

bool InternalElimination::solve(const PotentialSet &set, const std::vector<double> &multipliers, FieldValues &values)
{
  double residual       = std::numeric_limits<double>::infinity();
  bool has_unit_vectors = false;
  for (std::size_t f = 0; f < layout.fields().size(); ++f)
    if (layout.fields()[f].role == FieldRole::internal && chart_follows_values(layout.fields()[f]))
      has_unit_vectors = true;
  for (int iteration = 0; iteration < max_iterations; ++iteration)
  {
    if (has_unit_vectors)
      system.set_charts(charts(values));
    const double before = relative_residual(set, multipliers, values, Order::hessian);
    if (!std::isfinite(before))
      return false;
    std::vector<double> step = system.residual();
    {
      const Timing::Scope scope(timing, "linear solve");
      try
      {
        solver->factorize(system.matrix());
      }
      catch (const SolveError &)
      {
        return false;
      }
      solver->solve(step);
    }
    for (std::size_t f = 0; f < layout.fields().size(); ++f)
      system.prolongate(step, -1., f, values[f]);
    const double after = relative_residual(set, multipliers, values, Order::gradient);
    // Below the tolerance, or at round-off where it no longer falls.
    if (after <= tolerance || (after < 1e3 * tolerance && after > 0.5 * residual))
      return true;
    residual = after;
  }
  return false;
}
} // namespace pellicle

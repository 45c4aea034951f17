// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/faired_positions.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/models/equilibrium_search.h>
#include <pellicle/solvers/load_stepping.h>

#include <algorithm>
#include <cmath>

namespace pellicle
{
namespace
{
// Enough to see whether the first chart suits the shape, where there is another one to try.
constexpr int iterations_before_fallback = 30;
constexpr double distant_from_target     = 1e-6; // relative; beyond it a constraint on curvature is approached in steps
constexpr double released                = 1e-6; // stiffness that leaves a constraint without effect
constexpr int first_steps                = 4;    // towards the target
constexpr double smallest_step           = 1. / 1024.;

std::vector<std::size_t> distant_constraints(const PotentialSet &set, const TermValues &values)
{
  std::vector<std::size_t> list;
  for (std::size_t k = 0; k < set.constraints.size(); ++k)
  {
    const Constraint &constraint = set.constraints[k];
    if (constraint.self_term && !std::isfinite(constraint.stiffness) &&
        std::abs(values.constraints[k] - constraint.target) > distant_from_target * (1. + std::abs(constraint.target)))
      list.push_back(k);
  }
  return list;
}
} // namespace

EquilibriumSearch::EquilibriumSearch(const NewtonParameters &newton, SurfaceProblem &problem, LinearSolver &solver,
                                     Timing &timing, const NodalVectors &mesh_reference, const int step,
                                     Observer &observer)
    : newton(newton)
    , problem(problem)
    , solver(solver)
    , timing(timing)
    , mesh_reference(mesh_reference)
    , step(step)
    , observer(observer)
{
}

bool EquilibriumSearch::run()
{
  const std::vector<std::size_t> distant = distant_constraints(problem.potentials(), problem.values());
  return distant.empty() ? in_charts(newton.chart) : approach(distant);
}

bool EquilibriumSearch::descend()
{
  return in_charts(problem.needs_material_chart() ? "automatic" : "graph then ale");
}

bool EquilibriumSearch::take_one_step()
{
  const bool is_graph =
      newton.chart == "graph" || (newton.chart == "automatic" && problem.discretization().has_junctions());
  const bool is_material = newton.chart == "automatic" && problem.needs_material_chart();
  problem.use_chart(is_graph      ? PositionChart::graph
                    : is_material ? PositionChart::material
                                  : PositionChart::ale,
                    mesh_reference);
  problem.linearize();
  std::vector<double> direction = problem.residual();
  try
  {
    const Timing::Scope scope(timing, "linear solve");
    solver.factorize(problem.matrix());
    for (double &d : direction)
      d = -d;
    solver.solve(direction);
  }
  catch (const SolveError &)
  {
    return false;
  }
  if (!(problem.displacement(direction) <= newton.step_limit) || !std::isfinite(problem.try_step(direction, 1.)))
    return false;
  problem.accept_trial();
  return true;
}

bool EquilibriumSearch::iterate(const PositionChart chart, const int max_iterations)
{
  NewtonParameters parameters = newton;
  parameters.max_iterations   = max_iterations;
  problem.use_chart(chart, mesh_reference);
  Newton method(parameters, solver, timing);
  const NewtonResult result = method.solve(problem, step, observer, outcome.iterations);
  outcome.iterations += result.iterations;
  outcome.rejected += result.rejected;
  outcome.converged         = result.converged;
  outcome.failure           = result.failure;
  outcome.relative_residual = result.relative_residual;
  return result.converged;
}

// In the ALE chart, from an equilibrium in that of the normal graph. Where that fails the graph has mostly arrived at a
// shape with crowded nodes, and a smoother start may do better.
void EquilibriumSearch::polish(const std::optional<SurfaceState> &start)
{
  const SurfaceState graph    = problem.state();
  const double graph_residual = outcome.relative_residual;
  if (iterate(PositionChart::ale, newton.max_iterations))
    return;
  const std::string failure = outcome.failure;
  if (start && from_faired_start(*start))
    return;
  outcome.warnings.push_back(
      "The polishing in the ALE chart did not converge (" + failure +
      "): the equilibrium in the normal-graph chart is reported. More cells or load steps help.");
  outcome.converged         = true;
  outcome.failure           = "";
  outcome.relative_residual = graph_residual;
  problem.set_state(graph);
}

bool EquilibriumSearch::in_charts(const std::string &charts)
{
  const SurfaceState before = problem.state();
  if (charts == "graph")
    return iterate(PositionChart::graph, newton.max_iterations);
  if (charts == "ale")
    return iterate(PositionChart::ale, newton.max_iterations);
  if (charts == "automatic" && problem.discretization().has_junctions())
    return iterate(PositionChart::graph, newton.max_iterations);
  if (charts == "automatic")
  {
    if (problem.needs_material_chart())
      return iterate(PositionChart::material, newton.max_iterations);
    if (iterate(PositionChart::ale, std::min(newton.max_iterations, iterations_before_fallback)))
      return true;
    problem.set_state(before);
  }
  const bool may_fair = charts == "automatic";
  if (!iterate(PositionChart::graph, newton.max_iterations))
    return may_fair && from_faired_start(before);
  polish(may_fair ? std::optional<SurfaceState>(before) : std::nullopt);
  return true;
}

// For a start that is rough, and only for a start: an equilibrium on a load path is smooth, and what is lost by fairing
// might be its branch.
bool EquilibriumSearch::from_faired_start(const SurfaceState &start)
{
  const SurfaceDiscretization &surface = problem.discretization();
  const bool is_start                  = std::all_of(start.multipliers.begin(), start.multipliers.end(),
                                                     [](const double multiplier) { return multiplier == 0.; });
  if (!is_start || !surface.edges.empty() || !problem.nodal_conditions().empty() ||
      problem.layout().fields().size() > 2)
    return false;
  const SurfaceState last   = problem.state();
  const std::string failure = outcome.failure;
  SurfaceState faired       = start;
  faired.fields[0]          = faired_positions(surface, mesh_reference, start.fields[0]);
  try
  {
    problem.set_state(faired);
    if (iterate(PositionChart::ale, newton.max_iterations))
    {
      outcome.warnings.push_back("The start shape was too rough for Newton's method (" + failure +
                                 "): a smoothed one was used.");
      return true;
    }
  }
  catch (const SolveError &)
  {
  }
  problem.set_state(last);
  outcome.failure = failure;
  return false;
}

bool EquilibriumSearch::approach(const std::vector<std::size_t> &distant)
{
  const PotentialSet wanted = problem.potentials();
  const bool at_equilibrium = std::any_of(distant.begin(), distant.end(),
                                          [&](const std::size_t k) { return problem.state().multipliers[k] != 0.; });
  if (!at_equilibrium)
  {
    PotentialSet without = wanted;
    for (const std::size_t k : distant)
      without.constraints[k].stiffness = released;
    problem.set_potentials(without);
    if (!in_charts(newton.chart))
      return false;
  }
  const std::vector<double> start = problem.values().constraints;

  LoadParameters steps;
  steps.steps         = first_steps;
  steps.smallest_step = smallest_step;
  const double end    = walk_load(steps,
                                  [&](const double t)
                                  {
                                 if (t == 0.)
                                   return true;
                                 const SurfaceState before = problem.state();
                                 PotentialSet partial      = wanted;
                                 for (const std::size_t k : distant)
                                   partial.constraints[k].target =
                                       start[k] + t * (wanted.constraints[k].target - start[k]);
                                 problem.set_potentials(partial);
                                 if (in_charts(newton.chart))
                                   return true;
                                 problem.set_state(before);
                                 return false;
                               });
  problem.set_potentials(wanted);
  if (end < 1.)
  {
    const Constraint &constraint = wanted.constraints[distant.front()];
    outcome.converged            = false;
    outcome.failure              = "the target of the " + constraint.quantity + " could be approached only up to " +
                      std::to_string(static_cast<int>(100. * std::max(end, 0.))) + " % of the way from its free value";
  }
  return outcome.converged;
}
} // namespace pellicle

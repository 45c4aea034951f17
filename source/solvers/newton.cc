// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/solvers/newton.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pellicle
{
namespace
{
// Measured on vesicles in internal units (energy kappa, length sqrt(A/4 pi)); see doc/numerics.md.
constexpr double first_drag           = 10.;  // when undamped Newton is rejected
constexpr double smallest_drag        = 1e-2; // below it Newton is undamped again
constexpr double drag_decrease        = 0.01; // after each full step
constexpr double largest_drag         = 1e12; // beyond it no step is left
constexpr double round_off_of_merit   = 1e-9; // relative: predicted changes below it are accepted untested
constexpr double near_equilibrium     = 1e-4; // relative predicted change below which negative pivots are tolerated
constexpr double sufficient_decrease  = 1e-4; // Armijo
constexpr double tolerated_increase   = 1e-3; // of the merit, relative, where it is only a guard
constexpr double shortest_step        = 0.1;
constexpr double constraint_tolerance = 1e-11; // relative
constexpr double stagnation_displacement =
    1e-8; // relative displacement that counts as round-off if the residual is small too
constexpr double stagnation_residual = 1e-6;
// An undamped step that moves nothing, where the residual is all round-off: a thin shell under a very small load.
constexpr double no_displacement       = 1e-12;
constexpr double residual_of_round_off = 1e-3;
} // namespace

void NewtonParameters::bind(ParameterSection &section)
{
  section.integer("Maximum iterations", max_iterations, 1, 10000,
                  "Accepted Newton iterations per chart and load step before giving up; the first attempt of Chart = "
                  "automatic gives way to the second after 30.");
  section.number("Tolerance", tolerance, Range::between(1e-14, 1e-2), dimensions::none,
                 "Norm of the residual relative to the norm of the summed absolute contributions of the cells at which "
                 "a state counts as "
                 "an equilibrium. Fine meshes reach round-off near 1e-11; a step that no longer moves the nodes ends "
                 "the iteration as well.");
  section.number("Initial drag", initial_drag, Range::non_negative(), dimensions::none,
                 "Levenberg-Marquardt drag zeta in (zeta/2)|x - x_n|^2 of the first iteration, in units kappa/R^4, R = "
                 "sqrt(A/4 pi). It falls a hundredfold with each "
                 "full step and grows tenfold with each rejected one. 0: undamped Newton until a step is rejected.");
  section.number("Step limit", step_limit, Range::positive(), dimensions::none,
                 "Largest displacement of a node in one iteration, relative to R = sqrt(A/4 pi).");
  section.choice("Chart", chart, {"automatic", "ale", "graph", "graph then ale"},
                 "Unknowns of the position. ale: all components; normal equilibrium, and a mesh energy for the "
                 "tangential ones (good meshes in large deformation, "
                 "no bias). graph: displacement along the nodal normals (symmetric, descends to a minimum, robust "
                 "against noise). graph then ale: the first to find "
                 "the equilibrium, the second to polish it. automatic: ale, and if that fails graph then ale.");
  section.choice("Mesh reference", mesh_reference, {"start shape", "start of step"},
                 "Metric that the mesh energy of the ALE chart prefers. start shape: that of the start shape or, where "
                 "that is better, of the sphere it is a map of. "
                 "start of step: that of the surface at the start of the load step.");
  section.choice("Linear solver", linear_solver, linear_solver_names(),
                 "Direct solver: mumps (LDL^T with inertia, MPI) or umfpack (LU, one process).");
  section.integer("Threads", threads, 1, 256, "Threads of the BLAS in factorisations.");
  section.flag("Condition estimate", condition_estimate,
               "Factorise the matrix at each equilibrium once more and report its condition number and its smallest "
               "pivot (summary.json, linear_solver).");
}

Newton::Newton(const NewtonParameters &parameters, LinearSolver &solver, Timing &timing)
    : parameters(parameters)
    , solver(solver)
    , timing(timing)
{
}

NewtonResult Newton::solve(EquilibriumProblem &problem, const int step, Observer &observer, const int iterations_before)
{
  NewtonResult result;
  drag             = parameters.initial_drag;
  double last_move = std::numeric_limits<double>::infinity();
  IterationReport report;
  report.step = step;
  for (;;)
  {
    const double start = timing.total();
    problem.linearize();
    result.relative_residual = problem.relative_residual();
    if (result.iterations > 0)
    {
      report.relative_residual = result.relative_residual;
      report.energy            = problem.energy();
      observer.on_iteration(report);
    }
    const bool balanced = problem.constraint_violation() < constraint_tolerance;
    const bool at_round_off =
        (last_move < stagnation_displacement && result.relative_residual < stagnation_residual) ||
        (last_move < no_displacement && drag == 0. && result.relative_residual < residual_of_round_off);
    if (balanced && (result.relative_residual < parameters.tolerance || at_round_off))
    {
      result.converged = true;
      return result;
    }
    if (!std::isfinite(result.relative_residual))
    {
      result.failure = "the residual is not finite";
      return result;
    }
    if (result.iterations == parameters.max_iterations)
    {
      result.failure =
          "not converged in " + std::to_string(parameters.max_iterations) + " iterations (Newton/Maximum iterations)";
      return result;
    }
    report.iteration = iterations_before + result.iterations + 1;
    report.rejected  = 0;
    if (!advance(problem, result, report))
      return result;
    ++result.iterations;
    result.rejected += report.rejected;
    last_move      = report.step_length;
    report.seconds = timing.total() - start;
  }
}

bool Newton::advance(EquilibriumProblem &problem, NewtonResult &result, IterationReport &report)
{
  double drag_in_matrix = 0.;
  std::vector<double> direction;
  for (;; ++report.rejected)
  {
    // Step 1: direction
    if (drag > drag_in_matrix)
    {
      problem.add_drag(drag - drag_in_matrix);
      drag_in_matrix = drag;
    }
    try
    {
      const Timing::Scope scope(timing, "linear solve");
      solver.factorize(problem.matrix());
      direction = problem.residual();
      for (double &d : direction)
        d = -d;
      solver.solve(direction);
    }
    catch (const SolveError &error)
    {
      // Mostly where an iteration has gone astray: another chart or a shorter load step may still do better.
      result.failure = error.what();
      return false;
    }
    const std::optional<Inertia> inertia = solver.inertia();
    if (drag_in_matrix == 0.)
      result.inertia = inertia;
    const double displacement = problem.displacement(direction);
    if (!std::isfinite(displacement))
    {
      result.failure = "the linear system has no finite solution";
      return false;
    }

    // Step 2: where mesh equations replace some of the merit's, the merit only guards against going astray
    const double merit = problem.merit(direction), scale = 1. + std::abs(merit);
    if (!problem.is_variational())
    {
      const double length = std::min(1., parameters.step_limit / displacement);
      const double trial  = problem.try_step(direction, length);
      if (std::isfinite(trial) && trial <= merit + tolerated_increase * scale)
      {
        accept_trial(problem, length, displacement, report);
        return true;
      }
      if (!increase_drag(result))
        return false;
      continue;
    }

    // Step 3: is the direction one of descent, towards a minimum, and within the trust region?
    const double slope = problem.merit_slope(direction);
    // A drag raised by rejections makes any step small; it must still prove itself.
    const bool significant = std::abs(slope) > round_off_of_merit * scale || report.rejected > 0;
    const bool saddle =
        inertia && inertia->negative > problem.expected_negative_pivots() && std::abs(slope) > near_equilibrium * scale;
    if (!(significant && (slope >= 0. || saddle || displacement > parameters.step_limit)))
    {
      // Step 4: backtracking
      for (double length = 1.; length > shortest_step; length *= 0.5)
      {
        const double trial = problem.try_step(direction, length);
        if (!std::isfinite(trial) || (significant && trial > merit + sufficient_decrease * length * slope))
          continue;
        accept_trial(problem, length, displacement, report);
        return true;
      }
    }
    if (!increase_drag(result))
      return false;
  }
}

void Newton::accept_trial(EquilibriumProblem &problem, const double length, const double displacement,
                          IterationReport &report)
{
  problem.accept_trial();
  report.step_length = length * displacement;
  if (length == 1.)
    drag = drag_decrease * drag < smallest_drag ? 0. : drag_decrease * drag;
}

bool Newton::increase_drag(NewtonResult &result)
{
  drag = std::max(10. * drag, first_drag);
  if (drag > largest_drag)
    result.failure = "no step lowers the energy, however short";
  return drag <= largest_drag;
}
} // namespace pellicle

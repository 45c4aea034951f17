// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/observer.h>
#include <pellicle/base/parameters.h>
#include <pellicle/base/timing.h>
#include <pellicle/solvers/equilibrium_problem.h>
#include <pellicle/solvers/linear_solver.h>

#include <optional>
#include <string>

namespace pellicle
{
/** Section "Newton". */
struct NewtonParameters
{
  int max_iterations         = 60;
  double tolerance           = 1e-9;
  double initial_drag        = 100.;
  double step_limit          = 0.3;
  std::string chart          = "automatic";
  std::string mesh_reference = "start shape";
  std::string linear_solver  = "mumps";
  int threads                = 1;
  bool condition_estimate    = false;

  void bind(ParameterSection &section);
};

struct NewtonResult
{
  bool converged           = false;
  int iterations           = 0; ///< accepted steps
  int rejected             = 0; ///< factorisations whose step was not taken
  double relative_residual = 0.;
  std::optional<Inertia> inertia; ///< of the last factorised matrix without drag
  std::string failure;            ///< why it stopped, if not converged
};

/**
 * Newton's method for a minimum under constraints.
 *
 * Variational problems: Levenberg-Marquardt drag about the last iterate (so the residual is unbiased), backtracking on
 * the merit. The drag grows tenfold when the direction ascends, leaves the trust region (`step_limit`), the matrix has
 * negative pivots that a minimum must not have while the state is still far from equilibrium, or no step length lowers
 * the merit; it shrinks a hundredfold after each full step. Predicted changes of the merit at round-off level are
 * accepted without test, otherwise the line search fails on noise at the end. Others (ALE): full steps, shortened to
 * the trust region; drag is added when a step would raise the merit by more than a little.
 */
class Newton
{
public:
  Newton(const NewtonParameters &parameters, LinearSolver &solver, Timing &timing);

  /** Iterates from the problem's current state. Reports accepted iterations to the observer as iterations
   *  of `step`, counted from iterations_before + 1. */
  NewtonResult solve(EquilibriumProblem &problem, int step, Observer &observer, int iterations_before = 0);

private:
  /** Takes one step; false if none was found. */
  bool advance(EquilibriumProblem &problem, NewtonResult &result, IterationReport &report);

  /** Makes the trial the state; after a full step the drag falls. `displacement` is that of the full step. */
  void accept_trial(EquilibriumProblem &problem, double length, double displacement, IterationReport &report);

  /** False when the drag is beyond all reason. */
  bool increase_drag(NewtonResult &result);

  const NewtonParameters &parameters;
  LinearSolver &solver;
  Timing &timing;
  double drag = 0.;
};
} // namespace pellicle

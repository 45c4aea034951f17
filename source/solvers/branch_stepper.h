// SPDX-License-Identifier: LGPL-2.1-or-later
// Single steps along a branch: predictor, corrector, tangent. What to do with them is continuation.cc's business.
#pragma once

#include <pellicle/base/observer.h>
#include <pellicle/solvers/arc_length_problem.h>
#include <pellicle/solvers/continuation.h>

#include <functional>
#include <optional>
#include <string>

namespace pellicle::internal
{
/** A converged state of a branch, its unit tangent pointing ahead. */
struct BranchState
{
  double parameter = 0.;
  Tangent tangent;
  std::optional<int> unstable_modes;
  double slope       = 0.; ///< dp/d(length of the step from the base)
  double turn        = 0.; ///< angle with the base's tangent, radian
  int last_corrector = 0;  ///< iterations
};

/**
 * All steps start at the base, a state that the problem remembers. A step that fails has no value, and failure() says
 * why; the problem is anywhere then.
 */
class BranchStepper
{
public:
  BranchStepper(ParametrisedProblem &problem, const ContinuationParameters &parameters, const NewtonParameters &newton,
                LinearSolver &solver, Timing &timing, Observer &observer);

  /** Solves at the present parameter and takes the tangent in the given direction. */
  std::optional<BranchState> start(const StartDirection &direction);
  /** Makes the state, at which the problem is, the base of the steps to come to point number n. */
  void set_base(BranchState state, int n);
  const BranchState &base() const { return at; }

  /** One step of the given length. */
  std::optional<BranchState> step(double length);
  /** The state at the given parameter, at about that length from the base. */
  std::optional<BranchState> land(double length, double parameter);
  /** Back to the base. */
  void go_back() { problem.recall(); }

  const std::string &failure() const { return last_failure; }
  /** For the present point, all attempts together. */
  int iterations() const { return iterations_of_point; }

private:
  std::optional<BranchState> attempt(const std::function<BranchState()> &action);
  /** Newton's method; returns the number of iterations. Throws SolveError if it fails. */
  int correct(EquilibriumProblem &equations, LinearSolver &linear_solver);
  /** At the linearised state. The tangent is normalised, its sense is not chosen. Throws SolveError at a fold. */
  BranchState state_here();
  /** The state a step from the base has come to. Throws SolveError if the branch turns too much on the way. */
  BranchState arrival(int iterations);
  /** The longest correction of a step: the chord of an arc turns less than the tangent along it. */
  double reach(double length) const;

  ParametrisedProblem &problem;
  const double largest_turn; ///< degrees
  const double smallest_step;
  NewtonParameters corrector;
  LinearSolver &solver;
  Timing &timing;
  Observer &observer;

  BranchState at;
  std::optional<ArcLengthMetric> metric;
  std::string last_failure;
  int point               = 0;
  int iterations_of_point = 0;
};
} // namespace pellicle::internal

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/archive.h>
#include <pellicle/base/observer.h>
#include <pellicle/base/parameters.h>
#include <pellicle/base/timing.h>
#include <pellicle/solvers/arc_length_problem.h>
#include <pellicle/solvers/linear_solver.h>
#include <pellicle/solvers/newton.h>
#include <pellicle/solvers/parametrised_problem.h>

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pellicle
{
/** Section "Continuation". Steps are arc lengths in the problem's metric, without unit. */
struct ContinuationParameters
{
  double first_step     = 0.05;
  double smallest_step  = 1e-4;
  double largest_step   = 0.5;
  int max_points        = 200;
  double lower          = -std::numeric_limits<double>::infinity(); ///< of the parameter, in the problem's unit
  double upper          = std::numeric_limits<double>::infinity();
  int wanted_iterations = 4;
  double largest_turn   = 30.; ///< degrees

  void bind(ParameterSection &section);
};

/** Where a branch sets out from the state at hand. */
struct StartDirection
{
  double parameter_sign = 1.; ///< wanted sign of dp, if there is no mode
  std::vector<double> mode;   ///< a direction; empty: the tangent of the branch
  double amplitude = 0.;      ///< length of the first step along the mode

  static StartDirection increasing() { return {1., {}, 0.}; }
  static StartDirection decreasing() { return {-1., {}, 0.}; }
  /**
   * Leaves a bifurcation along its critical mode with dp = 0, onto the branch that is tangent to it. The mode's size
   * does not matter, its sign chooses the side. amplitude > 0 is in the metric of the arc length: large against the
   * distance of the state from the bifurcation, small against the size of the branch.
   */
  static StartDirection along(std::vector<double> mode, const double amplitude)
  {
    return {0., std::move(mode), amplitude};
  }
};

/** A converged state of the branch. */
struct BranchPoint
{
  double parameter         = 0.;
  double arc_length        = 0.; ///< from the start, summed along the tangents
  double tangent_parameter = 0.; ///< dp/ds of the unit tangent, ahead
  bool is_fold             = false;
  int iterations           = 0;      ///< of Newton's method, failed attempts included
  std::optional<int> unstable_modes; ///< negative pivots beyond the expected ones; without value where inertia is
                                     ///< unknown (solver, unsymmetric matrix, start along a mode)
};

enum class ContinuationEnd
{
  bound,   ///< the last point is at `lower` or `upper`
  points,  ///< max_points are made
  stopped, ///< on_point said so
  failed   ///< see ContinuationResult::failure
};

struct ContinuationResult
{
  ContinuationEnd end = ContinuationEnd::failed;
  int points          = 0; ///< calls of on_point
  int folds           = 0;
  int iterations      = 0;
  int rejected_steps  = 0;
  std::string failure; ///< why it stopped, if it failed

  void exchange(Archive &archive) { archive | end | points | folds | iterations | rejected_steps | failure; }
};

/** What a run needs, beside the problem's state at its last point, to go on from there. */
struct BranchPosition
{
  double parameter = 0.;
  Tangent tangent; ///< ahead, of length one
  double arc_length = 0.;
  double next_step  = 0.;
  std::optional<bool> rising; ///< whether the parameter rises ahead; no value at a start along a mode
  ContinuationResult so_far;

  void exchange(Archive &archive)
  {
    archive | parameter | tangent.direction | tangent.parameter | arc_length | next_step | rising | so_far;
  }
};

/**
 * Pseudo-arclength continuation (Keller 1977): follows the equilibria R(x; p) = 0 through folds, where a load that is
 * raised in steps has no solution nearby. Newton's method is the corrector, on unstable branches as well.
 *
 * A step of length s goes along the unit tangent t, K w = -dR/dp, t = (w, 1)/|(w, 1)|, and back to the branch in the
 * plane orthogonal to t. It is halved when the corrector fails (also in more than three times the wanted iterations) or
 * when the tangent, or the way to the new point, turns by more than `largest_turn`: a sign of another branch. The next
 * one is longer or shorter, by not more than a factor of two, in proportion to wanted over needed iterations, and such
 * that a tangent that bends as before turns by half of the allowed angle.
 *
 * Between two points with opposite signs of dp/ds there is a fold. It is located as a point of its own, with an error
 * of p of second order in what is left of dp/ds: below 1e-10 scales, and not better than Newton/Tolerance allows. A
 * branch that leaves [lower, upper] ends at the bound exactly, by a solve at fixed parameter.
 */
class Continuation
{
public:
  /** Called after each point, while the problem is there, unless the run ends with it. */
  using AfterPoint = std::function<void(const BranchPosition &position)>;

  /** Keeps references to the parameters, which must outlive it. Newton's initial drag and maximum of iterations are not
   * used. */
  Continuation(const ContinuationParameters &parameters, const NewtonParameters &newton, LinearSolver &solver,
               Timing &timing);

  /**
   * From the problem's current state, which must be close to an equilibrium (it is polished first).
   *
   * @param observer  gets Newton's iterations (step: number of the point, from 0) and a message for each halved step.
   * @param on_point  called at each point with the problem at that state, in the order of the branch, the start
   *                  included; returns whether to go on. After the run the problem is at the last point, unless the
   *                  first solve failed.
   *
   * Throws UserError if the present parameter is not in [lower, upper].
   */
  ContinuationResult run(ParametrisedProblem &problem, const StartDirection &start, Observer &observer,
                         const std::function<bool(const BranchPoint &)> &on_point, const AfterPoint &after_point = {});

  /** Goes on from a point of an earlier run, whose state the problem has taken up. What an uninterrupted run reports
   * from there on, and its result, are the same. */
  ContinuationResult go_on(ParametrisedProblem &problem, const BranchPosition &position, Observer &observer,
                           const std::function<bool(const BranchPoint &)> &on_point,
                           const AfterPoint &after_point = {});

private:
  const ContinuationParameters &parameters;
  const NewtonParameters &newton;
  LinearSolver &solver;
  Timing &timing;
};
} // namespace pellicle

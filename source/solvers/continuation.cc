// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/constants.h>
#include <pellicle/base/exact_text.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/solvers/continuation.h>

#include "branch_stepper.h"
#include "cubic_hermite.h"

#include <algorithm>
#include <cmath>

namespace pellicle
{
namespace
{
using internal::BranchState;
using internal::BranchStepper;
using internal::CubicHermite;
using internal::Knot;

constexpr double fold_tolerance = 1e-10; // of p at a fold, relative to its scale
constexpr int fold_attempts     = 8;     // the interpolation is of third order: two or three are the rule
constexpr double beside_a_fold  = 1e-4;  // of the bracket: the square is far below fold_tolerance
constexpr double largest_factor = 2.;    // between the lengths of consecutive steps

/** One run. */
class BranchWalk
{
public:
  BranchWalk(const ContinuationParameters &parameters, BranchStepper &stepper, const double parameter_scale,
             Observer &observer, const std::function<bool(const BranchPoint &)> &on_point,
             const Continuation::AfterPoint &after_point)
      : parameters(parameters)
      , stepper(stepper)
      , parameter_scale(parameter_scale)
      , observer(observer)
      , on_point(on_point)
      , after_point(after_point)
  {
  }

  ContinuationResult run(const StartDirection &start);
  ContinuationResult go_on(const BranchPosition &position);

private:
  /** A state ahead, and how it was found. */
  struct Next
  {
    BranchState state;
    double length = 0.; ///< from the base
    bool is_fold = false, at_bound = false;
  };

  /** Reports the point, and whether the run ends there. */
  bool ends_at(const Next &next);
  /** To the end, from a point that is reported. */
  ContinuationResult follow(Next next);
  /** Steps from the base, halving `length` until one succeeds. */
  std::optional<Next> advance();
  std::optional<Next> attempt();
  std::optional<Next> locate_fold(const Next &beyond);
  std::optional<Next> land_on_bound(const Next &beyond);
  void choose_length(const BranchState &reached);
  bool report(const Next &next);

  bool is_outside(const double p) const { return p < parameters.lower || p > parameters.upper; }
  bool leaves(const BranchState &state) const
  {
    return (state.parameter == parameters.lower && state.tangent.parameter < 0.) ||
           (state.parameter == parameters.upper && state.tangent.parameter > 0.);
  }
  Knot knot(const BranchState &state, const double at) const { return {at, state.parameter, state.slope}; }

  const ContinuationParameters &parameters;
  BranchStepper &stepper;
  const double parameter_scale;
  Observer &observer;
  const std::function<bool(const BranchPoint &)> &on_point;
  const Continuation::AfterPoint &after_point;

  ContinuationResult result;
  double arc_length = 0.;
  double length     = 0.; ///< of the next step
  /** Whether p rises ahead; no value at a start along a mode. At a fold dp/ds is too small to tell. */
  std::optional<bool> rising;
  std::string failure; ///< of the last attempt
};

ContinuationResult BranchWalk::run(const StartDirection &start)
{
  const std::optional<BranchState> first = stepper.start(start);
  if (!first)
  {
    result.iterations = stepper.iterations();
    result.failure    = "The branch cannot be started: " + stepper.failure() + ".";
    return result;
  }
  length = start.mode.empty() ? parameters.first_step : start.amplitude;
  if (start.mode.empty())
    rising = first->tangent.parameter > 0.;

  const Next next{*first, 0., false, leaves(*first)};
  return ends_at(next) ? result : follow(next);
}

ContinuationResult BranchWalk::go_on(const BranchPosition &position)
{
  result     = position.so_far;
  arc_length = position.arc_length;
  length     = position.next_step;
  rising     = position.rising;
  Next next;
  next.state.parameter = position.parameter;
  next.state.tangent   = position.tangent;
  return follow(next);
}

bool BranchWalk::ends_at(const Next &next)
{
  if (!report(next))
    result.end = ContinuationEnd::stopped;
  else if (next.at_bound)
    result.end = ContinuationEnd::bound;
  else if (result.points == parameters.max_points)
    result.end = ContinuationEnd::points;
  else
  {
    if (after_point)
      after_point({next.state.parameter, next.state.tangent, arc_length, length, rising, result});
    return false;
  }
  return true;
}

ContinuationResult BranchWalk::follow(Next next)
{
  do
  {
    stepper.set_base(next.state, result.points);
    const std::optional<Next> ahead = advance();
    if (!ahead)
    {
      result.iterations += stepper.iterations();
      result.failure = "The branch could not be followed beyond the parameter " + exact_text(stepper.base().parameter) +
                       ": steps down to " + exact_text(2. * length) + " failed, the last one because: " + failure +
                       ". Try a smaller Continuation/Smallest step or a finer mesh.";
      stepper.go_back();
      return result;
    }
    next = *ahead;
  } while (!ends_at(next));
  return result;
}

std::optional<BranchWalk::Next> BranchWalk::advance()
{
  for (;;)
  {
    if (std::optional<Next> next = attempt())
    {
      if (next->is_fold)
        rising = !*rising;
      else
      {
        rising = next->state.tangent.parameter > 0.;
        choose_length(next->state);
      }
      return next;
    }
    ++result.rejected_steps;
    observer.on_message("Continuation: a step of length " + exact_text(length) + " was halved: " + failure + ".");
    length *= 0.5;
    if (length < parameters.smallest_step)
      return std::nullopt;
  }
}

std::optional<BranchWalk::Next> BranchWalk::attempt()
{
  const std::optional<BranchState> reached = stepper.step(length);
  if (!reached)
  {
    failure = stepper.failure();
    return std::nullopt;
  }
  std::optional<Next> next = Next{*reached, length, false, leaves(*reached)};
  if (rising && (next->state.tangent.parameter > 0.) != *rising)
    next = locate_fold(*next);
  if (next && is_outside(next->state.parameter))
    next = land_on_bound(*next);
  return next;
}

std::optional<BranchWalk::Next> BranchWalk::locate_fold(const Next &beyond)
{
  Knot left = knot(stepper.base(), 0.), right = knot(beyond.state, beyond.length);
  if ((left.slope > 0.) == (right.slope > 0.))
  {
    failure = "there are two folds within it"; // a located one at its beginning and another one
    return std::nullopt;
  }
  for (int i = 0; i < fold_attempts; ++i)
  {
    double at                        = CubicHermite(left, right).place_of_extremum();
    std::optional<BranchState> state = stepper.step(at);
    if (!state)
    {
      // The matrix is singular at the fold itself, a little beside it not.
      at -= beside_a_fold * (at - left.at);
      state = stepper.step(at);
    }
    if (!state)
    {
      failure = "the fold within it could not be located (" + stepper.failure() + ")";
      return std::nullopt;
    }
    const double curvature = (right.slope - left.slope) / (right.at - left.at);
    if (state->slope * state->slope < 2. * std::abs(curvature) * fold_tolerance * parameter_scale)
      return Next{*state, at, true};
    ((state->slope > 0.) == (right.slope > 0.) ? right : left) = knot(*state, at);
  }
  failure = "the fold within it could not be located";
  return std::nullopt;
}

std::optional<BranchWalk::Next> BranchWalk::land_on_bound(const Next &beyond)
{
  const double bound = beyond.state.parameter > parameters.upper ? parameters.upper : parameters.lower;
  const double at    = CubicHermite(knot(stepper.base(), 0.), knot(beyond.state, beyond.length)).place_of_value(bound);
  const std::optional<BranchState> state = stepper.land(at, bound);
  if (!state)
  {
    failure = "no equilibrium was found at the bound " + exact_text(bound) + " (" + stepper.failure() + ")";
    return std::nullopt;
  }
  return Next{*state, at, false, true};
}

void BranchWalk::choose_length(const BranchState &reached)
{
  const double by_iterations = double(parameters.wanted_iterations) / std::max(1, reached.last_corrector);
  const double wanted_turn   = 0.5 * parameters.largest_turn * pi / 180.;
  const double by_turn       = reached.turn > 0. ? wanted_turn / reached.turn : largest_factor;
  length *= std::clamp(std::min(by_iterations, by_turn), 1. / largest_factor, largest_factor);
  length = std::clamp(length, parameters.smallest_step, parameters.largest_step);
}

bool BranchWalk::report(const Next &next)
{
  arc_length += next.length;
  ++result.points;
  result.folds += next.is_fold ? 1 : 0;
  result.iterations += stepper.iterations();
  BranchPoint point;
  point.parameter         = next.state.parameter;
  point.arc_length        = arc_length;
  point.tangent_parameter = next.state.tangent.parameter;
  point.is_fold           = next.is_fold;
  point.iterations        = stepper.iterations();
  point.unstable_modes    = next.state.unstable_modes;
  return on_point(point);
}
} // namespace

void ContinuationParameters::bind(ParameterSection &section)
{
  section.number("First step", first_step, Range::positive(), dimensions::none,
                 "Length of the first step along the branch: root mean square of the displacement relative to "
                 "R = sqrt(A/4 pi), and change of the parameter relative to its scale.");
  section.number("Smallest step", smallest_step, Range::positive(), dimensions::none,
                 "Length of a step below which the run gives up.");
  section.number("Largest step", largest_step, Range::positive(), dimensions::none,
                 "Length that steps do not exceed. Smaller: more points on the curve.");
  section.integer("Maximum points", max_points, 1, 1000000,
                  "The run ends after so many points of the branch, the start and folds included.");
  section.number("Lower", lower, Range::any().or_infinite(), dimensions::none,
                 "The run ends where the parameter falls below this value, exactly there. In the parameter's unit; "
                 "-inf: no bound.");
  section.number("Upper", upper, Range::any().or_infinite(), dimensions::none,
                 "The run ends where the parameter rises above this value, exactly there. In the parameter's unit; "
                 "inf: no bound.");
  section.integer("Wanted iterations", wanted_iterations, 1, 100,
                  "Newton iterations per step that the length of the steps aims at. A step that needs more than three "
                  "times as many is halved.");
  section.number("Largest turn", largest_turn, Range::between(0.1, 89.), dimensions::none,
                 "Largest angle, in degrees, between the tangents of consecutive points. A step that turns by more is "
                 "halved: it may have jumped to another branch.");
}

Continuation::Continuation(const ContinuationParameters &parameters, const NewtonParameters &newton,
                           LinearSolver &solver, Timing &timing)
    : parameters(parameters)
    , newton(newton)
    , solver(solver)
    , timing(timing)
{
}

ContinuationResult Continuation::run(ParametrisedProblem &problem, const StartDirection &start, Observer &observer,
                                     const std::function<bool(const BranchPoint &)> &on_point,
                                     const AfterPoint &after_point)
{
  const double p = problem.parameter();
  if (!(p >= parameters.lower && p <= parameters.upper))
    throw UserError("The parameter of the continuation is " + exact_text(p) +
                    " at the start, not between Continuation/Lower = " + exact_text(parameters.lower) +
                    " and Continuation/Upper = " + exact_text(parameters.upper) + ". Widen the bounds.");
  BranchStepper stepper(problem, parameters, newton, solver, timing, observer);
  return BranchWalk(parameters, stepper, problem.parameter_scale(), observer, on_point, after_point).run(start);
}

ContinuationResult Continuation::go_on(ParametrisedProblem &problem, const BranchPosition &position, Observer &observer,
                                       const std::function<bool(const BranchPoint &)> &on_point,
                                       const AfterPoint &after_point)
{
  BranchStepper stepper(problem, parameters, newton, solver, timing, observer);
  return BranchWalk(parameters, stepper, problem.parameter_scale(), observer, on_point, after_point).go_on(position);
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "branch_stepper.h"

#include <pellicle/base/exact_text.h>
#include <pellicle/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <utility>

namespace pellicle::internal
{
namespace
{
constexpr double degree = 0.017453292519943295; // radian

/** Counts also the iterations of a solve that ends with an exception. */
class IterationCounter : public Observer
{
public:
  IterationCounter(Observer &receiver, int &count)
      : receiver(receiver)
      , count(count)
  {
  }

  void on_iteration(const IterationReport &report) override
  {
    count = report.iteration;
    receiver.on_iteration(report);
  }

private:
  Observer &receiver;
  int &count;
};

void reverse(Tangent &tangent)
{
  for (double &d : tangent.direction)
    d = -d;
  tangent.parameter = -tangent.parameter;
}
} // namespace

BranchStepper::BranchStepper(ParametrisedProblem &problem, const ContinuationParameters &parameters,
                             const NewtonParameters &newton, LinearSolver &solver, Timing &timing, Observer &observer)
    : problem(problem)
    , largest_turn(parameters.largest_turn)
    , smallest_step(parameters.smallest_step)
    , corrector(newton)
    , solver(solver)
    , timing(timing)
    , observer(observer)
{
  corrector.initial_drag   = 0.;
  corrector.max_iterations = 3 * parameters.wanted_iterations;
}

std::optional<BranchState> BranchStepper::start(const StartDirection &direction)
{
  return attempt(
      [&]
      {
        StationaryProblem equations(problem);
        const int iterations = correct(equations, solver);
        metric.emplace(problem);
        BranchState state;
        if (direction.mode.empty())
        {
          state = state_here();
          if (state.tangent.parameter * direction.parameter_sign < 0.)
            reverse(state.tangent);
        }
        else
        {
          // The matrix is singular here, or nearly: no tangent, no inertia.
          state.parameter = problem.parameter();
          state.tangent   = {direction.mode, 0.};
          metric->normalize(state.tangent);
        }
        state.last_corrector = iterations;
        return state;
      });
}

void BranchStepper::set_base(BranchState state, const int n)
{
  at                  = std::move(state);
  point               = n;
  iterations_of_point = 0;
  // The caller's mode belongs to the chart it was computed in.
  if (point > 1 && problem.begin_step())
  {
    problem.linearize();
    metric.emplace(problem);
    // At a fold the matrix may be singular; the old direction still serves as predictor and plane.
    if (const std::optional<BranchState> in_new_chart = attempt([&] { return state_here(); }))
    {
      const double sense = metric->product(in_new_chart->tangent, at.tangent);
      at.tangent         = in_new_chart->tangent;
      if (sense < 0.)
        reverse(at.tangent);
    }
  }
  else
    metric.emplace(problem);
  metric->normalize(at.tangent);
  at.slope = at.tangent.parameter;
  at.turn  = 0.;
  problem.remember();
}

std::optional<BranchState> BranchStepper::step(const double length)
{
  return attempt(
      [&]
      {
        problem.recall();
        ArcLengthProblem equations(problem, *metric, at.tangent, reach(length));
        if (!equations.predict(length))
          throw SolveError("the predicted state makes no sense");
        BorderedSolver bordered(solver, equations.border());
        return arrival(correct(equations, bordered));
      });
}

std::optional<BranchState> BranchStepper::land(const double length, const double parameter)
{
  return attempt(
      [&]
      {
        problem.recall();
        if (!ArcLengthProblem(problem, *metric, at.tangent, reach(length)).predict(length))
          throw SolveError("the predicted state makes no sense");
        problem.set_parameter(parameter);
        StationaryProblem equations(problem);
        const int iterations = correct(equations, solver);
        if (metric->length({equations.moved(), 0.}) > reach(length))
          throw SolveError("the equilibrium is far from the branch");
        return arrival(iterations);
      });
}

std::optional<BranchState> BranchStepper::attempt(const std::function<BranchState()> &action)
{
  try
  {
    return action();
  }
  catch (const SolveError &error)
  {
    last_failure = error.what();
    while (!last_failure.empty() && last_failure.back() == '.') // it becomes a part of sentences
      last_failure.pop_back();
    return std::nullopt;
  }
}

int BranchStepper::correct(EquilibriumProblem &equations, LinearSolver &linear_solver)
{
  IterationCounter counter(observer, iterations_of_point);
  const NewtonResult result =
      Newton(corrector, linear_solver, timing).solve(equations, point, counter, iterations_of_point);
  if (result.converged)
    return result.iterations;
  if (result.iterations == corrector.max_iterations)
    throw SolveError("not converged in " + std::to_string(corrector.max_iterations) + " iterations");
  throw SolveError(result.failure);
}

BranchState BranchStepper::state_here()
{
  BranchState state;
  state.parameter         = problem.parameter();
  state.tangent.direction = problem.residual_derivative();
  {
    const Timing::Scope scope(timing, "linear solve");
    solver.factorize(problem.matrix());
    solver.solve(state.tangent.direction);
  }
  state.tangent.parameter = -1.; // K w = dR/dp so far
  metric->normalize(state.tangent);
  if (const std::optional<Inertia> inertia = solver.inertia())
    state.unstable_modes = inertia->negative - problem.expected_negative_pivots();
  return state;
}

double BranchStepper::reach(const double length) const
{
  return std::tan(largest_turn * degree) * std::max(length, smallest_step);
}

BranchState BranchStepper::arrival(const int iterations)
{
  BranchState state    = state_here();
  state.last_corrector = iterations;
  double cosine        = metric->product(state.tangent, at.tangent);
  if (cosine < 0.)
  {
    reverse(state.tangent);
    cosine = -cosine;
  }
  state.turn = std::acos(std::min(cosine, 1.));
  if (state.turn > largest_turn * degree)
    throw SolveError("the branch turns by " + std::to_string(std::lround(state.turn / degree)) +
                     " degrees in one step, more than the largest turn of " + exact_text(largest_turn));
  state.slope = state.tangent.parameter / cosine;
  return state;
}
} // namespace pellicle::internal

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exact_text.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/solvers/arc_length_problem.h>

#include <cmath>
#include <limits>

namespace pellicle
{
namespace
{
std::vector<double> without_parameter(const std::vector<double> &direction)
{
  return {direction.begin(), direction.end() - 1};
}
} // namespace

ArcLengthMetric::ArcLengthMetric(const ParametrisedProblem &problem)
    : weights(problem.weights())
    , parameter_scale(problem.parameter_scale())
{
  PELLICLE_ASSERT(parameter_scale > 0., "the scale of the parameter must be positive");
}

double ArcLengthMetric::product(const Tangent &a, const Tangent &b) const
{
  PELLICLE_ASSERT(a.direction.size() == weights.size() && b.direction.size() == weights.size(), "direction too short");
  double sum = (a.parameter / parameter_scale) * (b.parameter / parameter_scale);
  for (std::size_t i = 0; i < weights.size(); ++i)
    sum += weights[i] * a.direction[i] * b.direction[i];
  return sum;
}

double ArcLengthMetric::length(const Tangent &a) const
{
  return std::sqrt(product(a, a));
}

void ArcLengthMetric::normalize(Tangent &tangent) const
{
  const double norm = length(tangent);
  if (!std::isfinite(norm) || norm == 0.)
    throw SolveError("the tangent of the branch has no length");
  for (double &d : tangent.direction)
    d /= norm;
  tangent.parameter /= norm;
}

Border ArcLengthMetric::orthogonality(const Tangent &tangent) const
{
  Border border;
  for (std::size_t i = 0; i < weights.size(); ++i)
    border.row.push_back(weights[i] * tangent.direction[i]);
  border.corner = tangent.parameter / (parameter_scale * parameter_scale);
  return border;
}

void StationaryProblem::linearize()
{
  inner.linearize();
  accepted.resize(inner.residual().size(), 0.);
}

double StationaryProblem::try_step(const std::vector<double> &direction, const double length)
{
  trial = direction;
  for (double &t : trial)
    t *= length;
  return std::isfinite(inner.try_step(direction, length)) ? 0. : std::numeric_limits<double>::infinity();
}

void StationaryProblem::accept_trial()
{
  inner.accept_trial();
  for (std::size_t i = 0; i < accepted.size(); ++i)
    accepted[i] += trial[i];
}

ArcLengthProblem::ArcLengthProblem(ParametrisedProblem &problem, const ArcLengthMetric &metric, const Tangent &tangent,
                                   const double reach)
    : StationaryProblem(problem)
    , problem(problem)
    , metric(metric)
    , tangent(tangent)
    , reach(reach)
    , arc_border(metric.orthogonality(tangent))
{
}

bool ArcLengthProblem::predict(const double length)
{
  // The whole step is in the direction: multipliers move by the full direction, whatever the length.
  std::vector<double> step = tangent.direction;
  step.push_back(tangent.parameter);
  for (double &s : step)
    s *= length;
  if (!std::isfinite(try_step(step, 1.)))
    return false;
  take_trial();
  predicted_parameter = problem.parameter();
  return true;
}

void ArcLengthProblem::linearize()
{
  StationaryProblem::linearize();
  arc_border.column = problem.residual_derivative();
  extended_residual = problem.residual();
  extended_residual.push_back(0.);
}

// A trial is judged at the old parameter: whether a state makes sense is a matter of its shape.
double ArcLengthProblem::try_step(const std::vector<double> &direction, const double length)
{
  trial_parameter = problem.parameter() + length * direction.back();
  return StationaryProblem::try_step(without_parameter(direction), length);
}

void ArcLengthProblem::take_trial()
{
  StationaryProblem::accept_trial();
  problem.set_parameter(trial_parameter);
}

void ArcLengthProblem::accept_trial()
{
  take_trial();
  const double offset = metric.length({moved(), problem.parameter() - predicted_parameter});
  if (offset > reach)
    throw SolveError("the correction of the predicted state is too long, " + exact_text(offset));
}

double ArcLengthProblem::displacement(const std::vector<double> &direction) const
{
  const double of_state     = problem.displacement(without_parameter(direction));
  const double of_parameter = std::abs(direction.back()) / problem.parameter_scale();
  return !std::isfinite(of_state) || of_parameter <= of_state ? of_state : of_parameter; // keeps nan
}
} // namespace pellicle

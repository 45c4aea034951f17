// SPDX-License-Identifier: LGPL-2.1-or-later
// Branches of small problems that are known in closed form.
#include "expect_user_error.h"
#include "parametrised_problems.h"
#include "record.h"

#include <pellicle/base/constants.h>
#include <pellicle/solvers/continuation.h>
#include <pellicle/solvers/load_stepping.h>

#include "../mpi_environment.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace pellicle;
using namespace pellicle::synthetic;
using pellicle::test::Record;

/** A run, and at each of its points what continuation reports and the state. */
class Branch
{
public:
  explicit Branch(const std::string &solver_name = "mumps")
      : solver(make_linear_solver(solver_name))
  {
    newton.tolerance  = 1e-13;
    newton.step_limit = 1.;
  }

  const ContinuationResult &follow(BranchProblem &problem, const StartDirection &start)
  {
    points.clear();
    states.clear();
    result = Continuation(parameters, newton, *solver, timing)
                 .run(problem, start, record,
                      [&](const BranchPoint &point)
                      {
                        EXPECT_EQ(point.parameter, problem.p);
                        points.push_back(point);
                        states.push_back(problem.x);
                        for (const double g : problem.gradient())
                          EXPECT_NEAR(g, 0., 1e-10);
                        return !stop || !stop(point);
                      });
    EXPECT_EQ(std::size_t(result.points), points.size());
    EXPECT_EQ(problem.x, states.back()); // the problem stays at the last point
    EXPECT_EQ(problem.p, points.back().parameter);
    return result;
  }

  std::vector<std::size_t> folds() const
  {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (points[i].is_fold)
        found.push_back(i);
    return found;
  }

  ContinuationParameters parameters;
  NewtonParameters newton;
  std::unique_ptr<LinearSolver> solver;
  Timing timing;
  Record record;
  std::function<bool(const BranchPoint &)> stop;
  ContinuationResult result;
  std::vector<BranchPoint> points;
  std::vector<Vector> states;
};

const double s_curve_fold = 2. / (3. * std::sqrt(3.));

TEST(Continuation, PassesBothFoldsOfAnSCurve)
{
  for (const std::string solver : {"mumps", "umfpack"})
  {
    BranchProblem problem(s_curve(), {-1.5, -1.5}, -1.875);
    Branch branch(solver);
    branch.parameters.upper = 2.;
    const auto &result      = branch.follow(problem, StartDirection::increasing());
    EXPECT_EQ(result.end, ContinuationEnd::bound) << result.failure;
    EXPECT_EQ(result.folds, 2);
    const std::vector<std::size_t> folds = branch.folds();
    ASSERT_EQ(folds.size(), 2u);
    EXPECT_NEAR(branch.points[folds[0]].parameter, s_curve_fold, 1e-8);
    EXPECT_NEAR(branch.points[folds[1]].parameter, -s_curve_fold, 1e-8);
    EXPECT_NEAR(branch.states[folds[0]][0], -1. / std::sqrt(3.), 1e-4);
    for (std::size_t i = 0; i < branch.points.size(); ++i)
    {
      const double x = branch.states[i][0], p = branch.points[i].parameter;
      EXPECT_NEAR(p, x * x * x - x, 1e-10);
      EXPECT_NEAR(branch.states[i][1], x, 1e-10);
      if (i > 0)
      {
        EXPECT_GT(x, branch.states[i - 1][0]);
        EXPECT_GT(branch.points[i].arc_length, branch.points[i - 1].arc_length);
      }
      // dp/ds of the unit tangent: dp/dx = 3 x^2 - 1, ds^2 = 2 dx^2 + dp^2.
      const double rate = 3. * x * x - 1.;
      EXPECT_NEAR(branch.points[i].tangent_parameter, rate / std::sqrt(2. + rate * rate), 1e-8);
      if (solver == "umfpack")
      {
        EXPECT_FALSE(branch.points[i].unstable_modes);
      }
      else if (!branch.points[i].is_fold)
      {
        EXPECT_EQ(branch.points[i].unstable_modes.value(), rate < 0. ? 1 : 0);
      }
    }
    // The chords of the points and the reported arc length approximate the same curve.
    double chords = 0.;
    for (std::size_t i = 1; i < branch.points.size(); ++i)
      chords += std::sqrt(2. * std::pow(branch.states[i][0] - branch.states[i - 1][0], 2) +
                          std::pow(branch.points[i].parameter - branch.points[i - 1].parameter, 2));
    EXPECT_NEAR(branch.points.back().arc_length, chords, 0.02 * chords);
  }
}

// Nothing ends this branch but the number of points: round and round, two folds each time.
TEST(Continuation, GoesRoundACircle)
{
  BranchProblem problem(circle(), {1.}, 0.);
  Branch branch;
  branch.parameters.largest_step = 0.2;
  branch.parameters.max_points   = 150;
  const auto &result             = branch.follow(problem, StartDirection::decreasing());
  EXPECT_EQ(result.end, ContinuationEnd::points) << result.failure;
  EXPECT_EQ(result.points, 150);
  EXPECT_GE(result.folds, 6);
  double sign = -1.;
  for (const std::size_t i : branch.folds())
  {
    EXPECT_NEAR(branch.points[i].parameter, sign, 1e-8);
    sign = -sign;
  }
  for (std::size_t i = 0; i < branch.points.size(); ++i)
    EXPECT_NEAR(std::hypot(branch.states[i][0], branch.points[i].parameter), 1., 1e-10);
}

// Displacements that weigh little (the second scale) make sharp folds; next to one, Newton's method is led astray to
// the part of the branch that has snapped through.
// From each of its points in turn, off and at folds: the same points, to the last bit.
TEST(Continuation, GoesOnAsIfItHadNotStopped)
{
  BranchProblem problem(circle(), {1.}, 0.);
  Branch branch;
  branch.parameters.max_points = 12;
  std::vector<BranchPosition> positions;
  std::vector<Vector> states;
  std::vector<BranchPoint> points;
  const auto note = [&](const BranchPoint &point)
  {
    points.push_back(point);
    return true;
  };
  const ContinuationResult whole = Continuation(branch.parameters, branch.newton, *branch.solver, branch.timing)
                                       .run(problem, StartDirection::decreasing(), branch.record, note,
                                            [&](const BranchPosition &position)
                                            {
                                              positions.push_back(position);
                                              states.push_back(problem.x);
                                            });
  ASSERT_EQ(whole.end, ContinuationEnd::points) << whole.failure;
  ASSERT_GE(whole.folds, 1);
  const std::vector<BranchPoint> all = points;
  ASSERT_EQ(all.size(), 12u);
  ASSERT_EQ(positions.size(), 11u); // the last point is the end
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    Archive out;
    out | positions[i];
    Archive in(out.content());
    BranchPosition position;
    in | position;
    BranchProblem again(circle(), states[i], position.parameter);
    points.clear();
    const ContinuationResult rest =
        Continuation(branch.parameters, branch.newton, *make_linear_solver("mumps"), branch.timing)
            .go_on(again, position, branch.record, note);
    ASSERT_EQ(points.size(), all.size() - i - 1);
    for (std::size_t j = 0; j < points.size(); ++j)
    {
      EXPECT_EQ(points[j].parameter, all[i + 1 + j].parameter);
      EXPECT_EQ(points[j].arc_length, all[i + 1 + j].arc_length);
      EXPECT_EQ(points[j].is_fold, all[i + 1 + j].is_fold);
    }
    EXPECT_EQ(again.x, problem.x);
    EXPECT_EQ(rest.points, whole.points);
    EXPECT_EQ(rest.folds, whole.folds);
    EXPECT_EQ(rest.iterations, whole.iterations);
    EXPECT_EQ(rest.rejected_steps, whole.rejected_steps);
  }
}

TEST(Continuation, FindsTheLimitLoadsOfATruss)
{
  for (const double h : {0.3, 0.003})
    for (const double height_of_scale : {h, 3. * h})
    {
      const Truss truss{1., h};
      const double limit = truss.load(truss.height_at_limit());
      BranchProblem problem(truss.energy(), {0., 0.}, 0.);
      problem.scale = limit / height_of_scale;
      Branch branch;
      branch.newton.tolerance         = 1e-12 * limit;
      branch.parameters.first_step    = 0.1 * h;
      branch.parameters.largest_step  = h;
      branch.parameters.smallest_step = 1e-5 * h;
      branch.parameters.max_points    = 1000;
      branch.parameters.upper         = 3. * limit;
      const auto &result              = branch.follow(problem, StartDirection::increasing());
      EXPECT_EQ(result.end, ContinuationEnd::bound) << result.failure;
      const std::vector<std::size_t> folds = branch.folds();
      ASSERT_EQ(folds.size(), 2u) << "h = " << h << ", scale by " << height_of_scale;
      EXPECT_NEAR(branch.points[folds[0]].parameter / limit, 1., 1e-8);
      EXPECT_NEAR(branch.points[folds[1]].parameter / limit, -1., 1e-8);
      EXPECT_NEAR(branch.states[folds[0]][1], h - truss.height_at_limit(), 1e-4 * h);
      EXPECT_EQ(branch.points.back().parameter, 3. * limit);
      EXPECT_GT(branch.states.back()[1], 2. * h); // snapped through
      for (std::size_t i = 0; i < branch.points.size(); ++i)
        EXPECT_NEAR(branch.points[i].parameter / limit, truss.load(h - branch.states[i][1]) / limit, 1e-9);
    }
}

TEST(Continuation, VariesTheTargetOfAConstraint)
{
  BranchProblem problem(two_springs(), {-1., 0.}, -1.);
  problem.constraint = {1., 1.};
  Branch branch;
  branch.parameters.upper = 1.;
  const auto &result      = branch.follow(problem, StartDirection::increasing());
  EXPECT_EQ(result.end, ContinuationEnd::bound) << result.failure;
  const double x_fold                  = -1. / std::sqrt(6.);
  const std::vector<std::size_t> folds = branch.folds();
  ASSERT_EQ(folds.size(), 2u);
  EXPECT_NEAR(branch.points[folds[0]].parameter, 2. * std::pow(x_fold, 3) - x_fold, 1e-8);
  EXPECT_NEAR(branch.points[folds[1]].parameter, -2. * std::pow(x_fold, 3) + x_fold, 1e-8);
  for (std::size_t i = 0; i < branch.points.size(); ++i)
  {
    const double x = branch.states[i][0], p = branch.points[i].parameter;
    EXPECT_NEAR(p, 2. * x * x * x - x, 1e-10);
    EXPECT_NEAR(branch.states[i][0] + branch.states[i][1], p, 1e-10);
    if (!branch.points[i].is_fold)
    {
      EXPECT_EQ(branch.points[i].unstable_modes.value(), 6. * x * x < 1. ? 1 : 0);
    }
  }
  EXPECT_NEAR(problem.x[0], 1., 1e-10);
  EXPECT_NEAR(problem.lambda, 0., 1e-10);
}

TEST(Continuation, SwitchesBranchesAlongAMode)
{
  for (const double side : {1., -1.})
    for (const double before : {0., 1e-3}) // a bifurcation is known approximately
    {
      BranchProblem problem(pitchfork(), {0., -before}, -before);
      Branch branch;
      branch.parameters.upper = 0.7;
      const auto &result      = branch.follow(problem, StartDirection::along({2. * side, 0.}, 0.1));
      EXPECT_EQ(result.end, ContinuationEnd::bound) << result.failure;
      EXPECT_EQ(result.folds, 0);
      EXPECT_EQ(branch.points[0].tangent_parameter, 0.);
      EXPECT_FALSE(branch.points[0].unstable_modes);
      EXPECT_NEAR(branch.states[1][0], 0.1 * side, 1e-12); // the plane of the first step
      for (std::size_t i = 1; i < branch.points.size(); ++i)
      {
        EXPECT_NEAR(branch.states[i][0], side * std::sqrt(branch.points[i].parameter), 1e-10);
        EXPECT_EQ(branch.points[i].unstable_modes.value(), 0);
      }
    }
}

TEST(Continuation, PassesABifurcationOnItsBranch)
{
  BranchProblem problem(pitchfork(), {0., -0.52}, -0.52);
  Branch branch;
  branch.parameters.upper = 0.5;
  const auto &result      = branch.follow(problem, StartDirection::increasing());
  EXPECT_EQ(result.end, ContinuationEnd::bound) << result.failure;
  EXPECT_EQ(result.folds, 0);
  for (std::size_t i = 0; i < branch.points.size(); ++i)
  {
    EXPECT_NEAR(branch.states[i][0], 0., 1e-12);
    EXPECT_EQ(branch.points[i].unstable_modes.value(), branch.points[i].parameter > 0. ? 1 : 0);
  }
}

TEST(Continuation, PassesAFoldWhereLoadSteppingFails)
{
  Branch branch;
  branch.newton.max_iterations = 20;
  BranchProblem stepped(circle(), {1.}, 0.);
  LoadParameters load;
  const double reached =
      walk_load(load,
                [&](const double t)
                {
                  stepped.remember();
                  stepped.set_parameter(1.5 * t);
                  const bool found =
                      Newton(branch.newton, *branch.solver, branch.timing).solve(stepped, 0, branch.record).converged;
                  if (!found)
                    stepped.recall();
                  return found;
                });
  EXPECT_LE(1.5 * reached, 1.);
  EXPECT_GT(1.5 * reached, 0.99);

  BranchProblem followed(circle(), {1.}, 0.);
  branch.stop = [](const BranchPoint &point) { return point.parameter < 0.; };
  EXPECT_EQ(branch.follow(followed, StartDirection::increasing()).end, ContinuationEnd::stopped);
  EXPECT_EQ(branch.result.folds, 1);
  EXPECT_LT(followed.x[0], 0.);
}

TEST(Continuation, LandsOnBoundsExactly)
{
  // On a stable and on an unstable part, with falling and with rising parameter.
  for (const double upper : {-1., -0.37, 0.})
  {
    BranchProblem problem(s_curve(), {-1.5, -1.5}, -1.875);
    Branch branch;
    branch.parameters.upper = upper;
    EXPECT_EQ(branch.follow(problem, StartDirection::increasing()).end, ContinuationEnd::bound);
    EXPECT_EQ(branch.points.back().parameter, upper);
    EXPECT_LT(problem.x[0], -1. / std::sqrt(3.));
  }
  for (const double lower : {0.3, 0.01, -0.38})
  {
    BranchProblem problem(s_curve(), {-1., -1.}, 0.31);
    Branch branch;
    branch.parameters.lower = lower;
    EXPECT_EQ(branch.follow(problem, StartDirection::increasing()).end, ContinuationEnd::bound);
    EXPECT_EQ(branch.points.back().parameter, lower);
    EXPECT_EQ(branch.result.folds, 1);
    EXPECT_LT(std::abs(problem.x[0]), 1. / std::sqrt(3.)); // unstable
  }
}

// Both in one step: the branch turns back just behind the bound, or just before it.
TEST(Continuation, TellsAFoldBeforeABoundFromOneBehindIt)
{
  for (const double upper : {s_curve_fold - 1e-3, s_curve_fold + 1e-3})
  {
    BranchProblem problem(s_curve(), {-1.5, -1.5}, -1.875);
    Branch branch;
    branch.parameters.upper = upper;
    branch.parameters.lower = -1.9;
    EXPECT_EQ(branch.follow(problem, StartDirection::increasing()).end, ContinuationEnd::bound);
    EXPECT_EQ(branch.result.folds, upper < s_curve_fold ? 0 : 2);
    EXPECT_EQ(branch.points.back().parameter, upper);
    EXPECT_EQ(problem.x[0] < 0., upper < s_curve_fold);
  }
}

TEST(Continuation, EndsAtOnceAtABoundItHeadsBeyond)
{
  BranchProblem problem(s_curve(), {-1.5, -1.5}, -1.875);
  Branch branch;
  branch.parameters.lower = -1.875;
  EXPECT_EQ(branch.follow(problem, StartDirection::decreasing()).end, ContinuationEnd::bound);
  EXPECT_EQ(branch.result.points, 1);
  branch.parameters.upper = 0.3;
  branch.parameters.lower = -1.;
  EXPECT_USER_ERROR(branch.follow(problem, StartDirection::increasing()), "-1.875", "Continuation/Lower = -1");
}

// Where there is no state beyond x = -0.8, steps shrink towards it, and the run says so.
TEST(Continuation, HalvesStepsThatFailAndSaysWhyItGaveUp)
{
  BranchProblem problem(s_curve(), {-1.5, -1.5}, -1.875);
  problem.makes_sense = [](const Vector &x) { return x[0] < -0.8; };
  Branch branch;
  branch.parameters.smallest_step = 1e-3;
  const auto &result              = branch.follow(problem, StartDirection::increasing());
  EXPECT_EQ(result.end, ContinuationEnd::failed);
  EXPECT_LT(branch.states.back()[0], -0.8);
  EXPECT_GT(branch.states.back()[0], -0.81);
  EXPECT_GE(result.rejected_steps, 5);
  EXPECT_EQ(branch.record.messages.size(), std::size_t(result.rejected_steps));
  EXPECT_NE(branch.record.messages.front().find("was halved"), std::string::npos) << branch.record.messages.front();
  EXPECT_NE(result.failure.find("could not be followed beyond the parameter 0.2"), std::string::npos) << result.failure;
  EXPECT_NE(result.failure.find("makes no sense"), std::string::npos) << result.failure;
  EXPECT_NE(result.failure.find("Continuation/Smallest step"), std::string::npos) << result.failure;

  BranchProblem nowhere(circle(), {1.}, 1.1);
  Branch none("umfpack");
  const ContinuationResult failed =
      Continuation(none.parameters, none.newton, *none.solver, none.timing)
          .run(nowhere, StartDirection::increasing(), none.record, [](const BranchPoint &) { return true; });
  EXPECT_EQ(failed.end, ContinuationEnd::failed);
  EXPECT_EQ(failed.points, 0);
  EXPECT_NE(failed.failure.find("cannot be started: not converged in 12 iterations."), std::string::npos)
      << failed.failure;
}

TEST(Continuation, LengthensStepsWhereTheBranchIsStraightAndShortensThemWhereItTurns)
{
  BranchProblem problem(s_curve(), {-3., -3.}, -24.);
  Branch branch;
  branch.parameters.first_step   = 0.01;
  branch.parameters.largest_step = 4.;
  branch.parameters.largest_turn = 10.;
  branch.parameters.upper        = 24.;
  EXPECT_EQ(branch.follow(problem, StartDirection::increasing()).end, ContinuationEnd::bound);
  EXPECT_NEAR(branch.points[1].arc_length, 0.01, 1e-15);
  double longest = 0., longest_near_fold = 0.;
  for (std::size_t i = 1; i < branch.points.size(); ++i)
  {
    const double step = branch.points[i].arc_length - branch.points[i - 1].arc_length;
    EXPECT_LE(step, 4. + 1e-12);
    longest = std::max(longest, step);
    if (std::abs(branch.points[i].tangent_parameter) < 0.5)
      longest_near_fold = std::max(longest_near_fold, step);
    // Unit tangents: (1, 1, 3 x^2 - 1) for ds^2 = dx^2 + dy^2 + dp^2
    const double a = std::pow(branch.states[i - 1][0], 2) * 3. - 1., b = std::pow(branch.states[i][0], 2) * 3. - 1.;
    const double cosine = (2. + a * b) / std::sqrt((2. + a * a) * (2. + b * b));
    EXPECT_GT(cosine, std::cos(10.01 * pi / 180.));
  }
  EXPECT_GT(longest, 1.);
  EXPECT_LT(longest_near_fold, 0.5);
}

// Unknowns in axes that turn by ten degrees at each step: the branch knows nothing of it.
TEST(Continuation, RenewsTheChartBetweenSteps)
{
  BranchProblem fixed(s_curve(), {-1.5, -1.5}, -1.875), turning = fixed;
  turning.turn_of_chart = 0.17;
  Branch a, b;
  a.parameters.upper = b.parameters.upper = 1.875;
  a.follow(fixed, StartDirection::increasing());
  b.follow(turning, StartDirection::increasing());
  EXPECT_EQ(b.result.end, ContinuationEnd::bound) << b.result.failure;
  EXPECT_EQ(turning.steps_begun, b.result.points - 2); // not before the first step, not at the end
  ASSERT_EQ(a.points.size(), b.points.size());
  for (std::size_t i = 0; i < a.points.size(); ++i)
  {
    EXPECT_NEAR(a.points[i].parameter, b.points[i].parameter, 1e-8);
    EXPECT_EQ(a.points[i].is_fold, b.points[i].is_fold);
  }
}

TEST(Continuation, CountsIterationsOfEachPoint)
{
  BranchProblem problem(s_curve(), {-1.5, -1.5}, -1.875);
  Branch branch;
  branch.parameters.upper      = 1.;
  branch.parameters.first_step = branch.parameters.largest_step = 2.; // too long: attempts that fail count, too
  branch.follow(problem, StartDirection::increasing());
  EXPECT_GT(branch.result.rejected_steps, 0);
  int sum = 0;
  for (const BranchPoint &point : branch.points)
    sum += point.iterations;
  EXPECT_EQ(sum, branch.result.iterations);
  ASSERT_EQ(branch.record.iterations.size(), std::size_t(sum));
  int step = -1, iteration = 0;
  for (const IterationReport &report : branch.record.iterations)
  {
    iteration = report.step == step ? iteration + 1 : 1;
    EXPECT_GE(report.step, step);
    step = report.step;
    EXPECT_EQ(report.iteration, iteration);
  }
}

TEST(Continuation, ItsSectionHasAllParameters)
{
  ContinuationParameters parameters;
  ParameterSection section("Continuation");
  parameters.bind(section);
  std::vector<std::string> names;
  for (const auto &entry : section.entries())
    names.push_back(entry.name);
  EXPECT_EQ(names, (std::vector<std::string>{"First step", "Smallest step", "Largest step", "Maximum points", "Lower",
                                             "Upper", "Wanted iterations", "Largest turn"}));
  EXPECT_TRUE(section.entries()[4].range.contains(parameters.lower));
  EXPECT_TRUE(section.entries()[5].range.contains(parameters.upper));
}
} // namespace

// SPDX-License-Identifier: LGPL-2.1-or-later
// Newton's method on small functions of a few variables, with and without a constraint.
#include "record.h"
#include "synthetic_matrices.h"

#include <pellicle/solvers/newton.h>

#include "../mpi_environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace
{
using namespace pellicle;
using namespace pellicle::synthetic;
using pellicle::test::Record;
using Vector = std::vector<double>;

/** A function of x in R^n, its gradient and its Hessian by rows. */
struct Function
{
  std::function<double(const Vector &)> value;
  std::function<Vector(const Vector &)> gradient;
  std::function<std::vector<Vector>(const Vector &)> hessian;
};

/** Stationary points of f, under sum_i x_i = target if there is a constraint (a linear one, with multiplier lambda). */
class SmallProblem : public EquilibriumProblem
{
public:
  SmallProblem(Function function, Vector start)
      : f(std::move(function))
      , x(std::move(start))
  {
  }

  void constrain_sum(const double sum)
  {
    constrained = true;
    target      = sum;
  }

  void linearize() override
  {
    const std::vector<Vector> H = f.hessian(x);
    const int n = static_cast<int>(x.size()), size = n + (constrained ? 1 : 0);
    MatrixBuilder builder(variational ? MatrixSymmetry::symmetric : MatrixSymmetry::general, size);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        builder.add(i, j, H[i][j]);
    r = f.gradient(x);
    if (constrained)
    {
      for (int i = 0; i < n; ++i)
      {
        builder.add(n, i, 1.);
        builder.add(i, n, 1.);
        r[i] += lambda;
      }
      builder.add(n, n, 0.);
      r.push_back(violation());
    }
    sparse         = builder.matrix();
    drag_in_matrix = 0.;
  }
  const SparseMatrix &matrix() const override { return sparse; }
  const Vector &residual() const override { return r; }
  double relative_residual() const override
  {
    double sum = 0.;
    for (std::size_t i = 0; i < x.size(); ++i)
      sum += r[i] * r[i];
    return std::sqrt(sum) / 10.;
  }
  double constraint_violation() const override { return constrained ? std::abs(violation()) : 0.; }
  void add_drag(const double zeta) override
  {
    drag_in_matrix += zeta;
    largest_drag = std::max(largest_drag, drag_in_matrix);
    for (int i = 0; i < static_cast<int>(x.size()); ++i)
      for (int k = sparse.row_start[i]; k < sparse.row_start[i + 1]; ++k)
        if (sparse.columns[k] == i)
          sparse.values[k] += zeta;
  }
  bool is_variational() const override { return variational; }
  int expected_negative_pivots() const override { return constrained ? 1 : 0; }
  double merit_slope(const Vector &direction) const override
  {
    double slope = 0.;
    for (std::size_t i = 0; i < x.size(); ++i)
      slope += (r[i] + (constrained ? direction.back() + 2. * penalty * violation() : 0.)) * direction[i];
    return slope;
  }
  double merit(const Vector &direction) const override { return merit_at(x, direction); }
  double try_step(const Vector &direction, const double length) override
  {
    trial = x;
    for (std::size_t i = 0; i < x.size(); ++i)
      trial[i] += length * direction[i];
    trial_lambda = constrained ? lambda + direction.back() : 0.;
    return merit_at(trial, direction);
  }
  void accept_trial() override
  {
    x      = trial;
    lambda = trial_lambda;
  }
  double displacement(const Vector &direction) const override
  {
    double largest = 0.;
    for (std::size_t i = 0; i < x.size(); ++i)
      largest = std::max(largest, std::abs(direction[i]));
    return largest;
  }
  double energy() const override { return f.value(x); }

  Function f;
  Vector x;
  double lambda = 0., target = 0.;
  bool constrained = false, variational = true;
  double largest_drag = 0.;

private:
  static constexpr double penalty = 10.;

  double violation_at(const Vector &y) const
  {
    double sum = -target;
    for (const double yi : y)
      sum += yi;
    return sum;
  }
  double violation() const { return violation_at(x); }
  double merit_at(const Vector &y, const Vector &direction) const
  {
    if (!constrained)
      return f.value(y);
    const double v = violation_at(y);
    return f.value(y) + (lambda + direction.back()) * v + penalty * v * v;
  }

  SparseMatrix sparse;
  Vector r, trial;
  double drag_in_matrix = 0., trial_lambda = 0.;
};

/** Sum of cosh(x_i - i) + x_1 x_2 / 4: convex, not quadratic. */
Function convex()
{
  return {[](const Vector &x)
          { return std::cosh(x[0]) + std::cosh(x[1] - 1.) + std::cosh(x[2] - 2.) + 0.25 * x[0] * x[1]; },
          [](const Vector &x) {
            return Vector{std::sinh(x[0]) + 0.25 * x[1], std::sinh(x[1] - 1.) + 0.25 * x[0], std::sinh(x[2] - 2.)};
          },
          [](const Vector &x)
          {
            return std::vector<Vector>{
                {std::cosh(x[0]), 0.25, 0.}, {0.25, std::cosh(x[1] - 1.), 0.}, {0., 0., std::cosh(x[2] - 2.)}};
          }};
}

/** (x^2 - 1)^2 + 2 y^2: minima at (+-1, 0), a saddle at the origin. */
Function double_well()
{
  return {[](const Vector &x) { return std::pow(x[0] * x[0] - 1., 2) + 2. * x[1] * x[1]; },
          [](const Vector &x) {
            return Vector{4. * x[0] * (x[0] * x[0] - 1.), 4. * x[1]};
          },
          [](const Vector &x) {
            return std::vector<Vector>{{12. * x[0] * x[0] - 4., 0.}, {0., 4.}};
          }};
}

class NewtonOn
{
public:
  explicit NewtonOn(const std::string &solver_name = "mumps")
      : solver(make_linear_solver(solver_name))
  {
    parameters.initial_drag = 0.;
    parameters.step_limit   = 1e9;
  }
  NewtonResult solve(SmallProblem &problem, const int iterations_before = 0)
  {
    return Newton(parameters, *solver, timing).solve(problem, 3, record, iterations_before);
  }
  NewtonParameters parameters;
  std::unique_ptr<LinearSolver> solver;
  Timing timing;
  Record record;
};

TEST(Newton, ConvergesQuadratically)
{
  for (const bool constrained : {false, true})
    for (const std::string solver : {"mumps", "umfpack"})
    {
      SmallProblem problem(convex(), {1., 2., 0.8});
      if (constrained)
        problem.constrain_sum(4.5);
      NewtonOn newton(solver);
      newton.parameters.tolerance = 1e-13;
      const NewtonResult result   = newton.solve(problem);
      ASSERT_TRUE(result.converged) << result.failure;
      EXPECT_EQ(result.rejected, 0);
      const auto &reports = newton.record.iterations;
      ASSERT_EQ(reports.size(), static_cast<std::size_t>(result.iterations));
      int pairs = 0;
      for (std::size_t i = 1; i < reports.size(); ++i)
        if (const double before = reports[i - 1].relative_residual; before < 0.05)
        {
          ++pairs;
          EXPECT_LE(reports[i].relative_residual, 10. * before * before + 1e-15) << solver;
        }
      EXPECT_GE(pairs, 2);
      EXPECT_LE(result.iterations, 7);
      // The gradient of f is -lambda (1, 1, 1) there.
      const Vector g = problem.f.gradient(problem.x);
      for (const double gi : g)
        EXPECT_NEAR(gi, -problem.lambda, 1e-11);
      if (constrained)
      {
        EXPECT_NEAR(problem.x[0] + problem.x[1] + problem.x[2], 4.5, 1e-12);
        EXPECT_GT(std::abs(problem.lambda), 0.1);
      }
    }
}

TEST(Newton, ReportsWhatItDoes)
{
  SmallProblem problem(convex(), {0.3, 1., 1.7});
  NewtonOn newton;
  const NewtonResult result = newton.solve(problem, 10);
  ASSERT_TRUE(result.converged);
  ASSERT_FALSE(newton.record.iterations.empty());
  EXPECT_EQ(newton.record.iterations.front().iteration, 11);
  EXPECT_EQ(newton.record.iterations.back().iteration, 10 + result.iterations);
  EXPECT_EQ(newton.record.iterations.back().step, 3);
  EXPECT_EQ(newton.record.iterations.back().relative_residual, result.relative_residual);
  EXPECT_EQ(newton.record.iterations.back().energy, problem.energy());
  EXPECT_GT(newton.timing.seconds("linear solve"), 0.);
  ASSERT_TRUE(result.inertia);
  EXPECT_EQ(result.inertia->positive, 3);
  EXPECT_EQ(result.inertia->negative, 0);
}

TEST(Newton, NothingToDoAtAnEquilibrium)
{
  SmallProblem problem(double_well(), {1., 0.});
  NewtonOn newton;
  const NewtonResult result = newton.solve(problem);
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.iterations, 0);
  EXPECT_TRUE(newton.record.iterations.empty());
}

// At (0.5, 0) plain Newton goes up hill, to the maximum along x: f'' = -1 there, f' = -1.5.
TEST(Newton, AddsDragWhereTheDirectionAscends)
{
  SmallProblem problem(double_well(), {0.5, 0.});
  NewtonOn newton("umfpack"); // knows no inertia: the slope alone must tell
  const NewtonResult result = newton.solve(problem);
  ASSERT_TRUE(result.converged) << result.failure;
  EXPECT_GT(result.rejected, 0);
  EXPECT_GE(problem.largest_drag, 10.);
  EXPECT_NEAR(problem.x[0], 1., 1e-9);
  EXPECT_NEAR(problem.x[1], 0., 1e-9);
  EXPECT_EQ(newton.record.iterations.back().rejected, 0); // undamped at the end
}

// From (0.05, 1) the direction descends (y falls faster than the wrong x rises): only the signs of the pivots tell that
// it leads to the saddle.
TEST(Newton, LeavesASaddleWhereInertiaTells)
{
  SmallProblem problem(double_well(), {0.05, 1.});
  NewtonOn newton("mumps");
  const NewtonResult result = newton.solve(problem);
  ASSERT_TRUE(result.converged) << result.failure;
  EXPECT_NEAR(std::abs(problem.x[0]), 1., 1e-9);
  EXPECT_NEAR(problem.energy(), 0., 1e-12);
  EXPECT_GT(result.rejected, 0);
}

TEST(Newton, StaysWithinTheStepLimit)
{
  SmallProblem problem(convex(), {3., 4., 5.});
  NewtonOn newton;
  newton.parameters.step_limit = 0.3;
  const NewtonResult result    = newton.solve(problem);
  ASSERT_TRUE(result.converged) << result.failure;
  for (const IterationReport &report : newton.record.iterations)
    EXPECT_LE(report.step_length, 0.3);
  EXPECT_GT(problem.largest_drag, 0.);
}

TEST(Newton, ProblemsWithoutAMeritTakeShortenedFullSteps)
{
  SmallProblem problem(convex(), {3., 4., 5.});
  problem.variational = false;
  NewtonOn newton;
  newton.parameters.step_limit = 0.5;
  const NewtonResult result    = newton.solve(problem);
  ASSERT_TRUE(result.converged) << result.failure;
  EXPECT_EQ(problem.largest_drag, 0.);
  EXPECT_DOUBLE_EQ(newton.record.iterations.front().step_length, 0.5);
  EXPECT_FALSE(result.inertia);
}

TEST(Newton, SaysWhyItGaveUp)
{
  SmallProblem problem(convex(), {3., 4., 5.});
  NewtonOn newton;
  newton.parameters.max_iterations = 2;
  const NewtonResult result        = newton.solve(problem);
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.iterations, 2);
  EXPECT_NE(result.failure.find("not converged in 2 iterations"), std::string::npos) << result.failure;
  EXPECT_NE(result.failure.find("Newton/Maximum iterations"), std::string::npos) << result.failure;

  SmallProblem broken(convex(), {std::nan(""), 0., 0.});
  const NewtonResult not_finite = NewtonOn().solve(broken);
  EXPECT_FALSE(not_finite.converged);
  EXPECT_NE(not_finite.failure.find("not finite"), std::string::npos) << not_finite.failure;
}

// Nowhere but at the start is there a value.
TEST(Newton, GivesUpWhenNoStepLowersTheEnergy)
{
  const Vector start{1., 2., 3.};
  Function island  = convex();
  const auto value = island.value;
  island.value     = [value, start](const Vector &x)
  { return x == start ? value(x) : std::numeric_limits<double>::infinity(); };
  SmallProblem problem(island, start);
  const NewtonResult result = NewtonOn().solve(problem);
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.iterations, 0);
  EXPECT_EQ(problem.x, start);
  EXPECT_NE(result.failure.find("no step lowers the energy"), std::string::npos) << result.failure;
}
} // namespace

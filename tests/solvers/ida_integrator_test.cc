// SPDX-License-Identifier: LGPL-2.1-or-later
// Variable order and step on systems of a few unknowns with known solutions.
#include "synthetic_matrices.h"

#include <pellicle/base/exceptions.h>
#include <pellicle/solvers/ida_integrator.h>

#include "../mpi_environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace
{
using namespace pellicle;
using Vector = std::vector<double>;

/** F and the rows of dF/dy and dF/dy' as functions of y and y'. */
class SmallSystem : public ImplicitSystem
{
public:
  std::vector<bool> differential;
  std::function<Vector(const Vector &y, const Vector &v)> F;
  std::function<std::vector<Vector>(const Vector &y, const Vector &v)> dF_dy, dF_dv;
  std::function<double(const Vector &v)> power = [](const Vector &) { return 0.; };

  const std::vector<bool> &is_differential() const override { return differential; }
  void residual(double, const Vector &y, const Vector &v, Vector &result) override { result = F(y, v); }
  const SparseMatrix &tangent(double, const Vector &y, const Vector &v, const double alpha) override
  {
    const std::vector<Vector> A = dF_dy(y, v), B = dF_dv(y, v);
    const int n = static_cast<int>(y.size());
    synthetic::MatrixBuilder builder(MatrixSymmetry::general, n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        builder.add(i, j, A[i][j] + alpha * B[i][j]);
    matrix = builder.matrix();
    return matrix;
  }
  double dissipated_power(const Vector &, const Vector &v) override { return power(v); }

private:
  SparseMatrix matrix;
};

/** Descent of lambda y^2/2 with friction (eta/2) y'^2. */
SmallSystem decay(const double lambda, const double eta)
{
  SmallSystem system;
  system.differential = {true};
  system.F            = [=](const Vector &y, const Vector &v) { return Vector{eta * v[0] + lambda * y[0]}; };
  system.dF_dy        = [=](const Vector &, const Vector &) { return std::vector<Vector>{{lambda}}; };
  system.dF_dv        = [=](const Vector &, const Vector &) { return std::vector<Vector>{{eta}}; };
  system.power        = [=](const Vector &v) { return eta * v[0] * v[0]; };
  return system;
}

TEST(IdaIntegrator, FollowsAnExponentialAndItsDissipation)
{
  const double lambda = 3., eta = 2., t = 2.;
  SmallSystem system = decay(lambda, eta);
  double last_error  = 0.;
  for (const double tolerance : {1e-5, 1e-8})
  {
    const auto solver = make_linear_solver("umfpack");
    IdaIntegrator integrator(system, *solver, {tolerance, 0.01 * tolerance}, 0., {1.}, 0.5 * t);
    EXPECT_NEAR(integrator.rate()[0], -lambda / eta, tolerance); // the start was not consistent
    integrator.advance(0.5 * t);
    integrator.advance(t);
    const double y = std::exp(-lambda / eta * t), error = std::abs(integrator.y()[0] / y - 1.);
    EXPECT_EQ(integrator.time(), t);
    EXPECT_LT(error, 100. * tolerance);
    EXPECT_NEAR(integrator.dissipated(), 0.5 * lambda * (1. - y * y), 30. * tolerance);
    EXPECT_GT(integrator.statistics().last_order, 1);
    if (last_error > 0.)
    {
      EXPECT_LT(error, 0.1 * last_error);
    }
    last_error = error;
  }
}

// Robertson's reactions, y_1 + y_2 + y_3 = 1 in the place of the third rate equation; values at t = 40 from the stiff
// test set of Hairer and Wanner.
TEST(IdaIntegrator, SolvesAStiffAlgebraicSystemFromAnInconsistentStart)
{
  SmallSystem system;
  system.differential = {true, true, false};
  system.F            = [](const Vector &y, const Vector &v)
  {
    const double r = 1e4 * y[1] * y[2], s = 3e7 * y[1] * y[1];
    return Vector{v[0] + 0.04 * y[0] - r, v[1] - 0.04 * y[0] + r + s, y[0] + y[1] + y[2] - 1.};
  };
  system.dF_dy = [](const Vector &y, const Vector &)
  {
    return std::vector<Vector>{
        {0.04, -1e4 * y[2], -1e4 * y[1]}, {-0.04, 1e4 * y[2] + 6e7 * y[1], 1e4 * y[1]}, {1., 1., 1.}};
  };
  system.dF_dv = [](const Vector &, const Vector &) { return std::vector<Vector>{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}; };
  const auto solver = make_linear_solver("mumps");
  IdaIntegrator integrator(system, *solver, {1e-8, 1e-12}, 0., {1., 0., 0.3}, 0.4);
  EXPECT_NEAR(integrator.y()[2], 0., 1e-12);
  EXPECT_NEAR(integrator.rate()[0], -0.04, 1e-12);
  integrator.advance(40.);
  EXPECT_NEAR(integrator.y()[0], 0.7158270687193941, 1e-6);
  EXPECT_NEAR(integrator.y()[1], 0.9185534764557338e-5, 1e-10);
  EXPECT_NEAR(integrator.y()[2], 0.2841637457458413, 1e-6);
}

// A unit vector m in a field: two equations P(eta m' - e) = 0 and one for the length, m (m.m' + |m|^2 - 1) = 0. The
// angle to the field obeys tan(theta/2) = tan(theta_0/2) exp(-t/eta).
TEST(IdaIntegrator, TurnsAUnitVectorIntoTheField)
{
  SmallSystem system;
  const double eta    = 0.5;
  system.differential = {true, true};
  const auto h        = [=](const Vector &v) { return Vector{eta * v[0], eta * v[1] - 1.}; };
  const auto dot      = [](const Vector &a, const Vector &b) { return a[0] * b[0] + a[1] * b[1]; };
  system.F            = [=](const Vector &m, const Vector &v)
  {
    const double length = dot(m, v) + dot(m, m) - 1. - dot(m, h(v));
    return Vector{h(v)[0] + length * m[0], h(v)[1] + length * m[1]};
  };
  system.dF_dy = [=](const Vector &m, const Vector &v)
  {
    const double length = dot(m, v) + dot(m, m) - 1. - dot(m, h(v));
    std::vector<Vector> A(2, Vector(2));
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        A[i][j] = m[i] * (v[j] + 2. * m[j] - h(v)[j]) + (i == j ? length : 0.);
    return A;
  };
  system.dF_dv = [=](const Vector &m, const Vector &)
  {
    std::vector<Vector> B(2, Vector(2));
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        B[i][j] = (i == j ? eta : 0.) + m[i] * m[j] * (1. - eta);
    return B;
  };
  const double theta_0 = 3., t = 2.;
  const auto solver = make_linear_solver("umfpack");
  IdaIntegrator integrator(system, *solver, {1e-7, 1e-9}, 0., {std::sin(theta_0), std::cos(theta_0)}, t);
  integrator.advance(t);
  const Vector &m = integrator.y();
  EXPECT_NEAR(std::hypot(m[0], m[1]), 1., 1e-6);
  EXPECT_NEAR(std::atan2(m[0], m[1]), 2. * std::atan(std::tan(0.5 * theta_0) * std::exp(-t / eta)), 3e-6);
}

TEST(IdaIntegrator, SaysWhereItStopped)
{
  SmallSystem blow_up; // y = 1/(1 - t), of which F knows no more than y < 4
  blow_up.differential = {true};
  blow_up.F            = [](const Vector &y, const Vector &v) -> Vector
  {
    if (y[0] > 4.)
      throw SolveError("y is too large");
    return {v[0] - y[0] * y[0]};
  };
  blow_up.dF_dy     = [](const Vector &y, const Vector &) { return std::vector<Vector>{{-2. * y[0]}}; };
  blow_up.dF_dv     = [](const Vector &, const Vector &) { return std::vector<Vector>{{1.}}; };
  const auto solver = make_linear_solver("umfpack");
  IdaIntegrator integrator(blow_up, *solver, {}, 0., {1.}, 0.5);
  integrator.advance(0.5);
  EXPECT_NEAR(integrator.y()[0], 2., 1e-4);
  try
  {
    integrator.advance(2.);
    FAIL() << "the solution ends at t = 3/4";
  }
  catch (const SolveError &error)
  {
    EXPECT_NEAR(integrator.time(), 0.75, 1e-3);
    EXPECT_NE(std::string(error.what()).find("The integrator ida stopped at time "), std::string::npos) << error.what();
  }
}

TEST(IdaIntegrator, RefusesASingularSystemAndLetsForeignErrorsThrough)
{
  SmallSystem singular  = decay(1., 1.);
  singular.differential = {true, false};
  singular.F            = [](const Vector &y, const Vector &v) { return Vector{v[0] + y[0] + y[1], y[0] - 1.}; };
  singular.dF_dy        = [](const Vector &, const Vector &) { return std::vector<Vector>{{1., 0.}, {1., 0.}}; };
  singular.dF_dv        = [](const Vector &, const Vector &) { return std::vector<Vector>{{1., 0.}, {0., 0.}}; };
  const auto solver     = make_linear_solver("umfpack");
  EXPECT_THROW(IdaIntegrator(singular, *solver, {}, 0., {2., 0.}, 1.), SolveError);

  SmallSystem broken = decay(1., 1.);
  broken.F           = [](const Vector &, const Vector &) -> Vector { throw UserError("a mistake"); };
  EXPECT_THROW(IdaIntegrator(broken, *solver, {}, 0., {1.}, 1.), UserError);
}
} // namespace

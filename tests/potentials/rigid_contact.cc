// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/kinematics/rigid_bodies.h>
#include <pellicle/potentials/contact/contact_law.h>
#include <pellicle/potentials/contact/reduced_contact.h>
#include <pellicle/potentials/contact/rigid_contact.h>
#include <pellicle/potentials/surface_measures.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace
{
using namespace pellicle;

std::shared_ptr<const std::vector<double>> per_point(std::vector<double> values)
{
  return std::make_shared<const std::vector<double>>(std::move(values));
}

std::shared_ptr<const RigidBody> ball()
{
  return std::make_shared<Ball>(Vector3<double>{0., 0., -2.}, 2.);
}

/** Near the top of the ball, with some base vectors: x, x,1, x,2. */
std::vector<double> point_at(const double height)
{
  return {0.3, -0.2, height, 1., 0.2, 0.1, -0.3, 0.9, 0.2};
}

constexpr double inside = -0.2, outside = 0.4;

struct Sums
{
  PointSums sums;

  Sums(const Potential &potential, const std::vector<double> &inputs, const double factor = 1.)
  {
    const unsigned int n = inputs.size(), offset = 0;
    sums.reset(1, n, Order::hessian);
    potential.add({0, 1, n, inputs.data()}, &offset, factor, Order::hessian, sums);
  }
};

/** Gradient and Hessian against differences of value and gradient, symmetry, and the other orders. */
void check_derivatives(const Potential &potential, const std::vector<double> &inputs)
{
  const double h = 1e-5, factor = -1.7;
  const unsigned int n = inputs.size(), offset = 0;
  const PointSums at = Sums(potential, inputs, factor).sums;
  for (unsigned int j = 0; j < n; ++j)
  {
    std::vector<double> more = inputs, less = inputs;
    more[j] += h;
    less[j] -= h;
    const PointSums plus = Sums(potential, more, factor).sums, minus = Sums(potential, less, factor).sums;
    EXPECT_NEAR(at.gradient[j], (plus.value[0] - minus.value[0]) / (2. * h), 1e-7) << j;
    for (unsigned int i = 0; i < n; ++i)
    {
      EXPECT_NEAR(at.hessian[i * n + j], (plus.gradient[i] - minus.gradient[i]) / (2. * h), 1e-7) << i << "," << j;
      EXPECT_NEAR(at.hessian[i * n + j], at.hessian[j * n + i], 1e-13);
    }
  }
  PointSums value, gradient;
  value.reset(1, n, Order::value);
  gradient.reset(1, n, Order::gradient);
  potential.add({0, 1, n, inputs.data()}, &offset, factor, Order::value, value);
  potential.add({0, 1, n, inputs.data()}, &offset, factor, Order::gradient, gradient);
  EXPECT_EQ(value.value, at.value);
  EXPECT_EQ(gradient.gradient, at.gradient);
}

TEST(RigidContact, DerivativesInBothMeasures)
{
  const ContactPoints points{per_point({0.7}), per_point({1.3})};
  for (const ContactMeasure measure : {ContactMeasure::reference, ContactMeasure::current})
    for (const double height : {inside, 0.02, outside})
      check_derivatives(RigidContact(ball(), 3.1, points, measure), point_at(height));
}

TEST(RigidContact, ValuesOfTheLaw)
{
  const double eps = 10., g = -0.1, lambda = 0.5, area = 2.;
  const auto plane = std::make_shared<HalfSpace>(Vector3<double>{0., 0., 0.}, Vector3<double>{0., 0., 1.});
  const RigidContact contact(plane, eps, {per_point({lambda}), per_point({area})});
  const PointSums pressed = Sums(contact, {1., 2., g}).sums; // t = 0.5 + 1
  EXPECT_NEAR(pressed.value[0], area * (1.5 * 1.5 - lambda * lambda) / (2. * eps), 1e-15);
  EXPECT_NEAR(pressed.gradient[2], -area * 1.5, 1e-14);
  EXPECT_NEAR(pressed.hessian[8], area * eps, 1e-14);
  const PointSums lifted = Sums(contact, {1., 2., 0.06}).sums; // t = 0
  EXPECT_NEAR(lifted.value[0], -area * lambda * lambda / (2. * eps), 1e-15);
  EXPECT_EQ(lifted.gradient[2], 0.);
  EXPECT_EQ(lifted.hessian[8], 0.);
  const PointSums on_the_law = Sums(contact, {1., 2., 0.}).sums; // g = 0, t = lambda
  EXPECT_EQ(on_the_law.value[0], 0.);
  EXPECT_EQ(on_the_law.gradient[2], -area * lambda);
}

// On the law, g = 0, both measures give the same force if lambda dA = p da.
TEST(RigidContact, MeasuresAgreeOnTheLaw)
{
  std::vector<double> inputs = point_at(0.);
  inputs[2]                  = std::sqrt(4. - 0.13) - 2.;
  const double J  = norm(cross(Vector3<double>{inputs[3], inputs[4], inputs[5]}, {inputs[6], inputs[7], inputs[8]}));
  const double dA = 1.3, lambda = 0.7;
  const RigidContact reference(ball(), 3.1, {per_point({lambda}), per_point({dA})}),
      current(ball(), 3.1, {per_point({lambda * dA / J}), nullptr}, ContactMeasure::current);
  const PointSums a = Sums(reference, inputs).sums, b = Sums(current, inputs).sums;
  for (unsigned int i = 0; i < 9; ++i)
    EXPECT_NEAR(a.gradient[i], b.gradient[i], 1e-15) << i;
}

TEST(RigidContact, UpdateOfMultipliers)
{
  std::vector<double> lambda  = {0., 1., 1., 0.};
  const ContactUpdate update  = update_multipliers(lambda, {-0.2, 0.02, 0.3, 0.5}, 10.);
  const std::vector<double> t = {2., 0.8, 0., 0.};
  for (unsigned int q = 0; q < 4; ++q)
    EXPECT_NEAR(lambda[q], t[q], 1e-15);
  EXPECT_NEAR(update.violation, 0.2, 1e-15);
  EXPECT_EQ(update.n_active, 2u);
  EXPECT_EQ(update_multipliers(lambda, {0., 0., 0.3, 0.5}, 10.).violation, 0.);
}

/** A square of unit area with 2 x 2 points of Gauss and bilinear heights of its corners, pressed onto the plane z = 0
 * with the pressure P from above: Newton's method for the heights. */
std::array<double, 4> heights_under_pressure(const Potential &contact, const double P)
{
  const double gauss[2]   = {0.5 - std::sqrt(1. / 12.), 0.5 + std::sqrt(1. / 12.)};
  std::array<double, 4> z = {-0.03, 0.02, -0.01, 0.};
  for (int step = 0; step < 6; ++step)
  {
    double r[4] = {}, K[4][5] = {};
    for (unsigned int q = 0; q < 4; ++q)
    {
      const double u = gauss[q % 2], v = gauss[q / 2];
      const double N[4] = {(1. - u) * (1. - v), u * (1. - v), (1. - u) * v, u * v};
      double height     = 0.;
      for (unsigned int i = 0; i < 4; ++i)
        height += N[i] * z[i];
      PointSums sums;
      const unsigned int offset     = 0;
      const std::array<double, 3> x = {u, v, height};
      sums.reset(1, 3, Order::hessian);
      contact.add({q, 1, 3, x.data()}, &offset, 1., Order::hessian, sums);
      for (unsigned int i = 0; i < 4; ++i)
      {
        r[i] += 0.25 * N[i] * (P + sums.gradient[2]);
        for (unsigned int j = 0; j < 4; ++j)
          K[i][j] += 0.25 * N[i] * N[j] * sums.hessian[8];
      }
    }
    // Gauss elimination; K is the mass matrix times eps when all points are in contact.
    for (unsigned int i = 0; i < 4; ++i)
      K[i][4] = -r[i];
    for (unsigned int i = 0; i < 4; ++i)
      for (unsigned int k = 0; k < 4; ++k)
        if (k != i)
        {
          const double ratio = K[k][i] / K[i][i];
          for (unsigned int j = i; j < 5; ++j)
            K[k][j] -= ratio * K[i][j];
        }
    for (unsigned int i = 0; i < 4; ++i)
      z[i] += K[i][4] / K[i][i];
  }
  return z;
}

TEST(RigidContact, PatchUnderUniformPressure)
{
  const double P = 0.8, eps = 20.;
  const auto lambda = std::make_shared<std::vector<double>>(4, 1.); // all points start in contact
  const auto plane  = std::make_shared<HalfSpace>(Vector3<double>{0., 0., 0.}, Vector3<double>{0., 0., 1.});
  const RigidContact contact(plane, eps, {lambda, per_point({1., 1., 1., 1.})});
  std::array<double, 4> z = heights_under_pressure(contact, P);
  for (const double height : z)
    EXPECT_NEAR(height, (1. - P) / eps, 1e-15);
  update_multipliers(*lambda, std::vector<double>(4, z[0]), eps);
  for (const double t : *lambda)
    EXPECT_NEAR(t, P, 1e-15);
  z = heights_under_pressure(contact, P);
  for (const double height : z)
    EXPECT_NEAR(height, 0., 1e-15);
  EXPECT_LT(update_multipliers(*lambda, {z[0], z[1], z[2], z[3]}, eps).violation, 1e-15);
}

std::array<double, n_reduced_contact_inputs> reduced_inputs(const double height, const double p)
{
  std::array<double, n_reduced_contact_inputs> inputs{};
  const std::vector<double> point = point_at(height);
  std::copy(point.begin(), point.end(), inputs.begin());
  inputs[9] = p;
  return inputs;
}

TEST(ReducedContact, TangentIsTheDerivativeOfTheResidual)
{
  constexpr unsigned int n = n_reduced_contact_inputs;
  const double h           = 1e-5;
  for (const double height : {inside, outside})
  {
    const auto inputs       = reduced_inputs(height, 0.7);
    const ReducedContact at = reduced_contact(*ball(), inputs, 3.1);
    for (unsigned int j = 0; j < n; ++j)
    {
      auto more = inputs, less = inputs;
      more[j] += h;
      less[j] -= h;
      const auto plus  = reduced_contact(*ball(), more, 3.1).residual,
                 minus = reduced_contact(*ball(), less, 3.1).residual;
      for (unsigned int i = 0; i < n; ++i)
        EXPECT_NEAR(at.tangent[i * n + j], (plus[i] - minus[i]) / (2. * h), 1e-8) << i << "," << j;
    }
  }
}

// The asymmetry is that of -(t dg + g dp) DJ, and nothing else: what the residual leaves out.
TEST(ReducedContact, AsymmetryIsThatOfTheMissingChangeOfArea)
{
  constexpr unsigned int n = n_reduced_contact_inputs;
  const double p = 0.7, eps = 3.1;
  const auto inputs      = reduced_inputs(inside, p);
  const auto K           = reduced_contact(*ball(), inputs, eps).tangent;
  const GapSample sample = ball()->gap({inputs[0], inputs[1], inputs[2]});
  const AreaDerivatives area({inputs[3], inputs[4], inputs[5]}, {inputs[6], inputs[7], inputs[8]});
  std::array<double, n> v{}, dJ{};
  for (unsigned int c = 0; c < 3; ++c)
  {
    v[c]      = (p - eps * sample.gap) * sample.normal[c];
    dJ[3 + c] = area.dJ[0][c];
    dJ[6 + c] = area.dJ[1][c];
  }
  v[9]           = sample.gap;
  double largest = 0.;
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
    {
      EXPECT_NEAR(K[i * n + j] - K[j * n + i], -v[i] * dJ[j] + dJ[i] * v[j], 1e-14) << i << "," << j;
      largest = std::max(largest, std::abs(K[i * n + j] - K[j * n + i]));
    }
  EXPECT_GT(largest, 0.1);
}

// The forces on x are those of the energy with all terms; what is missing acts on x,1 and x,2 only.
TEST(ReducedContact, ForceIsThatOfTheFullForm)
{
  const auto inputs  = reduced_inputs(inside, 0.7);
  const auto reduced = reduced_contact(*ball(), inputs, 3.1).residual;
  const RigidContact full(ball(), 3.1, {per_point({0.7}), nullptr}, ContactMeasure::current);
  const PointSums sums = Sums(full, point_at(inside)).sums;
  for (unsigned int c = 0; c < 3; ++c)
    EXPECT_NEAR(reduced[c], sums.gradient[c], 1e-14);
  for (unsigned int c = 3; c < 9; ++c)
    EXPECT_EQ(reduced[c], 0.);
  EXPECT_GT(std::abs(sums.gradient[3]), 0.01);
}
} // namespace

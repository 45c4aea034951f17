// SPDX-License-Identifier: LGPL-2.1-or-later
#include "gap_checks.h"

#include <pellicle/kinematics/find_kink.h>
#include <pellicle/kinematics/height_field.h>

#include <functional>
#include <memory>
#include <random>

namespace
{
using namespace pellicle;

/** A function of place by its formula. */
class Formula : public FunctionOfPlace
{
public:
  Formula(std::string name, std::function<PlaceSample(double, double)> formula)
      : name(std::move(name))
      , formula(std::move(formula))
  {
  }
  PlaceSample at(const double x, const double y) const override { return formula(x, y); }
  const std::string &text() const override { return name; }

private:
  std::string name;
  std::function<PlaceSample(double, double)> formula;
};

std::shared_ptr<const FunctionOfPlace> slope()
{
  return std::make_shared<Formula>("x/2 - y + 1", [](const double x, const double y)
                                   { return PlaceSample{0.5 * x - y + 1., 0.5, -1., 0., 0., 0.}; });
}

/** The upper half of the unit sphere (sign 1), or the lower one. */
std::shared_ptr<const FunctionOfPlace> half_sphere(const double sign)
{
  return std::make_shared<Formula>("half sphere",
                                   [sign](const double x, const double y)
                                   {
                                     const double h = std::sqrt(1. - x * x - y * y), h3 = h * h * h;
                                     return PlaceSample{sign * h,           -sign * x / h,
                                                        -sign * y / h,      -sign * (1. - y * y) / h3,
                                                        -sign * x * y / h3, -sign * (1. - x * x) / h3};
                                   });
}

std::shared_ptr<const FunctionOfPlace> waves()
{
  return std::make_shared<Formula>(
      "0.1*sin(2*x)*cos(3*y)",
      [](const double x, const double y)
      {
        const double s = std::sin(2. * x), c = std::cos(2. * x), S = std::sin(3. * y), C = std::cos(3. * y);
        return PlaceSample{0.1 * s * C, 0.2 * c * C, -0.3 * s * S, -0.4 * s * C, -0.6 * c * S, -0.9 * s * C};
      });
}

std::shared_ptr<const FunctionOfPlace> parabola()
{
  return std::make_shared<Formula>("x^2",
                                   [](const double x, double) { return PlaceSample{x * x, 2. * x, 0., 2., 0., 0.}; });
}

/** c |x - a|^p, p = 1, 2 (times the sign) or 3: the derivative of order p jumps. */
Formula kinked(const int p, const double a = 0.3, const double c = 1.)
{
  return Formula("kinked",
                 [p, a, c](const double x, double)
                 {
                   const double u = x - a, sign = u / std::abs(u);
                   if (p == 1)
                     return PlaceSample{c * std::abs(u), c * sign, 0., 0., 0., 0.};
                   if (p == 2)
                     return PlaceSample{c * sign * u * u, 2. * c * std::abs(u), 0., 2. * c * sign, 0., 0.};
                   return PlaceSample{c * sign * u * u * u, 3. * c * sign * u * u, 0., 6. * c * std::abs(u), 0., 0.};
                 });
}

std::pair<double, double> circle(const double s)
{
  return {std::cos(2. * M_PI * s), std::sin(2. * M_PI * s)};
}

TEST(HeightField, InclinedPlane)
{
  const HeightField body(slope());
  EXPECT_EQ(body.name(), "height field x/2 - y + 1");
  const GapSample sample = body.gap({2., 1., 4.}); // 3 above the surface, whose normal has n_z = 1/1.5
  expect_close(sample.gap, 2.);
  expect_close(sample.normal, {-1. / 3., 2. / 3., 2. / 3.});
  check_gap(body, {0.3, 0.7, -2.});
}

TEST(HeightField, SphereFromOutsideAndInside)
{
  const Vector3<double> outside{0.3, -0.2, 1.2}, inside{0.2, 0.1, 0.3};
  const HeightField hill(half_sphere(1.)), bowl(half_sphere(-1.));
  expect_close(hill.gap(outside).gap, norm(outside) - 1.);
  expect_close(hill.gap(inside).gap, norm(inside) - 1.);
  expect_close(bowl.gap(-inside).gap, 1. - norm(inside));
  const Vector3<double> n = (1. / norm(outside)) * outside;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      expect_close(hill.gap(outside).hessian(i, j), ((i == j) - n[i] * n[j]) / norm(outside));
  check_gap(hill, outside);
  check_gap(hill, inside);
  check_gap(bowl, -inside);
}

TEST(HeightField, DerivativesOnWaves)
{
  const HeightField body(waves());
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-2., 2.), distance(-0.5, 0.5);
  for (int trial = 0; trial < 20; ++trial)
    check_gap(body, {uniform(random), uniform(random), distance(random)}, 2e-8);
}

// The closest point of a search over the whole surface.
TEST(HeightField, FootIsClosest)
{
  const auto H = waves();
  const HeightField body(H);
  const Vector3<double> x{0.4, 0.9, 0.3};
  double least = 1e300;
  for (double u = -1.; u < 2.; u += 0.004)
    for (double v = -1.; v < 2.; v += 0.004)
      least = std::min(least, norm(x - Vector3<double>(u, v, H->at(u, v).value)));
  EXPECT_NEAR(body.gap(x).gap, least, 1e-4);
  EXPECT_LE(body.gap(x).gap, least);
}

TEST(HeightField, CentresOfCurvatureAreRefused)
{
  const HeightField body(parabola()); // curvature 2 at the bottom
  expect_close(body.gap({0., 0., 0.49}).gap, 0.49);
  expect_close(body.gap({0., 0., 0.49}).hessian(0, 0), -2. / (1. - 0.98), 1., 1e-10);
  check_gap(body, {0.1, 0., 0.3}, 2e-7);
  expect_no_gap(body, {0., 0., 0.5}, {"(0, 0, 0.5)", "height field x^2", "centre of curvature"});
  std::shared_ptr<const FunctionOfPlace> crest = std::make_shared<Formula>(
      "-x^2", [](const double x, double) { return PlaceSample{-x * x, -2. * x, 0., -2., 0., 0.}; });
  expect_no_gap(HeightField(crest), {0., 0., -2.}, {"height field -x^2", "centre of curvature"});
}

// On the axis of a trough there are two closest points, on both sides.
TEST(HeightField, FarAboveOneOfTwoFeetIsTaken)
{
  const HeightField body(parabola());
  for (const double x : {0., 1e-9, 1e-3})
  {
    const GapSample sample = body.gap({x, 0., 2.});
    expect_close(sample.gap, std::sqrt(1.75), 1., 2e-3); // z - H = 1/2
    expect_close(std::abs(sample.foot[0]), std::sqrt(1.5), 1., 2e-3);
  }
}

TEST(HeightField, PlacesWithoutSlopeAreRefused)
{
  expect_no_gap(HeightField(half_sphere(1.)), {1.5, 0., 0.}, {"(1.5, 0, 0)", "not finite"});
  expect_no_gap(HeightField(std::make_shared<Formula>(kinked(1, 0.3, -1.))), {0.31, 0., 0.6}, {"stuck", "kinks"});
}

TEST(FindKink, JumpsOfFirstAndSecondDerivativesAreFound)
{
  for (const int p : {1, 2})
  {
    const auto kink = find_kink(kinked(p), circle);
    ASSERT_TRUE(kink) << p;
    EXPECT_NEAR(kink->x, 0.3, 1e-9);
    EXPECT_NEAR(kink->s, std::acos(0.3) / (2. * M_PI), 1e-10);
    EXPECT_NEAR(kink->y, std::sqrt(1. - 0.09), 1e-9);
  }
  EXPECT_TRUE(find_kink(kinked(1, 0.), circle));        // on lines of symmetry of the curve
  EXPECT_TRUE(find_kink(kinked(1, 0.3, 1e-5), circle)); // a weak kink alone
}

TEST(FindKink, SmoothFunctionsPass)
{
  EXPECT_FALSE(find_kink(*slope(), circle));
  EXPECT_FALSE(find_kink(*waves(), circle));
  EXPECT_FALSE(find_kink(kinked(3), circle));
  EXPECT_FALSE(find_kink(kinked(1, 1.1), circle)); // the kink is outside the circle
  EXPECT_FALSE(find_kink(Formula("steep step",
                                 [](const double x, double)
                                 {
                                   const double k = 1e4, t = std::tanh(k * x), d = 1. - t * t;
                                   return PlaceSample{t / k, d, 0., -2. * k * t * d, 0., 0.};
                                 }),
                         circle));
  EXPECT_FALSE(find_kink(Formula("round-off of a constant",
                                 [](const double x, double)
                                 {
                                   const double noise = std::sin(1e9 * x) * 1e-16;
                                   return PlaceSample{1., noise, 0., noise, 0., 0.};
                                 }),
                         circle));
}

TEST(FindKink, WhatIsNotFiniteIsAKink)
{
  const auto kink = find_kink(*half_sphere(1.), [](const double s) { return std::pair(2. * s - 0.5, 0.); });
  ASSERT_TRUE(kink);
  EXPECT_NEAR(kink->x, 1., 4e-3);
}
} // namespace

// SPDX-License-Identifier: LGPL-2.1-or-later
// Integrals over a wetted base as integrals along its line: closed forms, and derivatives against differences.
#include <pellicle/base/constants.h>
#include <pellicle/base/expression_of_place.h>
#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/wetting/base_integral.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{
using namespace pellicle;

/** Integral along a closed curve x(t), 0 <= t <= 2 pi, by the trapezoidal rule. */
template <typename Chart, typename Integrand, typename Curve>
double around(const Chart &chart, const Integrand &integrand, const Curve &curve)
{
  const BaseIntegral<Chart, Integrand> base{chart, integrand};
  constexpr int n    = 64;
  double sum         = 0.;
  constexpr double h = 1e-4;
  for (int i = 0; i < n; ++i)
  {
    const double t = 2. * pi * i / n;
    // Fourth-order difference along the curve.
    const Vector3<double> d =
        (1. / (12. * h)) * (8. * (curve(t + h) - curve(t - h)) - (curve(t + 2. * h) - curve(t - 2. * h)));
    sum += 2. * pi / n * base.along_line(curve(t), d);
  }
  return sum;
}

/** A circle of polar angle b about the point at polar angle c (towards x) of a sphere that touches z = 0. */
struct CircleOnSphere
{
  double radius, side, b, c;
  Vector3<double> operator()(const double t) const
  {
    // About the axis first, then turned about y.
    const double x = std::sin(b) * std::cos(t), y = std::sin(b) * std::sin(t), z = std::cos(b);
    const double X = std::cos(c) * x + std::sin(c) * z, Z = -std::sin(c) * x + std::cos(c) * z;
    return {radius * X, radius * y, side * radius * (Z - 1.)};
  }
};

TEST(BaseIntegrals, PlaneAndEllipseAwayFromTheOrigin)
{
  // The rays' origin is outside: parts that the line passes twice cancel.
  const auto ellipse = [](const double t)
  { return Vector3<double>(3. + 0.7 * std::cos(t), -1. + 0.4 * std::sin(t), 0.); };
  EXPECT_NEAR(around(PlaneChart(), AreaIntegrand(), ellipse), pi * 0.28, 1e-11);
  EXPECT_NEAR(around(PlaneChart(), BaseVolumeIntegrand(), ellipse), 0., 1e-12);
  // cos(60 + 30 x) degrees, linearised nowhere: against the series in Bessel functions of a disc, J1(k r)/(k r).
  const auto degrees = std::make_shared<ExpressionOfPlace>("60 + 30*x");
  const auto disc    = [](const double t) { return Vector3<double>(std::cos(t), std::sin(t), 0.); };
  const double k = pi / 6., mean = 2. * std::cyl_bessel_j(1., k) / k;
  EXPECT_NEAR(around(PlaneChart(), WettingIntegrand{-2., {0., degrees}}, disc), -2. * pi * 0.5 * mean, 1e-10);
  EXPECT_NEAR(around(PlaneChart(), WettingIntegrand{-2., {0.3, nullptr}}, disc), -0.6 * pi, 1e-10);
}

TEST(BaseIntegrals, Spheres)
{
  for (const double side : {1., -1.})
    for (const double radius : {0.7, 3.})
      for (const double c : {0., 0.4, 1.1}) // the last circle does not go round the pole
      {
        SCOPED_TRACE(::testing::Message() << side << " " << radius << " " << c);
        const CircleOnSphere circle{radius, side, 0.8, c};
        const double area = 2. * pi * radius * radius * (1. - std::cos(circle.b));
        EXPECT_NEAR(around(SphereChart{radius, side}, AreaIntegrand(), circle), area, 1e-9 * area);
        // With the sphere's centre m, x . n = (x - m) . n + m . n: the cone over the cap and m times its vector area.
        const Vector3<double> m(0., 0., -side * radius);
        const double disc = pi * std::pow(radius * std::sin(circle.b), 2);
        const Vector3<double> vector_area(disc * std::sin(c), 0., side * disc * std::cos(c));
        const Vector3<double> out =
            side > 0. ? vector_area : Vector3<double>(-disc * std::sin(c), 0., disc * std::cos(c));
        const double volume = -(side * radius * area + dot(m, out)) / 3.;
        EXPECT_NEAR(around(SphereChart{radius, side}, BaseVolumeIntegrand(), circle), volume, 1e-9 * area * radius);
      }
}

TEST(BaseIntegrals, HeightFieldOfASphereAgreesWithItsChart)
{
  const double R = 2.;
  const HeightChart field{std::make_shared<ExpressionOfPlace>("sqrt(4 - x^2 - y^2) - 2")};
  const CircleOnSphere circle{R, 1., 0.5, 0.3};
  const Vector3<double> force(0.3, -0.2, -1.);
  EXPECT_NEAR(around(field, AreaIntegrand(), circle), around(SphereChart{R, 1.}, AreaIntegrand(), circle), 1e-9);
  EXPECT_NEAR(around(field, BaseVolumeIntegrand(), circle), around(SphereChart{R, 1.}, BaseVolumeIntegrand(), circle),
              1e-9);
  EXPECT_NEAR(around(field, BaseGravityIntegrand{force}, circle),
              around(SphereChart{R, 1.}, BaseGravityIntegrand{force}, circle), 1e-9);
}

TEST(BaseIntegrals, GravityOverAPlaneHasNoBaseUnlessItIsAbove)
{
  // Drop between z = h and a disc below it: integral of z over the cylinder from the plane z = 0 is pi h^2/2, of which
  // the base z = h has the share (1/4) closed integral of z (x . n) = -(1/4) h^2 pi with n down.
  const double h = 0.6;
  const HeightChart raised{std::make_shared<ExpressionOfPlace>("0.6")};
  const auto disc = [&](const double t) { return Vector3<double>(std::cos(t), std::sin(t), h); };
  EXPECT_NEAR(around(raised, BaseGravityIntegrand{{0., 0., -1.}}, disc), -0.25 * pi * h * h, 1e-10);
  EXPECT_EQ(make_base_gravity("gravity", PlaneChart(), {0., 0., -1.}, "contact line"), nullptr);
  EXPECT_EQ(make_base_volume("volume", PlaneChart(), "contact line"), nullptr);
}

/** Gradient and matrix of a line density against differences of its value and gradient: second order. */
void check_derivatives(const Potential &potential)
{
  SCOPED_TRACE(potential.name());
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  const unsigned int offsets[] = {0};
  constexpr unsigned int n     = 3 * n_slots(Derivatives::first);
  std::vector<double> inputs(n, 0.), direction(n, 0.);
  for (unsigned int i = 0; i < n; ++i)
  {
    inputs[i]    = 0.4 * uniform(random);
    direction[i] = uniform(random);
  }
  const auto sums = [&](const double eps)
  {
    std::vector<double> moved = inputs;
    for (unsigned int i = 0; i < n; ++i)
      moved[i] += eps * direction[i];
    PointSums result;
    result.reset(1, n, Order::hessian);
    potential.add({0, 1, n, moved.data()}, offsets, 1., Order::hessian, result);
    return result;
  };
  const PointSums here = sums(0.);
  double slope = 0., curvature = 0.;
  for (unsigned int i = 0; i < n; ++i)
  {
    slope += here.gradient[i] * direction[i];
    for (unsigned int j = 0; j < n; ++j)
    {
      curvature += direction[i] * here.hessian[i * n + j] * direction[j];
      EXPECT_NEAR(here.hessian[i * n + j], here.hessian[j * n + i], 1e-13);
    }
  }
  double slope_error[2], curvature_error[2];
  for (int half = 0; half < 2; ++half)
  {
    const double eps      = half == 0 ? 2e-3 : 1e-3;
    const PointSums ahead = sums(eps), behind = sums(-eps);
    slope_error[half]     = (ahead.value[0] - behind.value[0]) / (2. * eps) - slope;
    curvature_error[half] = -curvature;
    for (unsigned int i = 0; i < n; ++i)
      curvature_error[half] += direction[i] * (ahead.gradient[i] - behind.gradient[i]) / (2. * eps);
  }
  ASSERT_NE(here.value[0], 0.);
  EXPECT_LT(std::abs(slope_error[1]), 1e-4);
  EXPECT_LT(std::abs(curvature_error[1]), 1e-4);
  for (const double *error : {slope_error, curvature_error})
    if (std::abs(error[0]) > 1e-10) // on a plane some are exact
    {
      EXPECT_NEAR(error[0] / error[1], 4., 0.1);
    }
}

TEST(BaseIntegrals, Derivatives)
{
  const auto height  = std::make_shared<ExpressionOfPlace>("0.1*sin(2*x)*cos(3*y) + 0.2*x");
  const auto degrees = std::make_shared<ExpressionOfPlace>("70 + 20*tanh(x - y)");
  for (const SubstrateChart &chart : {SubstrateChart(PlaneChart()), SubstrateChart(SphereChart{1.3, 1.}),
                                      SubstrateChart(SphereChart{1.3, -1.}), SubstrateChart(HeightChart{height})})
  {
    SCOPED_TRACE(chart.index());
    check_derivatives(*make_wetting("wetting", chart, {-1., {0.4, nullptr}}, "line"));
    check_derivatives(*make_wetting("wetting of place", chart, {-1., {0., degrees}}, "line"));
    if (const auto volume = make_base_volume("volume", chart, "line"))
      check_derivatives(*volume);
    if (const auto weight = make_base_gravity("gravity", chart, {0.3, -0.2, -1.}, "line"))
      check_derivatives(*weight);
  }
}
} // namespace

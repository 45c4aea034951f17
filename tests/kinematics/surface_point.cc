// SPDX-License-Identifier: LGPL-2.1-or-later
// Every geometric quantity in closed form, with its sign.
#include "checks.h"
#include "surfaces.h"

using namespace pellicle;
using namespace pellicle::test_surfaces;

TEST(SurfacePoint, JacobianAndCurvaturesAreExactOnAnalyticSurfaces)
{
  for (const Sample &s : samples())
  {
    SCOPED_TRACE(s.name);
    const SurfacePoint<double> p = s.point();
    expect_close(p.jacobian, s.J);
    expect_close(p.mean_curvature, s.H);
    expect_close(p.gauss_curvature, s.K);
  }
}

TEST(SurfacePoint, SphereHasOutwardNormalAndNegativeMeanCurvature)
{
  const Sphere sphere;
  const Sample s               = sample(sphere, 1.1, 0.4);
  const SurfacePoint<double> p = s.point();
  expect_close(p.normal, s.x / sphere.R);
  EXPECT_NEAR(p.mean_curvature, -1. / sphere.R, 1e-14);
  for (unsigned int i = 0; i < 3; ++i) // b_ab = -a_ab/R
    EXPECT_NEAR(p.curvature.components[i], -p.metric.components[i] / sphere.R, 1e-14);
  const double sine = std::sin(1.1), cosine = std::cos(1.1);
  EXPECT_NEAR(p.christoffel[0](1, 1), -sine * cosine, 1e-14);
  EXPECT_NEAR(p.christoffel[1](0, 1), cosine / sine, 1e-14);
  EXPECT_NEAR(p.christoffel[0](0, 0), 0., 1e-14);
  EXPECT_NEAR(p.christoffel[1](1, 1), 0., 1e-14);
}

TEST(SurfacePoint, TorusChangesTheSignOfTheGaussCurvatureInside)
{
  EXPECT_GT(sample(Torus(), 0.3, 0.1).point().gauss_curvature, 0.);
  EXPECT_LT(sample(Torus(), 0.3, 3.1).point().gauss_curvature, 0.);
}

TEST(SurfacePoint, ExchangedParametersTurnTheNormalAndTheMeanCurvature)
{
  const Sample s               = sample(Ellipsoid(), 0.8, 0.5);
  const SurfacePoint<double> p = s.point();
  const SurfacePoint<double> q(s.first[1], s.first[0], s.second(1, 1), s.second(0, 1), s.second(0, 0));
  expect_close(q.normal, -p.normal);
  expect_close(q.mean_curvature, -p.mean_curvature);
  expect_close(q.gauss_curvature, p.gauss_curvature);
  expect_close(q.jacobian, p.jacobian);
}

TEST(SurfacePoint, TangentPlaneIsConsistent)
{
  for (const Sample &s : samples())
  {
    SCOPED_TRACE(s.name);
    const TangentPlane<double> p(s.first[0], s.first[1]);
    expect_close(p.area_vector, p.jacobian * p.normal);
    expect_close(determinant(p.metric), p.jacobian * p.jacobian);
    expect_close(norm(p.normal), 1.);
    EXPECT_GT(dot(p.area_vector, cross(s.first[0], s.first[1])), 0.);
    for (unsigned int a = 0; a < 2; ++a)
    {
      expect_close(dot(p.dual[a], p.normal), 0.);
      for (unsigned int b = 0; b < 2; ++b)
      {
        expect_close(p.metric(a, b), dot(s.first[a], s.first[b]));
        expect_close(dot(p.dual[a], p.base[b]), a == b ? 1. : 0.);
        expect_close(dot(p.dual[a], p.dual[b]), p.inverse_metric(a, b));
        expect_close(p.inverse_metric(a, 0) * p.metric(0, b) + p.inverse_metric(a, 1) * p.metric(1, b),
                     a == b ? 1. : 0.);
      }
    }
  }
}

TEST(SurfacePoint, ParallelBaseVectorsGiveZeroJacobianAndNoNormal)
{
  const Vector3<double> x_1(1., 2., -1.), zero;
  const SurfacePoint<double> p(x_1, 2. * x_1, zero, zero, zero);
  EXPECT_EQ(p.jacobian, 0.);
  EXPECT_EQ(norm(p.area_vector), 0.);
  EXPECT_EQ(p.metric(0, 1), 12.);
  EXPECT_FALSE(std::isfinite(p.normal[0]));
  EXPECT_FALSE(std::isfinite(p.inverse_metric(0, 0)));
  EXPECT_FALSE(std::isfinite(p.dual[0][0]));
  EXPECT_FALSE(std::isfinite(p.mean_curvature));
}

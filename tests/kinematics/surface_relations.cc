// SPDX-License-Identifier: LGPL-2.1-or-later
// Relations between the quantities: Gauss, Weingarten, Christoffel symbols from the metric, invariance under rigid
// motions.
#include "checks.h"
#include "surfaces.h"

using namespace pellicle;
using namespace pellicle::test_surfaces;

namespace
{
/** The base vectors as functions of (u1, u2), to first order: values x,a and derivatives x,ab. */
TangentPlane<FirstOrder<2>> moving_tangent_plane(const Sample &s)
{
  FirstDerivatives<FirstOrder<2>> base;
  for (unsigned int a = 0; a < 2; ++a)
    for (unsigned int i = 0; i < 3; ++i)
    {
      base[a][i] = s.first[a][i];
      for (unsigned int b = 0; b < 2; ++b)
        base[a][i].fastAccessDx(b) = s.second(a, b)[i];
    }
  return TangentPlane<FirstOrder<2>>(base[0], base[1]);
}

Vector3<double> derivative(const Vector3<FirstOrder<2>> &v, const unsigned int b)
{
  return Vector3<double>(v[0].dx(b), v[1].dx(b), v[2].dx(b));
}

/** Rotation by `angle` about the unit vector `axis` (Rodrigues). */
Vector3<double> rotated(const Vector3<double> &v, const Vector3<double> &axis, const double angle)
{
  return std::cos(angle) * v + std::sin(angle) * cross(axis, v) + (1. - std::cos(angle)) * dot(axis, v) * axis;
}
} // namespace

TEST(SurfaceRelations, GaussFormula) // x,ab = Gamma^g_ab a_g + b_ab n
{
  for (const Sample &s : samples())
  {
    SCOPED_TRACE(s.name);
    const SurfacePoint<double> p = s.point();
    for (unsigned int a = 0; a < 2; ++a)
      for (unsigned int b = 0; b < 2; ++b)
        expect_close(s.second(a, b), p.christoffel[0](a, b) * p.base[0] + p.christoffel[1](a, b) * p.base[1] +
                                         p.curvature(a, b) * p.normal);
  }
}

TEST(SurfaceRelations, WeingartenFormula) // n,a = -b_a^g a_g
{
  for (const Sample &s : samples())
  {
    SCOPED_TRACE(s.name);
    const SurfacePoint<double> p        = s.point();
    const TangentPlane<FirstOrder<2>> q = moving_tangent_plane(s);
    for (unsigned int a = 0; a < 2; ++a)
      expect_close(derivative(q.normal, a),
                   -(p.mixed_curvature[0][a] * p.base[0] + p.mixed_curvature[1][a] * p.base[1]));
  }
}

TEST(SurfaceRelations,
     ChristoffelSymbolsFollowFromTheMetric) // a^gd (a_da,b + a_db,a - a_ab,d)/2, and J,a = J Gamma^g_ga
{
  for (const Sample &s : samples())
  {
    SCOPED_TRACE(s.name);
    const SurfacePoint<double> p        = s.point();
    const TangentPlane<FirstOrder<2>> q = moving_tangent_plane(s);
    const auto metric_ = [&q](unsigned int a, unsigned int b, unsigned int c) { return q.metric(a, b).dx(c); };
    for (unsigned int a = 0; a < 2; ++a)
    {
      expect_close(q.jacobian.dx(a), p.jacobian * (p.christoffel[0](0, a) + p.christoffel[1](1, a)));
      for (unsigned int b = 0; b < 2; ++b)
        for (unsigned int g = 0; g < 2; ++g)
        {
          double sum = 0.;
          for (unsigned int d = 0; d < 2; ++d)
            sum += 0.5 * p.inverse_metric(g, d) * (metric_(d, a, b) + metric_(d, b, a) - metric_(a, b, d));
          expect_close(p.christoffel[g](a, b), sum);
        }
    }
  }
}

TEST(SurfaceRelations, RigidMotionsChangeNoScalarAndTurnEveryVector)
{
  const Vector3<double> axis = Vector3<double>(1., -2., 0.5) / norm(Vector3<double>(1., -2., 0.5));
  const double angle         = 0.83;
  const auto turn            = [&](const Vector3<double> &v) { return rotated(v, axis, angle); };
  for (const Sample &s : samples())
  {
    SCOPED_TRACE(s.name);
    const SurfacePoint<double> p = s.point();
    const SurfacePoint<double> q(turn(s.first[0]), turn(s.first[1]), turn(s.second(0, 0)), turn(s.second(0, 1)),
                                 turn(s.second(1, 1)));
    expect_close(q.jacobian, p.jacobian);
    expect_close(q.mean_curvature, p.mean_curvature);
    expect_close(q.gauss_curvature, p.gauss_curvature);
    expect_close(q.metric, p.metric);
    expect_close(q.inverse_metric, p.inverse_metric);
    expect_close(q.curvature, p.curvature);
    expect_close(q.normal, turn(p.normal));
    for (unsigned int a = 0; a < 2; ++a)
    {
      expect_close(q.dual[a], turn(p.dual[a]));
      expect_close(q.christoffel[a], p.christoffel[a]);
    }
  }
}

TEST(SurfaceRelations, DilationScalesEveryQuantityByItsPower)
{
  const double factor = 3.;
  for (const Sample &s : samples())
  {
    SCOPED_TRACE(s.name);
    const SurfacePoint<double> p = s.point();
    const SurfacePoint<double> q(factor * s.first[0], factor * s.first[1], factor * s.second(0, 0),
                                 factor * s.second(0, 1), factor * s.second(1, 1));
    expect_close(q.jacobian, factor * factor * p.jacobian);
    expect_close(q.mean_curvature, p.mean_curvature / factor);
    expect_close(q.gauss_curvature, p.gauss_curvature / (factor * factor));
  }
}

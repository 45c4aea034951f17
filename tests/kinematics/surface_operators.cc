// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/kinematics/surface_operators.h>

#include "checks.h"
#include "surfaces.h"

using namespace pellicle;
using namespace pellicle::test_surfaces;

namespace
{
/** n,a = -b_a^g a_g */
FirstDerivatives<double> normal_derivatives(const SurfacePoint<double> &p)
{
  FirstDerivatives<double> n;
  for (unsigned int a = 0; a < 2; ++a)
    n[a] = -(p.mixed_curvature[0][a] * p.base[0] + p.mixed_curvature[1][a] * p.base[1]);
  return n;
}
const Vector3<double> c(0.4, -0.9, 1.3);
} // namespace

TEST(SurfaceOperators, GradientOfALinearFunctionIsItsTangentialPart)
{
  for (const Sample &s : samples())
  {
    SCOPED_TRACE(s.name);
    const SurfacePoint<double> p = s.point();
    const Vector3<double> g      = surface_gradient(p, dot(c, s.first[0]), dot(c, s.first[1]));
    expect_close(g, tangential_part<double>(p, c));
    expect_close(dot(g, p.normal), 0.);
  }
}

TEST(SurfaceOperators, GradientOfThePositionIsTheProjector)
{
  for (const Sample &s : samples())
  {
    SCOPED_TRACE(s.name);
    const SurfacePoint<double> p = s.point();
    const auto projector         = tangential_projector(p);
    const auto gradient          = surface_gradient(p, s.first);
    for (unsigned int i = 0; i < 3; ++i)
    {
      expect_close(gradient[i], projector[i]);
      for (unsigned int j = 0; j < 3; ++j)
        expect_close(projector[i][j], (i == j) - p.normal[i] * p.normal[j]);
    }
    expect_close(surface_divergence(p, s.first), 2.);
    expect_close(gradient_product(p, s.first, s.first), 2.);
  }
}

TEST(SurfaceOperators, RowsOfTheGradientBelongToTheComponents)
{
  // v = (c . x) d: grad v = d (x) P c, so that row i is d_i P c.
  const Vector3<double> d(2., 0.5, -1.);
  for (const Sample &s : samples())
  {
    SCOPED_TRACE(s.name);
    const SurfacePoint<double> p = s.point();
    const FirstDerivatives<double> v{{dot(c, s.first[0]) * d, dot(c, s.first[1]) * d}};
    const Vector3<double> pc = tangential_part(p, c);
    for (unsigned int i = 0; i < 3; ++i)
      expect_close(surface_gradient(p, v)[i], d[i] * pc);
    expect_close(surface_divergence(p, v), dot(d, pc));
    expect_close(gradient_product(p, v, v), dot(d, d) * dot(pc, pc));
  }
}

TEST(SurfaceOperators, DivergenceOfTheNormalIsMinusTwiceTheMeanCurvature)
{
  for (const Sample &s : samples())
  {
    SCOPED_TRACE(s.name);
    const SurfacePoint<double> p       = s.point();
    const FirstDerivatives<double> n_a = normal_derivatives(p);
    expect_close(surface_divergence(p, n_a), -2. * s.H);
    expect_close(gradient_product(p, n_a, n_a), 4. * s.H * s.H - 2. * s.K);
  }
}

TEST(SurfaceOperators, LaplacianOfThePositionIsTwiceMeanCurvatureTimesNormal)
{
  for (const Sample &s : samples())
  {
    SCOPED_TRACE(s.name);
    const SurfacePoint<double> p = s.point();
    expect_close(surface_laplacian(p, s.first, s.second), 2. * s.H * p.normal);
  }
}

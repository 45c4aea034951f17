// SPDX-License-Identifier: LGPL-2.1-or-later
// Exact areas and volumes of the smooth shapes, and the parameters that are refused.
#include "expect_user_error.h"

#include <pellicle/base/constants.h>
#include <pellicle/discretization/builders.h>
#include <pellicle/discretization/surface_quality.h>

#include <cmath>
#include <limits>

namespace
{
using namespace pellicle;

TEST(SmoothShape, EllipsoidAreaMatchesReferences)
{
  EXPECT_NEAR(ellipsoid({{.5, .5, 1.}}).area, 5.369608831971, 2e-12);
  EXPECT_NEAR(ellipsoid({{2., 2., 2.}}).area, 16. * pi, 1e-12);
  EXPECT_NEAR(ellipsoid({{2., 2., 2.}}).reduced_volume(), 1., 1e-14);
  const SmoothShape triaxial       = ellipsoid({{1., 2., 3.}}); // against the area of its own mesh
  const SurfaceDiscretization mesh = on_cube_sphere(triaxial, 5, 3);
  EXPECT_NEAR(surface_quality(mesh, mesh.positions).area / triaxial.area, 1., 1e-9);
  EXPECT_NEAR(ellipsoid({{1e-9, 2e-9, 3e-9}}).area / triaxial.area, 1e-18, 1e-32);
  EXPECT_TRUE(ellipsoid({{2., 2., 3.}}).axisymmetric);
  EXPECT_FALSE(ellipsoid({{2., 3., 3.}}).axisymmetric);
}

TEST(SmoothShape, BiconcaveAreaMatchesReference)
{
  EXPECT_NEAR(biconcave().area, 8.314387691448, 2e-12);
}

TEST(SmoothShape, SpheroidsHaveTheWantedReducedVolume)
{
  for (const double v : {0.01, 0.3, 0.62, 0.9, 0.99, 0.999999, 1. - 1e-10})
  {
    const SmoothShape prolate = prolate_spheroid(v), oblate = oblate_spheroid(v);
    EXPECT_NEAR(prolate.reduced_volume(), v, 1e-14 + 1e-14 * v);
    EXPECT_NEAR(oblate.reduced_volume(), v, 1e-14 + 1e-14 * v);
    EXPECT_GT(prolate.point({0., 0., 1.})[2], prolate.point({1., 0., 0.})[0]);
    EXPECT_LT(oblate.point({0., 0., 1.})[2], oblate.point({1., 0., 0.})[0]);
    // The closed forms against the elliptic integral of the same axes.
    for (const SmoothShape &s : {prolate, oblate})
    {
      const double a = s.point({1., 0., 0.})[0], c = s.point({0., 0., 1.})[2];
      EXPECT_NEAR(ellipsoid({{a, a, c}}).area / s.area, 1., 1e-13) << "v = " << v;
    }
  }
}

TEST(SmoothShape, ScalingKeepsTheReducedVolume)
{
  const SmoothShape shape = scaled_to_area(biconcave(), 4. * pi);
  EXPECT_DOUBLE_EQ(shape.area, 4. * pi);
  EXPECT_NEAR(shape.reduced_volume(), biconcave().reduced_volume(), 1e-15);
  EXPECT_NEAR(shape.point({1., 0., 0.})[0], std::sqrt(4. * pi / 8.314387691448), 1e-12);
}

TEST(SmoothShape, StomatocyteHasTheWantedReducedVolume)
{
  for (const double v : {0.2, 0.4, 0.62, 0.78})
    EXPECT_NEAR(stomatocyte(v).reduced_volume(), v, 1e-13);
}

TEST(SmoothShape, StomatocyteIsACupWithItsMouthUp)
{
  const SmoothShape shape      = stomatocyte(.62);
  const Vector3<double> bottom = shape.point({0., 0., -1.}), inside = shape.point({0., 0., 1.});
  EXPECT_NEAR(bottom[2], -1., 1e-13);
  EXPECT_LT(inside[2], -.3);
  EXPECT_GT(inside[2], -.6);
  // Equal polar angles make the shortest steps at the rim, whose tip is at the equator, and nowhere steps of zero.
  double shortest = 1e9, longest = 0., at_shortest = 0.;
  for (int i = 0; i < 2000; ++i)
  {
    const double a = pi * i / 2000., b = pi * (i + 1) / 2000.;
    const Vector3<double> step =
        shape.point({std::sin(b), 0., std::cos(b)}) - shape.point({std::sin(a), 0., std::cos(a)});
    if (norm(step) < shortest)
      at_shortest = a;
    shortest = std::min(shortest, norm(step));
    longest  = std::max(longest, norm(step));
  }
  EXPECT_LT(longest / shortest, 6.);
  EXPECT_NEAR(at_shortest, pi / 2., 0.4);
}

TEST(SmoothShape, ImpossibleReducedVolumesAreRefused)
{
  for (const auto &make : {prolate_spheroid, oblate_spheroid})
  {
    EXPECT_USER_ERROR(make(1.), "is a sphere", "parallel");
    EXPECT_USER_ERROR(make(1.2), "Reduced volume = 1.2", "strictly between 0 and 1");
    EXPECT_USER_ERROR(make(0.), "Reduced volume = 0 ", "strictly between 0 and 1");
    EXPECT_USER_ERROR(make(-.5), "Reduced volume = -0.5", "strictly between 0 and 1");
    EXPECT_USER_ERROR(make(std::numeric_limits<double>::quiet_NaN()), "Reduced volume", "strictly between");
  }
  for (const double v : {1., 0.9, 0.1, 0., -1., std::numeric_limits<double>::quiet_NaN()})
    EXPECT_USER_ERROR(stomatocyte(v), "'stomatocyte'", "must lie between");
  EXPECT_USER_ERROR(ellipsoid({{1., 0., 2.}}), "Semi axes = 1, 0, 2", "> 0");
}
} // namespace

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "shapes.h"

#include <pellicle/models/axis_crossings.h>
#include <pellicle/models/largest_value.h>
#include <pellicle/models/shape_measures.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace
{
using namespace pellicle;
using namespace pellicle::test_shapes;

void expect_same(const ShapeMeasures &a, const ShapeMeasures &b, const double tolerance)
{
  EXPECT_NEAR(a.area, b.area, tolerance * a.area);
  EXPECT_NEAR(a.volume, b.volume, tolerance * a.volume);
  EXPECT_NEAR(a.reduced_volume, b.reduced_volume, tolerance);
  EXPECT_NEAR(a.height, b.height, tolerance * a.height);
  EXPECT_NEAR(a.equatorial_radius, b.equatorial_radius, tolerance * a.equatorial_radius);
  EXPECT_NEAR(a.axis_thickness, b.axis_thickness, tolerance * a.height);
  EXPECT_NEAR(a.min_cell_quality, b.min_cell_quality, tolerance);
  EXPECT_NEAR(a.cell_area_ratio, b.cell_area_ratio, tolerance * a.cell_area_ratio);
  EXPECT_NEAR(a.gauss_bonnet, b.gauss_bonnet, 10. * tolerance);
}

TEST(ShapeMeasures, SpheroidOnTheCubeSphere)
{
  const double a = 1.3, c = 0.7;
  const auto surface      = on_cube_sphere(ellipsoid({{a, a, c}}), 4, 2);
  const ShapeMeasures m   = measure_shape(surface, surface.positions);
  const SmoothShape exact = ellipsoid({{a, a, c}});
  EXPECT_NEAR(m.area, exact.area, 1e-6 * exact.area);
  EXPECT_NEAR(m.volume, exact.volume, 1e-6 * exact.volume);
  EXPECT_NEAR(m.reduced_volume, exact.reduced_volume(), 1e-6);
  EXPECT_NEAR(m.height, 2. * c, 1e-10); // the poles are nodes, the surface between them bulges a little
  EXPECT_NEAR(m.axis_thickness, 2. * c, 1e-12);
  EXPECT_NEAR(m.equatorial_radius, a, 1e-5);
  EXPECT_NEAR(m.gauss_bonnet, 2., 1e-3);
  EXPECT_GT(m.min_cell_quality, 0.6);
  EXPECT_LT(m.min_cell_quality, 1.);
  EXPECT_GT(m.cell_area_ratio, 1.);
  EXPECT_LT(m.cell_area_ratio, 3.);
}

// Turned out of its symmetric position no pole is a node: only the curved surface has the right extent.
TEST(ShapeMeasures, ExtentIsThatOfTheCurvedSurface)
{
  const SmoothShape ball = sphere(1.);
  double errors[2];
  for (unsigned int r : {2U, 3U})
  {
    const auto surface = on_cube_sphere(ball, 3, r);
    const double alpha = 0.37;
    const NodalVectors tilted =
        turned_and_shifted(tipped_over(turned_and_shifted(surface.positions, alpha, {})), 2. * alpha, {});
    const auto m    = measure_shape(surface, tilted);
    double of_nodes = 0.;
    for (std::size_t I = 0; I < surface.n_nodes; ++I)
      of_nodes = std::max(of_nodes, tilted[3 * I + 2]);
    errors[r - 2] = std::abs(m.height - 2.);
    EXPECT_LT(errors[r - 2], 0.1 * (1. - of_nodes));
    EXPECT_NEAR(m.axis_thickness, m.height, 1e-4);
  }
  EXPECT_LT(errors[1], errors[0] / 8.);
}

// A bent sphere on large cells: maxima of all sorts of functions, on faces, edges and vertices of cells.
TEST(ShapeMeasures, LargestValueInsideACell)
{
  const auto surface      = on_cube_sphere(sphere(1.), 5, 1);
  const NodalVectors bent = moved(surface.positions, [](const Vector3<double> &x)
                                  { return Vector3<double>(x[0], x[1], x[2] + 0.2 * x[0] * x[1]); });
  const CellGeometry geometry(surface, bent);
  for (const Vector3<double> &direction :
       {Vector3<double>(0., 0., 1.), Vector3<double>(0.3, -0.5, 0.8), Vector3<double>(-1., 2., 0.1)})
  {
    const QuadraticFunction f{direction, {0.1, 0.3, 0.2}, {0.1, 0.2, 0.3}};
    const double found = largest_value(geometry, f);
    // Nothing on a fine grid is larger, and something is nearly as large.
    double largest = -1e10;
    for (std::size_t cell = 0; cell < geometry.n_cells(); ++cell)
      for (unsigned int i = 0; i <= 100; ++i)
        for (unsigned int j = 0; j <= 100; ++j)
          largest = std::max(largest, f.value(geometry.at({cell, {{0.01 * i, 0.01 * j}}}).x));
    EXPECT_LE(largest, found * (1. + 1e-14));
    EXPECT_NEAR(largest, found, 2e-4);
    EXPECT_GT(found, largest);
  }
}

TEST(ShapeMeasures, StationaryToRoundOff)
{
  // A quadratic cell: z = 1 - (xi - 0.3)^2 - (eta - 0.6)^2 is reproduced exactly.
  auto surface    = on_cube_sphere(sphere(1.), 2, 0);
  surface.n_cells = 1;
  for (unsigned int i = 0; i < 9; ++i)
  {
    const double xi = 0.5 * (i % 3), eta = 0.5 * (i / 3);
    const double x[3] = {xi, eta, 1. - (xi - 0.3) * (xi - 0.3) - (eta - 0.6) * (eta - 0.6)};
    std::copy(x, x + 3, &surface.positions[3 * surface.cell_nodes[i]]);
  }
  const CellGeometry geometry(surface, surface.positions);
  EXPECT_NEAR(largest_value(geometry, {{0., 0., 1.}, {}, {}}), 1., 1e-15);
  // On the edge eta = 1: the maximum of z + 2 y is at xi = 0.3, eta = 1.
  EXPECT_NEAR(largest_value(geometry, {{0., 2., 1.}, {}, {}}), 2. + 1. - 0.16, 1e-15);
  // At the vertex (1, 0).
  EXPECT_NEAR(largest_value(geometry, {{9., -9., 1.}, {}, {}}), 9. + 1. - 0.49 - 0.36, 1e-14);
}

TEST(ShapeMeasures, BiconcaveDisc)
{
  const SmoothShape disc = scaled_to_area(biconcave(), 4. * pi);
  const double scale     = std::sqrt(4. * pi / biconcave().area);
  const auto surface     = on_cube_sphere(disc, 3, 3);
  const auto m           = measure_shape(surface, surface.positions);
  EXPECT_NEAR(m.axis_thickness, 2. * 0.1242 * scale, 1e-12);
  EXPECT_NEAR(m.equatorial_radius, scale, 1e-4);
  // Largest z: stationary in t = sin^2 p of (c0 + c1 t + c2 t^2) sqrt(1 - t).
  double z = 0.;
  for (double t = 0.; t < 1.; t += 1e-5)
    z = std::max(z, (0.1242 + 0.8012 * t - 0.4492 * t * t) * std::sqrt(1. - t));
  EXPECT_NEAR(m.height, 2. * z * scale, 1e-4);
  EXPECT_GT(m.height, m.axis_thickness);
}

// The axis passes through the hole of an upright torus and through the tube of a tipped one, twice.
TEST(ShapeMeasures, Torus)
{
  const double R = 2., r = 0.75;
  const auto surface = torus(R / r, 4. * pi * pi * R * r, 4, 2);
  const auto upright = measure_shape(surface, surface.positions);
  EXPECT_EQ(upright.axis_thickness, 0.);
  EXPECT_NEAR(upright.gauss_bonnet, 0., 1e-3);
  EXPECT_NEAR(upright.height, 2. * r, 1e-5);
  EXPECT_NEAR(upright.equatorial_radius, R + r, 1e-5);
  EXPECT_NEAR(upright.volume, 2. * pi * pi * R * r * r, 1e-5);

  const auto tipped = measure_shape(surface, tipped_over(surface.positions));
  EXPECT_NEAR(tipped.axis_thickness, 4. * r, 1e-5);
  EXPECT_NEAR(tipped.height, 2. * (R + r), 1e-5);

  const NodalVectors tilted =
      turned_and_shifted(tipped_over(turned_and_shifted(surface.positions, 0.2, {})), 0.5, {3., -2., 1.});
  const CellGeometry geometry(surface, tilted);
  const auto crossings = axis_crossings(geometry, 3., -2.);
  ASSERT_EQ(crossings.size(), 4U);
  for (unsigned int i = 0; i < 4; ++i)
    EXPECT_EQ(crossings[i].direction, i % 2 == 0 ? -1 : 1);
  EXPECT_NEAR(length_inside(crossings), 4. * r, 1e-5);
}

TEST(ShapeMeasures, UnbalancedCrossingsHaveNoLength)
{
  EXPECT_TRUE(std::isnan(length_inside({{-1., -1}, {1., 1}, {2., 1}})));
  EXPECT_EQ(length_inside({{-1., -1}, {1.5, 1}}), 2.5);
  EXPECT_EQ(length_inside({}), 0.);
}

// Upright the axis passes the mouth and one wall; tipped over it passes two.
TEST(ShapeMeasures, StomatocyteCountsWalls)
{
  const SmoothShape cup = stomatocyte(0.6);
  const double inner = cup.point({0., 0., 1.})[2], outer = cup.point({0., 0., -1.})[2];
  const auto surface = on_cube_sphere(cup, 3, 3);
  const auto upright = measure_shape(surface, surface.positions);
  EXPECT_NEAR(upright.axis_thickness, inner - outer, 1e-12);
  EXPECT_GT(upright.height, 3. * upright.axis_thickness);

  const NodalVectors tipped = tipped_over(surface.positions);
  const auto m              = measure_shape(surface, tipped);
  EXPECT_EQ(axis_crossings(CellGeometry(surface, tipped), m.centroid[0], m.centroid[1]).size(), 4U);
  // Two nearly spherical walls of the same thickness, met obliquely.
  EXPECT_NEAR(m.axis_thickness, 2. * (inner - outer), 0.1 * (inner - outer));

  const auto meridian = on_meridian(cup, 3, 4, false);
  EXPECT_NEAR(measure_shape(meridian, meridian.positions).axis_thickness, inner - outer, 1e-12);
}

TEST(ShapeMeasures, InvariantUnderRotationAboutTheAxisAndTranslation)
{
  const auto surface       = on_cube_sphere(ellipsoid({{1.4, 1., 0.6}}), 3, 2);
  const auto before        = measure_shape(surface, surface.positions);
  const NodalVectors moved = turned_and_shifted(surface.positions, 0.9, {7., -4., 11.});
  const auto after         = measure_shape(surface, moved);
  expect_same(before, after, 1e-12);
  EXPECT_NEAR(after.centroid[0], 7., 1e-12);
  EXPECT_NEAR(after.centroid[1], -4., 1e-12);
  EXPECT_NEAR(after.centroid[2], 11., 1e-12);
}

// Nothing depends on the unit.
TEST(ShapeMeasures, ScalesWithTheUnit)
{
  const auto surface = on_cube_sphere(ellipsoid({{1.4, 1., 0.6}}), 3, 2);
  const double unit  = 1e-9;
  auto small = measure_shape(surface, moved(surface.positions, [&](const Vector3<double> &x) { return unit * x; }));
  small.area /= unit * unit;
  small.volume /= unit * unit * unit;
  for (double *const length : {&small.height, &small.equatorial_radius, &small.axis_thickness})
    *length /= unit;
  expect_same(measure_shape(surface, surface.positions), small, 1e-12);
}

TEST(ShapeMeasures, MeridianAgreesWithSurface)
{
  for (const SmoothShape &shape : {prolate_spheroid(0.9), oblate_spheroid(0.8), biconcave(), stomatocyte(0.6)})
  {
    const auto surface  = on_cube_sphere(shape, 4, 3);
    const auto meridian = on_meridian(shape, 4, 4, false);
    const auto a = measure_shape(surface, surface.positions), b = measure_shape(meridian, meridian.positions);
    EXPECT_NEAR(a.area, b.area, 1e-4 * b.area);
    EXPECT_NEAR(a.volume, b.volume, 1e-4 * b.volume);
    EXPECT_NEAR(a.height, b.height, 1e-4 * b.height);
    EXPECT_NEAR(a.equatorial_radius, b.equatorial_radius, 1e-4);
    EXPECT_NEAR(a.axis_thickness, b.axis_thickness, 1e-10);
    EXPECT_NEAR(a.centroid[2], b.centroid[2], 1e-4);
    EXPECT_NEAR(b.gauss_bonnet, 2., 1e-4);
    EXPECT_NEAR(b.min_cell_quality, 1., 1e-14);
    EXPECT_EQ(b.centroid[0], 0.);
    EXPECT_GT(b.cell_area_ratio, 1.);
    if (shape.up_down_symmetric)
    {
      const auto half = on_meridian(shape, 4, 4, true);
      expect_same(b, measure_shape(half, half.positions), 1e-11);
    }
  }
}

TEST(ShapeMeasures, RippledSurfaceOffNodes)
{
  // No symmetry at all: the measures are still those of the surface that a dense sample sees.
  auto surface = on_cube_sphere(sphere(1.), 3, 2);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> noise(-0.02, 0.02);
  for (double &x : surface.positions)
    x += noise(random);
  const auto m = measure_shape(surface, surface.positions);
  const CellGeometry geometry(surface, surface.positions);
  double top = -10., bottom = 10., radius = 0.;
  for (std::size_t cell = 0; cell < geometry.n_cells(); ++cell)
    for (unsigned int i = 0; i <= 60; ++i)
      for (unsigned int j = 0; j <= 60; ++j)
      {
        const Vector3<double> x = geometry.at({cell, {{i / 60., j / 60.}}}).x - m.centroid;
        top                     = std::max(top, x[2]);
        bottom                  = std::min(bottom, x[2]);
        radius                  = std::max(radius, std::hypot(x[0], x[1]));
      }
  EXPECT_GE(m.height, top - bottom - 1e-14);
  EXPECT_NEAR(m.height, top - bottom, 1e-3);
  EXPECT_GE(m.equatorial_radius, radius - 1e-14);
  EXPECT_NEAR(m.equatorial_radius, radius, 1e-3);
  EXPECT_EQ(axis_crossings(geometry, m.centroid[0], m.centroid[1]).size(), 2U);
}
} // namespace

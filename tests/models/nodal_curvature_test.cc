// SPDX-License-Identifier: LGPL-2.1-or-later
#include "shapes.h"

#include <pellicle/assembly/nodal_chart.h>
#include <pellicle/models/nodal_curvature.h>
#include <pellicle/models/shape_measures.h>

#include <gtest/gtest.h>

#include <functional>

namespace
{
using namespace pellicle;
using namespace pellicle::test_shapes;

using Exact = std::function<double(const Vector3<double> &)>;

/** L2 error over the area, relative to the exact function's norm, of a scalar nodal field. */
double relative_error(const SurfaceDiscretization &surface, const std::vector<double> &nodal, const Exact &exact)
{
  const ShapeTables &tables = surface.tables;
  std::vector<double> inputs(18 * tables.n_points);
  double error = 0., size = 0.;
  for (std::size_t cell = 0; cell < surface.n_cells; ++cell)
  {
    const std::size_t *nodes = &surface.cell_nodes[cell * tables.n_nodes];
    evaluate_field(tables, nodes, surface.positions, 3, inputs.data());
    for (unsigned int q = 0; q < tables.n_points; ++q)
    {
      const double *v = &inputs[18 * q];
      double value    = 0.;
      for (unsigned int I = 0; I < tables.n_nodes; ++I)
        value += tables.tables[0][q * tables.n_nodes + I] * nodal[nodes[I]];
      const double wanted = exact({v[0], v[1], v[2]});
      const double dA =
          tables.weights[q] * norm(cross(Vector3<double>(v[3], v[4], v[5]), Vector3<double>(v[6], v[7], v[8])));
      error += dA * (value - wanted) * (value - wanted);
      size += dA * wanted * wanted;
    }
  }
  return std::sqrt(error / size);
}

/** Of the level set x^2/a^2 + y^2/b^2 + z^2/c^2 = 1: 2 H_out = div n, and K = 1/(a b c |g|^2)^2 with g = (x/a^2, ...).
 */
struct EllipsoidCurvature
{
  double a, b, c;

  Vector3<double> gradient(const Vector3<double> &x) const { return {x[0] / (a * a), x[1] / (b * b), x[2] / (c * c)}; }
  double mean(const Vector3<double> &x) const
  {
    const Vector3<double> g = gradient(x);
    const double trace      = 1. / (a * a) + 1. / (b * b) + 1. / (c * c);
    const double along      = (g[0] * g[0] / (a * a) + g[1] * g[1] / (b * b) + g[2] * g[2] / (c * c)) / dot(g, g);
    return 0.5 * (trace - along) / norm(g);
  }
  double gauss(const Vector3<double> &x) const { return std::pow(a * b * c * dot(gradient(x), gradient(x)), -2.); }
};

struct TorusCurvature
{
  double R, r;

  double cosine(const Vector3<double> &x) const { return (std::hypot(x[0], x[1]) - R) / r; }
  double mean(const Vector3<double> &x) const { return 0.5 * (1. / r + cosine(x) / (R + r * cosine(x))); }
  double gauss(const Vector3<double> &x) const { return cosine(x) / (r * (R + r * cosine(x))); }
};

/** Observed order between two refinements. */
void expect_order(const std::function<SurfaceDiscretization(unsigned int)> &make, const unsigned int coarse,
                  const Exact &mean, const Exact &gauss, const double mean_order, const double gauss_order)
{
  double errors[2][2];
  for (unsigned int level = 0; level < 2; ++level)
  {
    const auto surface   = make(coarse + level);
    const auto curvature = nodal_curvature(surface, surface.positions);
    errors[level][0]     = relative_error(surface, curvature.mean_outward, mean);
    errors[level][1]     = relative_error(surface, curvature.gauss, gauss);
  }
  const auto order = [&](const unsigned int which) { return std::log2(errors[0][which] / errors[1][which]); };
  EXPECT_GT(order(0), mean_order);
  EXPECT_GT(order(1), gauss_order);
}

TEST(NodalCurvature, Sphere)
{
  const double R       = 2.5;
  const auto surface   = on_cube_sphere(sphere(R), 3, 3);
  const auto curvature = nodal_curvature(surface, surface.positions);
  const auto of_sphere = [&](const auto &) { return 1. / R; };
  EXPECT_LT(relative_error(surface, curvature.mean_outward, of_sphere), 5e-5);
  EXPECT_LT(relative_error(surface, curvature.gauss, [&](const auto &) { return 1. / (R * R); }), 5e-3);
  EXPECT_NEAR(integrated_mean_curvature(surface, surface.positions, curvature.curvature_vector), 4. * pi * R, 1e-6);
}

TEST(NodalCurvature, OrderOnAnEllipsoid)
{
  const EllipsoidCurvature exact{1.3, 1., 0.8};
  for (unsigned int k = 2; k <= 4; ++k)
    expect_order(
        [&](const unsigned int r) {
          return on_cube_sphere(ellipsoid({{exact.a, exact.b, exact.c}}), k, r);
        },
        2, [&](const auto &x) { return exact.mean(x); }, [&](const auto &x) { return exact.gauss(x); }, k - 0.2,
        k - 1.2);
}

TEST(NodalCurvature, OrderOnATorus)
{
  const TorusCurvature exact{1.6, 0.7};
  for (unsigned int k = 2; k <= 4; ++k)
    expect_order([&](const unsigned int r) { return torus(exact.R / exact.r, 4. * pi * pi * exact.R * exact.r, k, r); },
                 k == 2 ? 2 : 1, [&](const auto &x) { return exact.mean(x); },
                 [&](const auto &x) { return exact.gauss(x); }, k - 0.2, k - 1.2);
}

TEST(NodalCurvature, OrderOnAMeridian)
{
  const EllipsoidCurvature exact{0.8, 0.8, 1.3};
  for (const bool mirror : {false, true})
    for (unsigned int k = 2; k <= 4; ++k)
      expect_order(
          [&](const unsigned int r) {
            return on_meridian(ellipsoid({{exact.a, exact.b, exact.c}}), k, r, mirror);
          },
          2, [&](const auto &x) { return exact.mean(x); }, [&](const auto &x) { return exact.gauss(x); }, k - 0.2,
          k - 1.2);
}

TEST(NodalCurvature, MeridianRespectsPolesAndMirror)
{
  const double R    = 1.7;
  const auto half   = on_meridian(sphere(R), 3, 3, true);
  const auto result = nodal_curvature(half, half.positions);
  EXPECT_EQ(result.curvature_vector[0], 0.);
  EXPECT_EQ(result.curvature_vector.back(), 0.);
  for (std::size_t I = 0; I < half.n_nodes; ++I)
  {
    EXPECT_EQ(result.curvature_vector[3 * I + 1], 0.);
    EXPECT_NEAR(result.mean_outward[I], 1. / R, 1e-3);
  }
  EXPECT_NEAR(integrated_mean_curvature(half, half.positions, result.curvature_vector), 4. * pi * R, 1e-6);
}

// With dA = r (R + r cos v) du dv: integral of (1/r + cos v/(R + r cos v))/2 is 2 pi^2 R, that of the projected scalar
// the same.
TEST(NodalCurvature, IntegratedMeanCurvatureOfATorus)
{
  const double R = 1.6, r = 0.7;
  const auto surface = torus(R / r, 4. * pi * pi * R * r, 4, 2);
  const auto result  = nodal_curvature(surface, surface.positions);
  EXPECT_NEAR(integrated_mean_curvature(surface, surface.positions, result.curvature_vector), 2. * pi * pi * R, 1e-5);

  // Integrals of the nodal shape functions: row sums of the mass matrix.
  std::vector<double> areas(surface.n_nodes, 0.);
  std::vector<double> inputs(std::size_t(surface.tables.n_points) * 18);
  for (std::size_t cell = 0; cell < surface.n_cells; ++cell)
  {
    const std::size_t *nodes = &surface.cell_nodes[cell * surface.n_local()];
    evaluate_field(surface.tables, nodes, surface.positions, 3, inputs.data());
    for (unsigned int q = 0; q < surface.tables.n_points; ++q)
    {
      const double *x = &inputs[18 * q];
      const double dA =
          surface.tables.weights[q] * norm(cross(Vector3<double>(x[3], x[4], x[5]), Vector3<double>(x[6], x[7], x[8])));
      for (unsigned int I = 0; I < surface.n_local(); ++I)
        areas[nodes[I]] += dA * surface.tables.tables[0][q * surface.n_local() + I];
    }
  }
  double H = 0., K = 0.;
  for (std::size_t I = 0; I < surface.n_nodes; ++I)
  {
    H += areas[I] * result.mean_outward[I];
    K += areas[I] * result.gauss[I];
  }
  EXPECT_NEAR(H, integrated_mean_curvature(surface, surface.positions, result.curvature_vector), 1e-11);
  EXPECT_NEAR(K, 2. * pi * measure_shape(surface, surface.positions).gauss_bonnet, 1e-11);
}

TEST(NodalCurvature, FollowsRigidMotions)
{
  const auto surface = on_cube_sphere(ellipsoid({{1.3, 1., 0.8}}), 3, 1);
  const auto before  = nodal_curvature(surface, surface.positions);
  const auto after   = nodal_curvature(surface, turned_and_shifted(tipped_over(surface.positions), 0.7, {5., 6., -7.}));
  const auto turned  = turned_and_shifted(tipped_over(before.curvature_vector), 0.7, {});
  for (std::size_t I = 0; I < surface.n_nodes; ++I)
  {
    EXPECT_NEAR(after.mean_outward[I], before.mean_outward[I], 1e-11);
    EXPECT_NEAR(after.gauss[I], before.gauss[I], 1e-10);
    EXPECT_NEAR(norm(node(after.curvature_vector, I) - node(turned, I)), 0., 1e-11);
  }
}

TEST(NodalCurvature, CollapsedSurfaceIsRefused)
{
  const auto surface = on_cube_sphere(sphere(1.), 2, 1);
  const NodalVectors flat(3 * surface.n_nodes, 0.);
  EXPECT_ANY_THROW(nodal_curvature(surface, flat));
}
} // namespace

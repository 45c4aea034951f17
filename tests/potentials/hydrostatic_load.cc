// SPDX-License-Identifier: LGPL-2.1-or-later
// The load of a hydrostatic pressure p = P + f . x and its tangent, assembled without use of any potential: symmetric
// on closed surfaces and over planar rims with enough Gauss points (correction E3 to Sauer 2014), and then the gradient
// of the energy -P V - integral of f . x that the program has.
#include <pellicle/discretization/builders.h>
#include <pellicle/discretization/point_walk.h>
#include <pellicle/potentials/constraints/enclosed_volume.h>
#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/energies/gravity.h>
#include <pellicle/potentials/energies/pressure.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{
using namespace pellicle;

const Vector3<double> force(0.3, -0.2, -1.1);

NodalVectors random_vectors(const SurfaceDiscretization &surface, const double size, const unsigned int seed)
{
  std::mt19937 random(seed);
  NodalVectors result(3 * surface.n_nodes);
  for (double &x : result)
    x = size * (random() / 2147483648. - 1.);
  for (const EdgeLoop &rim : surface.edges) // rims stay in their plane
    for (const std::size_t node : rim.cell_nodes)
      result[3 * node + 2] = 0.;
  return result;
}

SurfaceDiscretization shaken(SurfaceDiscretization surface)
{
  const NodalVectors noise = random_vectors(surface, 0.02, 11);
  for (std::size_t i = 0; i < noise.size(); ++i)
    surface.positions[i] += noise[i];
  return surface;
}

/** A point of three fields: position and two directions. */
template <typename Visit>
void for_all(const SurfaceDiscretization &surface, const ShapeTables &tables, const NodalVectors &v,
             const NodalVectors &w, const Visit &visit)
{
  std::vector<double> x(18 * std::size_t(tables.n_points)), dv(x.size()), dw(x.size());
  const auto at = [](const std::vector<double> &values, const unsigned int q, const unsigned int slot)
  {
    const double *u = values.data() + (std::size_t(q) * 6 + slot) * 3;
    return Vector3<double>(u[0], u[1], u[2]);
  };
  for (std::size_t c = 0; c < surface.n_cells; ++c)
  {
    const std::size_t *const nodes = surface.cell_nodes.data() + c * surface.n_local();
    evaluate_field(tables, nodes, surface.positions, 3, x.data());
    evaluate_field(tables, nodes, v, 3, dv.data());
    evaluate_field(tables, nodes, w, 3, dw.data());
    for (unsigned int q = 0; q < tables.n_points; ++q)
      visit(
          tables.weights[q], [&](const unsigned int s) { return at(x, q, s); },
          [&](const unsigned int s) { return at(dv, q, s); }, [&](const unsigned int s) { return at(dw, q, s); });
  }
}

/** |w . K v - v . K w| over the sum of its parts, K the tangent of the load w . F = integral of p w . (x,1 x x,2). */
double asymmetry(const SurfaceDiscretization &surface, const double P, const unsigned int n_gauss)
{
  const NodalVectors v = random_vectors(surface, 1., 3), w = random_vectors(surface, 1., 4);
  double difference = 0., size = 0.;
  for_all(surface, make_surface_tables(surface.degree, n_gauss), v, w,
          [&](const double weight, const auto &x, const auto &dv, const auto &dw)
          {
            const double p    = P + dot(force, x(0));
            const auto change = [&](const auto &d)
            { return dot(force, d(0)) * cross(x(1), x(2)) + p * (cross(d(1), x(2)) + cross(x(1), d(2))); };
            const double wKv = weight * dot(dw(0), change(dv)), vKw = weight * dot(dv(0), change(dw));
            difference += wKv - vKw;
            size += std::abs(wKv) + std::abs(vKw);
          });
  return std::abs(difference) / size;
}

TEST(HydrostaticLoad, IsSymmetricOnClosedSurfacesWithEnoughPoints)
{
  for (const unsigned int k : {2u, 3u})
  {
    const SurfaceDiscretization surface = shaken(on_cube_sphere(ellipsoid({{1.1, 0.9, 1.3}}), k, 0));
    EXPECT_LT(asymmetry(surface, 0.7, 2 * k), 1e-15) << k;
    EXPECT_GT(asymmetry(surface, 0.7, k), 1e-5) << k;
  }
}

TEST(HydrostaticLoad, IsSymmetricOverAPlanarRim)
{
  for (const unsigned int k : {2u, 3u})
  {
    const SurfaceDiscretization surface = shaken(cap(1.3, 5., k, 0, false));
    EXPECT_LT(asymmetry(surface, 0.7, 2 * k), 1e-15) << k;
    EXPECT_GT(asymmetry(surface, 0.7, k), 1e-5) << k;
  }
}

/** Derivative of a density's integral along v. */
double slope(const Potential &potential, const SurfaceDiscretization &surface, const ShapeTables &tables,
             const NodalVectors &v)
{
  constexpr unsigned int n     = 9;
  const unsigned int offsets[] = {0};
  double sum                   = 0.;
  for_all(surface, tables, v, v,
          [&](const double weight, const auto &x, const auto &dv, const auto & /*dw*/)
          {
            std::vector<double> inputs;
            for (const unsigned int s : {0u, 1u, 2u})
              for (unsigned int c = 0; c < 3; ++c)
                inputs.push_back(x(s)[c]);
            PointSums at;
            at.reset(1, n, Order::gradient);
            potential.add({0, 1, n, inputs.data()}, offsets, 1., Order::gradient, at);
            for (const unsigned int s : {0u, 1u, 2u})
              for (unsigned int c = 0; c < 3; ++c)
                sum += weight * at.gradient[3 * s + c] * dv(s)[c];
          });
  return sum;
}

TEST(HydrostaticLoad, IsTheGradientOfTheEnergies)
{
  for (const bool closed : {true, false})
  {
    const SurfaceDiscretization surface =
        shaken(closed ? on_cube_sphere(ellipsoid({{1.1, 0.9, 1.3}}), 2, 0) : cap(1.3, 5., 2, 0, false));
    const NodalVectors v   = random_vectors(surface, 1., 5);
    const ShapeTables four = make_surface_tables(2, 4);
    double pressure = 0., weight_of_liquid = 0.;
    for_all(surface, four, v, v,
            [&](const double weight, const auto &x, const auto &dv, const auto & /*dw*/)
            {
              const double along_normal = weight * dot(dv(0), cross(x(1), x(2)));
              pressure += along_normal;
              weight_of_liquid += dot(force, x(0)) * along_normal;
            });
    // Pushed outwards, the energies fall.
    EXPECT_NEAR(slope(DensityPotential<Pressure>("pressure", Pressure{1.}), surface, four, v), -pressure, 1e-13);
    EXPECT_NEAR(slope(DensityPotential<EnclosedVolume>("volume", EnclosedVolume{}), surface, four, v), pressure, 1e-13);
    EXPECT_NEAR(slope(DensityPotential<Gravity>("gravity", Gravity{force}), surface, four, v), -weight_of_liquid,
                1e-13);
    // Two points are not enough for gravity.
    EXPECT_GT(
        std::abs(slope(DensityPotential<Gravity>("gravity", Gravity{force}), surface, make_surface_tables(2, 2), v) +
                 weight_of_liquid),
        1e-6);
  }
}
} // namespace

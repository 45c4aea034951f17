// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies through the solver: patch tests, homogeneous stretch with free sides, an incompressible tube.
#include "body_runs.h"

#include "../mpi_environment.h"

#include <pellicle/base/constants.h>
#include <pellicle/potentials/solids/incompressible_liquid.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

constexpr double mu = 0.7, lambda = 1.3;
const std::vector<double> thirds{0., 0.3, 0.7, 1.};

std::vector<std::size_t> boundary_nodes(const BulkPart &body)
{
  std::set<std::size_t> all;
  for (const auto &[name, nodes] : body.faces)
    all.insert(nodes.begin(), nodes.end());
  return {all.begin(), all.end()};
}

/** Moves the nodes that are on no face at random within their admissible directions. */
void shake_inside(const SurfaceDiscretization &body, const double size, NodalVectors &positions)
{
  std::mt19937 random(3);
  std::vector<bool> fixed(body.n_nodes, false);
  for (const std::size_t I : boundary_nodes(body.bulks[0]))
    fixed[I] = true;
  for (std::size_t I = 0; I < body.n_nodes; ++I)
  {
    const AdmissibleDirections directions = body.admissible.empty() ? AdmissibleDirections{} : body.admissible[I];
    for (unsigned int j = 0; j < directions.count && !fixed[I]; ++j)
    {
      const double step = size * (random() / 2147483648. - 1.);
      for (unsigned int c = 0; c < 3; ++c)
        positions[3 * I + c] += step * directions.columns[j][c];
    }
  }
}

NodalVectors affine(const NodalVectors &X, const Matrix3 &F)
{
  NodalVectors x;
  for (std::size_t I = 0; 3 * I < X.size(); ++I)
  {
    const Vector3<double> moved = F * Vector3<double>(X[3 * I], X[3 * I + 1], X[3 * I + 2]);
    x.insert(x.end(), moved.components.begin(), moved.components.end());
  }
  return x;
}

double largest_difference(const NodalVectors &a, const NodalVectors &b)
{
  double largest = 0.;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

// Distorted cells whose boundary is moved as a homogeneous deformation asks: the inside follows to round-off.
TEST(Bodies, PatchTest)
{
  const Matrix3 F{{{1.2, 0.3, -0.2, 0.1, 0.8, 0.25, -0.15, 0.05, 1.1}}},
      revolved{{{1.2, 0., 0., 0., 1.2, 0., 0., 0., 0.8}}};
  for (const unsigned int degree : {1u, 2u, 3u})
    for (const bool axial : {false, true})
    {
      SurfaceDiscretization body = axial         ? cylinder("body", {thirds, thirds}, degree)
                                   : degree == 3 ? block("body", {{0., 0.4, 1.}, {0., 0.4, 1.}, {0., 0.6, 1.}}, degree)
                                                 : block("body", {thirds, thirds, thirds}, degree);
      // Of nodes that are displaced one by one, X,1 x X,2 times N,3 has the degree 3 k - 1: n Gauss points integrate 2
      // n - 1.
      if (degree == 3)
        body.bulks[0].tables = axial ? make_revolved_quad_tables(3, 5) : make_hexahedron_tables(3, 5);
      shake_inside(body, 0.1 / (degree * degree), body.positions);
      NodalConditions conditions;
      hold_nodes(conditions, "position", boundary_nodes(body.bulks[0]), body.n_nodes);
      PotentialSet set;
      set.energies.push_back(solid(body, {mu, lambda}));
      BodyRun run(body, set, conditions);
      run.parameters.tolerance = 1e-13;

      const NodalVectors exact = affine(body.positions, axial ? revolved : F);
      NodalVectors start       = exact;
      shake_inside(body, 0.02, start);
      run.place(start);
      const NewtonResult result = run.solve();
      ASSERT_TRUE(result.converged) << result.failure;
      EXPECT_LT(largest_difference(run.positions(), exact), 1e-12) << degree << axial;
    }
}

// The top is moved, the sides are free: the stretch b across follows from mu (b^2 - 1) + (lambda/2) (J^2 - 1) = 0,
// J = l b^2, and the force per reference area is mu (l - b^2/l).
TEST(Bodies, StretchWithFreeSides)
{
  const double l = 1.3, A = 0.5 * lambda * l * l,
               b2 = (-mu + std::sqrt(mu * mu + 4. * A * (mu + 0.5 * lambda))) / (2. * A), b = std::sqrt(b2);
  for (const bool axial : {false, true})
  {
    SurfaceDiscretization body =
        axial ? cylinder("body", {thirds, thirds}, 2) : block("body", {thirds, thirds, thirds}, 2);
    auto &faces = body.bulks[0].faces;
    keep_on_plane(body, faces["bottom"], {0., 0., 1.});
    keep_on_plane(body, faces["top"], {0., 0., 1.});
    if (!axial)
    {
      keep_on_plane(body, faces["left"], {1., 0., 0.});
      keep_on_plane(body, faces["front"], {0., 1., 0.});
    }
    PotentialSet set;
    set.energies.push_back(solid(body, {mu, lambda, VolumetricLaw::quadratic}));
    BodyRun run(body, set, {});
    run.parameters.tolerance = 1e-13;
    run.place(affine(body.positions, {{{1., 0., 0., 0., 1., 0., 0., 0., l}}}));
    const NewtonResult result = run.solve();
    ASSERT_TRUE(result.converged) << result.failure;
    EXPECT_LT(largest_difference(run.positions(), affine(body.positions, {{{b, 0., 0., 0., b, 0., 0., 0., l}}})),
              1e-12);
    double force = 0.;
    for (const std::size_t I : faces["top"])
      force += run.problem.nodal_forces().total[3 * I + 2];
    EXPECT_NEAR(force, (axial ? pi : 1.) * mu * (l - b2 / l), 1e-12);
  }
}

/** An incompressible tube in plane strain, inner radius 1 widened to 1.5, outer radius 2: radius outside, work
 * conjugate pressure inside, largest change of a cell's volume. */
struct Tube
{
  double outer_radius = 0., pressure = 0., change_of_volume = 0.;
  int iterations = 0;
};

Tube widened_tube(const unsigned int degree, const unsigned int n_cells)
{
  SurfaceDiscretization body = cylinder("body", {cell_ends(1., 2., n_cells), {0., 0.25}}, degree);
  auto &faces                = body.bulks[0].faces;
  keep_on_plane(body, faces["bottom"], {0., 0., 1.});
  keep_on_plane(body, faces["top"], {0., 0., 1.});
  add_pressure_nodes(body, 0);
  NodalConditions conditions;
  hold_nodes(conditions, "position", faces["inner side"], body.n_nodes);
  PotentialSet set;
  set.energies.push_back(solid(body, {mu, 0.}));
  set.energies.push_back(std::make_shared<DensityPotential<IncompressibleLiquid>>(
      "incompressibility", IncompressibleLiquid{{}, reference_of(body)}, in_body));
  BodyRun run(body, set, conditions);
  NodalVectors start = body.positions;
  for (std::size_t I = 0; I < body.n_nodes; ++I)
    start[3 * I] += start[3 * I] > 0. ? 0.5 : 0.; // not yet at constant volume
  run.place(start);
  const NewtonResult result = run.solve();
  EXPECT_TRUE(result.converged) << result.failure;

  Tube tube;
  tube.iterations          = result.iterations;
  tube.outer_radius        = run.positions()[3 * faces["side"][0]];
  const NodalVectors force = run.problem.nodal_forces().total;
  for (const std::size_t I : faces["inner side"])
    tube.pressure += force[3 * I] / (2. * pi * 1.5 * 0.25);
  const std::vector<ReferenceBasis> before = reference_bases(body.bulks[0], body.positions),
                                    after  = reference_bases(body.bulks[0], run.positions());
  const ShapeTables &tables                = body.bulks[0].tables;
  for (std::size_t c = 0; c < body.bulks[0].n_cells; ++c)
  {
    double change = 0., volume = 0.;
    for (unsigned int q = 0; q < tables.n_points; ++q)
    {
      volume += tables.weights[q] * before[c * tables.n_points + q].volume;
      change += tables.weights[q] * (after[c * tables.n_points + q].volume - before[c * tables.n_points + q].volume);
    }
    tube.change_of_volume = std::max(tube.change_of_volume, std::abs(change / volume));
  }
  return tube;
}

// r^2 = R^2 + c; dsigma_rr/dr = mu (r^2/R^2 - R^2/r^2)/r with sigma_rr = 0 outside.
TEST(Bodies, IncompressibleTube)
{
  const double a = 1.5, c = a * a - 1., b = std::sqrt(4. + c),
               pressure = mu * (std::log(2. * a / b) + 0.5 * c * (1. / (a * a) - 1. / (b * b)));
  for (const unsigned int degree : {2u, 3u})
  {
    const Tube coarse = widened_tube(degree, 4), fine = widened_tube(degree, 8);
    for (const Tube &tube : {coarse, fine})
    {
      EXPECT_NEAR(tube.outer_radius, b, 1e-11); // the volume is exact
      EXPECT_LT(tube.change_of_volume, 1e-12);
      EXPECT_LE(tube.iterations, 12);
    }
    EXPECT_NEAR(fine.pressure, pressure, 1e-5);
    const double rate = std::log2(std::abs(coarse.pressure - pressure) / std::abs(fine.pressure - pressure));
    EXPECT_GT(rate, 2. * degree - 0.5) << coarse.pressure - pressure << " " << fine.pressure - pressure;
  }
}
} // namespace

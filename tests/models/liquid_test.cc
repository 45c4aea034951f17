// SPDX-License-Identifier: LGPL-2.1-or-later
// Full and reduced systems of Sauer 2014 (sections 3.7 and 3.8) against each other and against exact drops.
#include "liquid_runs.h"

#include "../expect_user_error.h"
#include "../mpi_environment.h"

#include <gtest/gtest.h>

#include <set>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

void expect_equal(const Equilibrium &a, const Equilibrium &b, const double tolerance)
{
  EXPECT_TRUE(a.newton.converged) << a.newton.failure;
  EXPECT_TRUE(b.newton.converged) << b.newton.failure;
  EXPECT_NEAR(a.radius, b.radius, tolerance);
  EXPECT_NEAR(a.apex, b.apex, tolerance);
  EXPECT_NEAR(a.energy, b.energy, tolerance);
  EXPECT_NEAR(a.volume, b.volume, tolerance);
  EXPECT_NEAR(a.pressure, b.pressure, tolerance);
}

TEST(FilledCap, CellsFillTheCap)
{
  for (const bool axial : {true, false})
    for (const double angle : {40., 90., 130.})
    {
      const double theta = angle * pi / 180.,
                   exact = pi / 3. * std::pow(1. - std::cos(theta), 2) * (2. + std::cos(theta));
      double error[2]    = {0., 0.};
      for (const unsigned int cuts : {0u, 1u})
      {
        const SurfaceDiscretization drop = filled_cap(theta, 2. * pi * (1. - std::cos(theta)), 2, cuts, axial);
        const BulkPart &liquid           = drop.bulks[0];
        EXPECT_EQ(liquid.n_cells, axial ? 3 << (2 * cuts) : 16 << (3 * cuts));
        EXPECT_NO_THROW(reference_bases(liquid, drop.positions)); // all oriented, none degenerate
        error[cuts] = std::abs(bulk_volume(drop, drop.positions) - exact);
        const std::set<std::size_t> used(liquid.cell_nodes.begin(), liquid.cell_nodes.end());
        EXPECT_EQ(used.size(), drop.n_nodes); // shared, none without a cell
        for (const std::size_t I : drop.cell_nodes)
          EXPECT_TRUE(used.count(I) == 1);
        for (const std::size_t I : liquid.faces.at("base"))
          EXPECT_EQ(drop.positions[3 * I + 2], 0.);
      }
      EXPECT_GT(std::log2(error[0] / error[1]), 3.5) << axial << " " << angle << " " << error[0] << " " << error[1];
    }
  expect_user_error([] { filled_cap(pi, 1., 2, 0, true); }, {"3.14159", "between 0 and pi"});
  expect_user_error([] { filled_cap(1., 1., 4, 0, false); }, {"Degree = 4", "1 to 3"});
}

struct ExactDrop
{
  double angle, weight, radius, apex, energy, pressure; ///< pressure at the base
};
// Without weight in closed form, with weight from the Young-Laplace equation.
const std::vector<ExactDrop> exact_drops{{60., 0., 1.276185946466, 0.736806299728, 4.263797221535, 1.357208808297},
                                         {90., 0., 1., 1., 2. * pi, 2.},
                                         {60., 1., 1.332567052010, 0.655300788259, 4.775949806280, 1.675216511574},
                                         {90., 1., 1.069538931973, 0.880630769504, 7.016507814302, 2.452759290254}};

TEST(FullSystem, IsTheReducedOneAndFindsExactDrops)
{
  for (const bool axial : {true, false})
    for (const ExactDrop &exact : exact_drops)
    {
      Drop drop;
      drop.axial             = axial;
      drop.degree            = axial ? 3 : 2;
      drop.cuts              = axial ? 1 : 0;
      drop.angle             = exact.angle;
      drop.weight            = exact.weight;
      const Equilibrium full = equilibrium_of(drop, System::full), reduced = equilibrium_of(drop, System::reduced);
      SCOPED_TRACE(std::to_string(exact.angle) + (axial ? " axial" : " 3-D"));
      expect_equal(full, reduced, 1e-8);
      EXPECT_LT(full.spread, 1e-7); // p_f = p_v + rho b . x at every point
      EXPECT_LE(full.newton.iterations, 7);
      const double accuracy = axial ? 1. : 1500.; // 16 quadratic hexahedra
      EXPECT_NEAR(full.radius, exact.radius, 1e-6 * accuracy);
      EXPECT_NEAR(full.apex, exact.apex, 3e-5 * accuracy);
      EXPECT_NEAR(full.energy, exact.energy, 1e-6 * accuracy);
      EXPECT_NEAR(full.pressure, exact.pressure, 1e-5 * accuracy);
    }
}

TEST(FullSystem, ConvergesAtTwiceTheDegree)
{
  Drop drop;
  drop.degree = 2;
  drop.angle  = 60.;
  drop.weight = 1.;
  double error[2];
  for (const unsigned int r : {0u, 1u})
  {
    drop.cuts = r + 1;
    error[r]  = std::abs(equilibrium_of(drop, System::full).radius - exact_drops[2].radius);
  }
  EXPECT_GT(std::log2(error[0] / error[1]), 3.5) << error[0] << " " << error[1];
}

TEST(FullSystem, DragHasNoInfluenceOnTheResult)
{
  Drop drop;
  drop.degree            = 2;
  drop.angle             = 60.;
  drop.weight            = 1.;
  const Equilibrium some = equilibrium_of(drop, System::full);
  for (const double drag : {1e-6, 0.1})
  {
    drop.drag               = drag;
    const Equilibrium other = equilibrium_of(drop, System::full);
    expect_equal(other, some, 1e-8);
  }
}

// K (1 - V/V0) = 2/R with V = V0 (R/R0)^3.
TEST(FullSystem, CompressibleDropsHaveTheVolumeOfTheirLaw)
{
  Drop drop;
  drop.angle      = 60.;
  const double R0 = exact_drops[0].radius / std::sin(pi / 3.);
  for (const double K : {10., 1e4})
  {
    double lower = 0.6 * R0, upper = R0;
    for (int i = 0; i < 60; ++i)
    {
      const double R                                            = 0.5 * (lower + upper);
      (K * (1. - std::pow(R / R0, 3)) > 2. / R ? lower : upper) = R;
    }
    const double R = lower, volume = drop_volume * std::pow(R / R0, 3);
    drop.compliance           = 1. / K;
    const Equilibrium reduced = equilibrium_of(drop, System::reduced), full = equilibrium_of(drop, System::full);
    drop.tolerance                 = 1e-6; // nodes inside go on creeping
    const Equilibrium by_the_point = equilibrium_of(drop, System::full_without_pressure);
    drop.tolerance                 = Drop{}.tolerance;
    expect_equal(full, reduced, 1e-8);
    EXPECT_NEAR(reduced.volume, volume, 1e-6);
    EXPECT_NEAR(reduced.pressure, 2. / R, 1e-5);
    EXPECT_NEAR(reduced.radius, R * std::sin(pi / 3.), 1e-6);
    EXPECT_TRUE(by_the_point.newton.converged) << by_the_point.newton.failure;
    EXPECT_NEAR(by_the_point.volume, volume, 1e-6);
    EXPECT_NEAR(by_the_point.radius, full.radius, 1e-5);
  }
  // V = V0 (1 - p/K): stiff liquids tend to the incompressible one.
  drop.compliance         = 1e-6;
  drop.weight             = 1.;
  const Equilibrium stiff = equilibrium_of(drop, System::full);
  drop.compliance         = 0.;
  const Equilibrium rigid = equilibrium_of(drop, System::full);
  EXPECT_NEAR(stiff.volume / drop_volume, 1. - 1e-6 * stiff.pressure, 1e-10);
  EXPECT_NEAR(stiff.radius, rigid.radius, 2e-6);
  EXPECT_NE(stiff.radius, rigid.radius);
}

// The equilibrium does not depend on the tangent, but the way to it does.
TEST(FullSystem, TangentAsPrintedCostsIterations)
{
  Drop drop;
  drop.angle                = 60.;
  drop.weight               = 1.;
  drop.tolerance            = 1e-9;
  drop.max_iterations       = 60;
  const Equilibrium correct = equilibrium_of(drop, System::full),
                    printed = equilibrium_of(drop, System::full_as_printed);
  EXPECT_TRUE(correct.newton.converged);
  EXPECT_LE(correct.newton.iterations, 6);
  EXPECT_TRUE(printed.newton.converged) << printed.newton.failure;
  EXPECT_GE(printed.newton.iterations, 2 * correct.newton.iterations);
  EXPECT_NEAR(printed.radius, correct.radius, 1e-7);
}

// With p_f itself in the cells' polynomials and a dead load, forces of the size of the discretisation error are left on
// nodes that nothing holds: the iteration comes close and drifts away.
TEST(FullSystem, DeadLoadLeavesForcesInside)
{
  Drop drop;
  drop.weight            = 1.;
  drop.drag              = 1.;
  drop.max_iterations    = 15;
  const Equilibrium dead = equilibrium_of(drop, System::full_dead_load);
  EXPECT_FALSE(dead.newton.converged);
  EXPECT_GT(dead.newton.relative_residual, 1e-4);
  EXPECT_NEAR(dead.radius, exact_drops[3].radius, 5e-5);
  EXPECT_GT(dead.spread, 1e-3);
  EXPECT_LT(dead.spread, 1e-2);
}
} // namespace

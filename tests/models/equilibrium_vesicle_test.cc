// SPDX-License-Identifier: LGPL-2.1-or-later
// Vesicles of fixed area and volume: energies of the known branches, and how Newton's method gets there.
#include "equilibrium_runs.h"

#include <pellicle/models/nodal_curvature.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

// E/(8 pi kappa) of the axisymmetric solutions, converged to the digits given.
constexpr double prolate_95 = 1.0955648795, prolate_65 = 1.8279298731, discocyte_65 = 1.8262334456,
                 stomatocyte_62 = 1.97388824;

double relative(const double value, const double exact)
{
  return value / exact - 1.;
}

void expect_targets_met(const Solved &solved, const double reduced_volume)
{
  const ShapeMeasures shape = solved.shape();
  EXPECT_NEAR(shape.area / (4. * pi), 1., 1e-10);
  EXPECT_NEAR(shape.volume / (4. * pi / 3.), reduced_volume, 1e-10);
}

TEST(EquilibriumVesicle, ProlateNearTheSphere)
{
  Solved prolate(vesicle("prolate", 0.95, 3, 2));
  ASSERT_TRUE(prolate.result.converged) << prolate.result.failure;
  EXPECT_NEAR(relative(prolate.energy(), prolate_95), 0., 2e-6) << prolate.energy();
  EXPECT_LE(prolate.result.iterations, 7);
  EXPECT_EQ(prolate.record.iterations.size(), static_cast<std::size_t>(prolate.result.iterations));
  expect_quadratic_tail(prolate.record.iterations, 1e-3, 100., 1e-10);
  EXPECT_NEAR(prolate.sigma(), -5.364000, 1e-4);
  EXPECT_NEAR(prolate.pressure(), -11.292632, 1e-4);
  const ShapeMeasures shape = prolate.shape();
  EXPECT_NEAR(2. * prolate.sigma() * shape.area, 3. * prolate.pressure() * shape.volume, 1e-4);
  expect_targets_met(prolate, 0.95);
  EXPECT_EQ(prolate.negative_eigenvalues(), 0);
}

// Two directions lead down from the oblate, bending it towards a prolate lying flat; a meridian cannot show them.
TEST(EquilibriumVesicle, OblateNearTheSphereIsASaddle)
{
  for (const std::string chart : {"graph", "ale"})
  {
    VesicleScene scene = vesicle("oblate", 0.95, 3, 2);
    scene.newton.chart = chart;
    Solved oblate(scene);
    ASSERT_TRUE(oblate.result.converged) << chart << ": " << oblate.result.failure;
    EXPECT_GT(oblate.energy(), prolate_95 + 0.01) << chart;
    EXPECT_EQ(oblate.negative_eigenvalues(), 2) << chart;
  }
  Solved axial(vesicle("oblate", 0.95, 3, 2, "axial"));
  ASSERT_TRUE(axial.result.converged);
  EXPECT_EQ(axial.negative_eigenvalues(), 0);
}

TEST(EquilibriumVesicle, ProlateAndDiscocyte)
{
  for (int degree = 3; degree <= 4; ++degree)
  {
    const Solved prolate(vesicle("prolate", 0.65, degree, 2)), disc(vesicle("oblate", 0.65, degree, 2));
    ASSERT_TRUE(prolate.result.converged) << prolate.result.failure;
    ASSERT_TRUE(disc.result.converged) << disc.result.failure;
    const double gate = degree == 3 ? 3e-5 : 1e-6;
    EXPECT_NEAR(relative(prolate.energy(), prolate_65), 0., gate);
    EXPECT_NEAR(relative(disc.energy(), discocyte_65), 0., gate);
    if (degree == 4)
    {
      EXPECT_LT(disc.energy(), prolate.energy());
    }
    expect_targets_met(prolate, 0.65);
    expect_targets_met(disc, 0.65);
  }
}

TEST(EquilibriumVesicle, Axial)
{
  const auto check = [&](const std::string &start, const double v, const double exact, const double in_space_tolerance)
  {
    const Solved whole(vesicle(start, v, 5, 4, "axial")), half(vesicle(start, v, 5, 4, "axial mirror"));
    ASSERT_TRUE(whole.result.converged) << whole.result.failure;
    ASSERT_TRUE(half.result.converged) << half.result.failure;
    EXPECT_NEAR(relative(whole.energy(), exact), 0., 1e-10);
    EXPECT_NEAR(half.energy(), whole.energy(), 1e-9);
    EXPECT_NEAR(half.sigma(), whole.sigma(), 1e-6);
    EXPECT_NEAR(half.pressure(), whole.pressure(), 1e-6);
    expect_targets_met(whole, v);
    expect_targets_met(half, v);

    const Solved in_space(vesicle(start, v, 4, 2));
    ASSERT_TRUE(in_space.result.converged);
    EXPECT_NEAR(relative(in_space.energy(), whole.energy()), 0., in_space_tolerance);
    EXPECT_NEAR(in_space.sigma(), whole.sigma(), 1e3 * in_space_tolerance);
    EXPECT_NEAR(in_space.shape().height, whole.shape().height, 1e3 * in_space_tolerance);
  };
  check("prolate", 0.95, prolate_95, 1e-7);
  check("prolate", 0.65, prolate_65, 1e-6);
  check("oblate", 0.65, discocyte_65, 1e-6);
}

TEST(EquilibriumVesicle, StomatocyteAxial)
{
  VesicleScene scene = vesicle("stomatocyte", 0.62, 4, 4, "axial");
  const Solved solved(scene);
  ASSERT_TRUE(solved.result.converged) << solved.result.failure;
  EXPECT_NEAR(relative(solved.energy(), stomatocyte_62), 0., 1e-6);
  const NodalCurvature curvature = nodal_curvature(solved.model.mesh(), solved.positions());
  const double mean =
      integrated_mean_curvature(solved.model.mesh(), solved.positions(), curvature.curvature_vector) / (4. * pi);
  EXPECT_NEAR(mean, 0.5314, 1e-3);
}

TEST(EquilibriumVesicle, Stomatocyte)
{
  VesicleScene scene = vesicle("stomatocyte", 0.62, 3, 3);
  const Solved solved(scene);
  ASSERT_TRUE(solved.result.converged) << solved.result.failure;
  const NodalCurvature curvature = nodal_curvature(solved.model.mesh(), solved.positions());
  const double mean =
      integrated_mean_curvature(solved.model.mesh(), solved.positions(), curvature.curvature_vector) / (4. * pi);
  EXPECT_NEAR(relative(solved.energy(), stomatocyte_62), 0., 2e-3);
  EXPECT_NEAR(mean, 0.5314, 0.02);
  expect_targets_met(solved, 0.62);
}

TEST(EquilibriumVesicle, NodeNoise)
{
  struct Mesh
  {
    int degree, refinements;
  };
  for (const Mesh mesh : {Mesh{2, 2}, Mesh{3, 1}, Mesh{4, 1}})
    for (int seed = 1; seed <= 3; ++seed)
    {
      VesicleScene scene        = vesicle("prolate", 0.95, mesh.degree, mesh.refinements);
      scene.vesicle.node_noise  = 0.05;
      scene.vesicle.random_seed = seed;
      const Solved solved(scene);
      ASSERT_TRUE(solved.result.converged)
          << "degree " << mesh.degree << ", seed " << seed << ": " << solved.result.failure;
      EXPECT_LE(solved.result.iterations, 15) << "degree " << mesh.degree << ", seed " << seed;
      EXPECT_NEAR(solved.energy(), 1.09556, 1e-3) << "degree " << mesh.degree << ", seed " << seed;
    }
}

TEST(EquilibriumVesicle, UnitsDoNotMatter)
{
  const Solved ours(vesicle("prolate", 0.8, 3, 1));
  VesicleScene scene                                               = vesicle("prolate", 0.8, 3, 1);
  scene.vesicle.area                                               = 4. * pi * 1e-18;
  effect<HelfrichBendingEffect>(scene).parameters.bending_rigidity = 8.2e-20;
  const Solved si(scene);
  ASSERT_TRUE(ours.result.converged);
  ASSERT_TRUE(si.result.converged);
  EXPECT_NEAR(relative(si.energy(), ours.energy()), 0., 1e-9);
  EXPECT_EQ(si.result.iterations, ours.result.iterations);
  // Observers hear of the user's energy.
  EXPECT_NEAR(si.record.iterations.back().energy / 8.2e-20, ours.record.iterations.back().energy, 1e-8);
  EXPECT_NEAR(si.model.scales().of(dimensions::tension) * si.sigma() / (8.2e-20 / 1e-18), ours.sigma(), 1e-6);
}
} // namespace

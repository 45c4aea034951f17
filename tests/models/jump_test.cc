// SPDX-License-Identifier: LGPL-2.1-or-later
// Energies along branches change by the conjugate force; a step that jumps to another branch shows by that.
#include "branch_runs.h"

#include <pellicle/models/jump_detector.h>
#include <pellicle/potentials/constraints/bilayer_curvature.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

/** For each step of a load whether it is taken for a jump; every state is accepted. */
std::vector<bool> jumps_of(const SceneAt &scene_at, const std::string &parameter, double value, const double step,
                           const int steps)
{
  Solved solved(scene_at(value));
  EXPECT_TRUE(solved.result.converged) << solved.result.failure;
  JumpDetector detector(parameter);
  EXPECT_FALSE(detector.has_jumped(solved.model, scene_at(value), value)); // nothing to compare with
  detector.accept(solved.model, scene_at(value), value);
  std::vector<bool> list;
  for (int i = 0; i < steps; ++i)
  {
    value += step;
    solved.model.update(scene_at(value));
    const StepResult result = solved.model.solve(i, solved.record);
    EXPECT_TRUE(result.converged) << value << ": " << result.failure;
    list.push_back(detector.has_jumped(solved.model, scene_at(value), value));
    detector.accept(solved.model, scene_at(value), value);
  }
  return list;
}

SceneAt vesicles(const std::string &start_shape)
{
  return [=](const double v) { return vesicle(start_shape, v, 4, 4, "axial"); };
}

// Between v = .66 and .665 the stomatocytes end (v = .66085), and the state falls onto an oblate.
TEST(Jumps, BeyondAFold)
{
  const std::vector<bool> jumps = jumps_of(vesicles("stomatocyte"), "Vesicle/Reduced volume", 0.64, 0.005, 8);
  for (std::size_t i = 0; i < jumps.size(); ++i)
    EXPECT_EQ(jumps[i], i == 4) << 0.64 + 0.005 * (static_cast<double>(i) + 1.);
}

TEST(Jumps, OrdinaryStepsAreNotSuspected)
{
  const std::vector<bool> none(10, false);
  EXPECT_EQ(jumps_of(vesicles("prolate"), "Vesicle/Reduced volume", 0.95, -0.03, 10), none);
  EXPECT_EQ(jumps_of(vesicles("oblate"), "Vesicle/Reduced volume", 0.95, -0.03, 10), none);
}

// Continuation does not know this parameter, so there is no force to compare with.
TEST(Jumps, UnknownParameter)
{
  const auto scene_at = [](const double kappa)
  {
    VesicleScene scene                                               = vesicle("prolate", 0.9, 3, 2, "axial");
    effect<HelfrichBendingEffect>(scene).parameters.bending_rigidity = kappa;
    return scene;
  };
  EXPECT_EQ(jumps_of(scene_at, "Helfrich bending/Bending rigidity", 1., 1., 2), std::vector<bool>(2, false));
}

/** Relative difference between the slope of the potential energy and central differences of it. */
double slope_defect(const SceneAt &scene_at, const std::string &parameter, const double value, const double step)
{
  Solved solved(scene_at(value));
  EXPECT_TRUE(solved.result.converged) << solved.result.failure;
  const double slope   = solved.model.energy_slope(scene_at(value), parameter).value();
  const auto energy_at = [&](const double p)
  {
    solved.model.update(scene_at(p));
    EXPECT_TRUE(solved.model.solve(1, solved.record).converged);
    return solved.model.potential_energy();
  };
  const double above = energy_at(value + step), below = energy_at(value - step);
  return std::abs((above - below) / (2. * step * slope) - 1.);
}

TEST(Jumps, ConjugateForces)
{
  EXPECT_LT(slope_defect(vesicles("prolate"), "Vesicle/Reduced volume", 0.8, 1e-3), 1e-5);

  VesicleScene (*curved)(double) = [](const double C0)
  {
    VesicleScene scene =
        scene_with({"helfrich bending", "area constraint", "volume constraint", "area difference elasticity"});
    scene.vesicle.reduced_volume                                                       = 0.9;
    scene.mesh.degree                                                                  = 4;
    scene.mesh.symmetry                                                                = "axial";
    effect<HelfrichBendingEffect>(scene).parameters.spontaneous_curvature              = C0;
    effect<AreaDifferenceElasticityEffect>(scene).parameters.integrated_mean_curvature = 14.;
    effect<AreaDifferenceElasticityEffect>(scene).parameters.stiffness                 = 2.;
    return scene;
  };
  EXPECT_LT(slope_defect(curved, "Helfrich bending/Spontaneous curvature", 0.6, 1e-2), 1e-4);
}
} // namespace

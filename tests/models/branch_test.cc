// SPDX-License-Identifier: LGPL-2.1-or-later
// Branches of equilibria of the surface model, through folds and pitchforks.
#include "branch_runs.h"

#include <pellicle/assembly/nodal_chart.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/potentials/constraints/tether.h>
#include <pellicle/solvers/load_stepping.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

/** A balloon of radius 1 and shear modulus mu = 1, whose pressure at the stretch l has a maximum. */
struct Balloon
{
  std::string skin;
  std::function<double(double)> pressure;
  double highest, stretch_there;
};

const std::vector<Balloon> &balloons()
{
  static const std::vector<Balloon> list{
      {"incompressible rubber skin", [](const double l) { return 2. * (1. / l - std::pow(l, -7.)); }, 1.239462902,
       std::pow(7., 1. / 6.)},
      {"neo-hookean skin", [](const double l) { return 2. * (1. / l - std::pow(l, -3.)); }, 0.769800359, std::sqrt(3.)},
  };
  return list;
}

void expect_balloon(const Balloon &balloon, const int degree, const int refinements, const std::string &symmetry,
                    const double tolerance)
{
  const auto scene_at = [&](const double pressure)
  {
    VesicleScene scene                                = scene_with({balloon.skin, "pressure"});
    scene.vesicle.start_shape                         = "ellipsoid";
    scene.vesicle.semi_axes                           = {1., 1., 1.};
    scene.mesh.degree                                 = degree;
    scene.mesh.refinements                            = refinements;
    scene.mesh.symmetry                               = symmetry;
    effect<PressureEffect>(scene).parameters.pressure = pressure;
    return scene;
  };
  const Followed branch(scene_at, 0.5, branch_along("Pressure/Pressure", "increasing", 0.5, 2.));
  EXPECT_EQ(branch.result.end, ContinuationEnd::bound) << branch.result.failure;
  EXPECT_EQ(branch.points.back().parameter, 0.5); // exactly there
  EXPECT_EQ(branch.result.points, static_cast<int>(branch.points.size()));
  const auto stretch = [](const Followed::Point &point) { return std::cbrt(point.shape.volume / (4. * pi / 3.)); };
  for (const Followed::Point &point : branch.points)
    EXPECT_NEAR(point.parameter, balloon.pressure(stretch(point)), tolerance) << stretch(point);
  ASSERT_EQ(branch.folds().size(), 1U);
  EXPECT_NEAR(branch.folds()[0].parameter, balloon.highest, tolerance);
  EXPECT_NEAR(stretch(branch.folds()[0]), balloon.stretch_there, 1e-5 + 10. * tolerance);
  // Beyond the maximum the balloon blows up by itself.
  for (const Followed::Point &point : branch.points)
    if (!point.is_fold)
    {
      EXPECT_EQ(point.negative_eigenvalues.value(), stretch(point) < balloon.stretch_there ? 0 : 1) << stretch(point);
    }
}

TEST(Branches, BalloonsOnAMeridian)
{
  for (const Balloon &balloon : balloons())
    expect_balloon(balloon, 4, 2, "axial", 1e-8);
}

TEST(Branches, BalloonsInSpace)
{
  for (const Balloon &balloon : balloons())
    expect_balloon(balloon, 3, 1, "none", 1e-4);
}

SceneAt vesicles(const std::string &start_shape)
{
  return [=](const double v) { return vesicle(start_shape, v, 5, 4, "axial"); };
}

/** Height of the middle between the poles above the centroid: zero on shapes symmetric under z -> -z, large on cups. */
double asymmetry(const Followed &branch, const Followed::Point &point)
{
  const std::vector<double> areas = nodal_areas(branch.model.mesh(), point.positions);
  double moment = 0., area = 0., poles = 0.;
  for (std::size_t I = 0; I < areas.size(); ++I)
  {
    const double r = point.positions[3 * I], z = point.positions[3 * I + 2];
    moment += areas[I] * z;
    area += areas[I];
    if (r == 0.)
      poles += 0.5 * z;
  }
  return poles - moment / area;
}

// The stable stomatocytes end at v = .66085; the unstable ones beyond that fold lead to the pitchfork on the oblates,
// where v turns again and the cup opens to the other side. Values of the independent axisymmetric solution (shape
// equations).
TEST(Branches, Stomatocytes)
{
  BranchParameters along = branch_along("Vesicle/Reduced volume", "increasing", 0.45, 0.7);
  along.steps.max_points = 44;
  const Followed branch(vesicles("stomatocyte"), 0.645, along);
  EXPECT_EQ(branch.result.end, ContinuationEnd::points) << branch.result.failure;
  ASSERT_EQ(branch.folds().size(), 2U);
  const Followed::Point fold = branch.folds()[0], pitchfork = branch.folds()[1];
  EXPECT_NEAR(fold.parameter, 0.6608503265, 1e-8);
  EXPECT_NEAR(fold.energy / (8. * pi), 1.963052784871, 1e-7);
  EXPECT_NEAR(pitchfork.parameter, 0.5104389224, 1e-7);
  EXPECT_NEAR(pitchfork.energy / (8. * pi), 2.19287475294, 1e-6);
  EXPECT_NEAR(asymmetry(branch, pitchfork), 0., 1e-3);

  bool beyond_fold     = false;
  const double one_way = asymmetry(branch, branch.points.front());
  for (const Followed::Point &point : branch.points)
  {
    beyond_fold = beyond_fold || point.is_fold;
    if (!point.is_fold)
    {
      EXPECT_EQ(point.negative_eigenvalues.value(), beyond_fold ? 1 : 0) << point.parameter;
    }
  }
  EXPECT_LT(asymmetry(branch, branch.points.back()) * one_way, 0.);
}

TEST(Branches, ReportedBifurcation)
{
  const Followed branch(vesicles("oblate"), 0.53, branch_along("Vesicle/Reduced volume", "decreasing", 0.49, 0.56));
  EXPECT_EQ(branch.result.end, ContinuationEnd::bound) << branch.result.failure;
  EXPECT_EQ(branch.result.folds, 0);
  EXPECT_EQ(branch.points.front().negative_eigenvalues.value(), 0);
  EXPECT_EQ(branch.points.back().negative_eigenvalues.value(), 1);
  EXPECT_EQ(branch.points.back().parameter, 0.49);
  for (const Followed::Point &point : branch.points)
    EXPECT_NEAR(asymmetry(branch, point), 0., 1e-6);
  EXPECT_TRUE(branch.messages.mention("A bifurcation: the number of negative eigenvalues has changed to 1"));
}

TEST(Branches, SwitchedAtABifurcation)
{
  BranchParameters along = branch_along("Vesicle/Reduced volume", "decreasing", 0.45, 0.56);
  along.at_bifurcation   = "switch";
  const Followed branch(vesicles("oblate"), 0.53, along);
  ASSERT_EQ(branch.result.end, ContinuationEnd::bound) << branch.result.failure;
  EXPECT_EQ(branch.points.back().parameter, 0.56);
  EXPECT_NEAR(branch.points.back().energy / (8. * pi), 2.082240583984, 1e-7); // the unstable stomatocyte there
  EXPECT_EQ(branch.points.back().negative_eigenvalues.value(), 1);

  // The oblates come first, with v falling; the other branch begins at the bifurcation, and v rises.
  std::size_t n = 1;
  while (branch.points[n].parameter < branch.points[n - 1].parameter)
    ++n;
  EXPECT_NEAR(branch.points[n].parameter, 0.5104389224, 2e-6);
  for (std::size_t i = 0; i <= n; ++i)
    EXPECT_NEAR(asymmetry(branch, branch.points[i]), 0., 1e-6);
  for (std::size_t i = n + 1; i < branch.points.size(); ++i)
    EXPECT_GT(std::abs(asymmetry(branch, branch.points[i])), std::abs(asymmetry(branch, branch.points[i - 1]))) << i;
  EXPECT_EQ(std::count_if(branch.messages.texts.begin(), branch.messages.texts.end(),
                          [](const std::string &text) { return text.find("A bifurcation") == 0; }),
            1);
}

/** A tube pulled by a force on its tip; at sigma = .5 the radius of tubes is 1 and their force f0 = 2 pi. */
VesicleScene tether(const double force)
{
  VesicleScene scene           = scene_with({"helfrich bending", "tether"});
  scene.mesh.symmetry          = "axial";
  scene.mesh.degree            = 4;
  scene.mesh.refinements       = 3;
  TetherParameters &parameters = effect<TetherEffect>(scene).parameters;
  parameters.control           = "force";
  parameters.force             = force;
  parameters.tension           = 0.5;
  parameters.ring_radius       = 20.;
  parameters.tip_radius        = 0.2;
  scene.newton.chart           = "ale";
  scene.newton.max_iterations  = 25;
  return scene;
}

constexpr double f0 = 2. * pi, highest_force = 1.15327360573 * f0; // independent axisymmetric solution

TEST(Branches, TetherUnderForce)
{
  BranchParameters along = branch_along("Tether/Force", "increasing", 0., 10.);
  along.steps.max_points = 24;
  const Followed branch(tether, 4., along);
  EXPECT_EQ(branch.result.end, ContinuationEnd::points) << branch.result.failure;
  ASSERT_EQ(branch.folds().size(), 2U);
  const Followed::Point highest = branch.folds()[0], lowest = branch.folds()[1];
  EXPECT_NEAR(highest.parameter / f0, highest_force / f0, 1e-7);
  EXPECT_NEAR(highest.shape.height, 7.73709968, 1e-3);
  EXPECT_NEAR(lowest.parameter / f0, 0.98935243684, 2e-7);
  EXPECT_NEAR(lowest.shape.height, 11.02904866, 1e-3);
  for (const Followed::Point &point : branch.points)
    if (!point.is_fold)
    {
      EXPECT_EQ(point.negative_eigenvalues.value(),
                point.shape.height > highest.shape.height && point.shape.height < lowest.shape.height ? 1 : 0)
          << point.shape.height;
    }
}

TEST(Branches, LoadSteppingStopsBelowTheFold)
{
  Solved pulled(tether(6.));
  ASSERT_TRUE(pulled.result.converged) << pulled.result.failure;
  LoadParameters load;
  load.steps           = 2;
  load.smallest_step   = 0.01;
  const double reached = walk_load(load,
                                   [&](const double t)
                                   {
                                     pulled.model.update(tether(6. + 2. * t));
                                     return pulled.model.solve(1, pulled.record).converged;
                                   });
  EXPECT_LT(6. + 2. * reached, highest_force);
  EXPECT_GT(6. + 2. * reached, highest_force - 0.05);
}

/** The message of the UserError that following a branch throws. */
std::string refusal(const BranchParameters &along)
{
  try
  {
    const Followed branch([](const double v) { return vesicle("prolate", v, 3, 1, "axial"); }, 0.9, along);
  }
  catch (const UserError &error)
  {
    return error.what();
  }
  return "none";
}

TEST(Branches, Refusals)
{
  EXPECT_EQ(refusal(branch_along("Helfrich bending/Bending rigidity", "increasing", 0.5, 1.)),
            "Continuation/Parameter = Helfrich bending/Bending rigidity is not possible in this scene. Possible are: "
            "Helfrich bending/Spontaneous curvature, Vesicle/Reduced volume.");
  const std::string outside = refusal(branch_along("Vesicle/Reduced volume", "decreasing", 0.5, 0.8));
  EXPECT_NE(outside.find("0.9"), std::string::npos) << outside;
  EXPECT_NE(outside.find("Continuation/Lower = 0.5"), std::string::npos) << outside;
}

TEST(Branches, BoundsAreMetExactly)
{
  const auto scene_at = [](const double v) { return vesicle("prolate", v, 3, 2, "axial"); };
  for (const std::string direction : {"increasing", "decreasing"})
  {
    const Followed branch(scene_at, 0.9, branch_along("Vesicle/Reduced volume", direction, 0.777, 0.95));
    ASSERT_EQ(branch.result.end, ContinuationEnd::bound) << branch.result.failure;
    const Followed::Point &last = branch.points.back();
    EXPECT_EQ(last.parameter, direction == "increasing" ? 0.95 : 0.777);
    EXPECT_NEAR(last.shape.volume / (4. * pi / 3.), last.parameter, 1e-9);
    EXPECT_EQ(branch.folds().size(), 0U);
  }
}
} // namespace

// SPDX-License-Identifier: LGPL-2.1-or-later
// Thresholds of Eshelby's force on the contact line of a drop on a soft cylinder: the line sticks, advances, recedes.
#include "equilibrium_runs.h"

#include "../expect_user_error.h"

#include <pellicle/models/material_line_pinning.h>
#include <pellicle/models/ridge_scene.h>
#include <pellicle/potentials/potential_library.h>
#include <pellicle/potentials/wetting/free_contact_line.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

constexpr double never = std::numeric_limits<double>::infinity();

/** The drop of the references: V = 2 on a cylinder with sliding sides, R = 2, H = 1, nu = .3, tensions .08/.06/.06. */
RidgeScene ridge(const std::string &motion)
{
  RidgeScene scene;
  list_effects(scene, ridge_effects(),
               {"liquid surface", "volume constraint", "solid", "solid skins", "free contact line"}, {});
  scene.mesh.degree       = 2;
  scene.line.motion       = motion;
  scene.substrate.lateral = "sliding";
  scene.newton.tolerance  = 1e-11;
  return scene;
}

RidgeScene ridge(const double advancing, const double receding)
{
  RidgeScene scene = ridge("free");
  auto &thresholds = effect<FreeContactLineEffect>(scene).parameters;
  thresholds       = {advancing, receding};
  return scene;
}

/** A drop whose tensions have been applied, and its load steps. */
class Ridge
{
public:
  explicit Ridge(RidgeScene given)
      : scene(std::move(given))
      , model(at_load(0.25), communicator, timing)
  {
    solve();
    for (const double load : {0.5, 0.75, 1.})
    {
      model.update(at_load(load));
      solve();
    }
  }
  void fill(const double volume)
  {
    scene.droplet.volume = volume;
    model.update(scene);
    solve();
  }
  double operator[](const std::string &name) const { return quantity(model, name); }
  double radius() const { return (*this)["contact_line_material_radius"]; }
  double force() const { return (*this)["line_eshelby_force"]; }
  /** What it would cost without friction. */
  double stored_energy() const { return (*this)["total_energy"] - (*this)["pinning_dissipation"]; }

  RidgeScene scene;
  Communicator communicator;
  Timing timing;
  Record record;
  SurfaceModel model;

private:
  const RidgeScene &at_load(const double load)
  {
    scene.tensions.scale = load;
    scene.check();
    return scene;
  }
  void solve()
  {
    const StepResult result = model.solve(0, record);
    EXPECT_TRUE(result.converged) << result.failure;
  }
};

double area(const double radius)
{
  return pi * radius * radius;
}

/** dPi/dR_c of lines held at three radii of their material line, from an independent axisymmetric code (meshes down to
 * .003, errors of 1e-4), interpolated. Over 2 pi R_c it is -f. */
double reference_force(const double R)
{
  const double slope = -.038074673 * (R - 1.02) * (R - 1.06) / (.05 * .09) -
                       .001232094 * (R - .97) * (R - 1.06) / (.05 * .04) +
                       .035374283 * (R - .97) * (R - 1.02) / (.09 * .04);
  return -slope / (2. * pi * R);
}

TEST(LineHysteresis, WithinTheThresholdsTheLineIsPinned)
{
  const Ridge stuck(ridge(1., never)), pinned(ridge("pinned"));
  EXPECT_EQ(stuck.radius(), 1.);
  EXPECT_EQ(stuck["pinning_dissipation"], 0.);
  const NodalVectors a = stuck.model.positions(), b = pinned.model.positions();
  double difference = 0.;
  for (std::size_t i = 0; i < a.size(); ++i)
    difference = std::max(difference, std::abs(a[i] - b[i]));
  EXPECT_LT(difference, 1e-10);
  EXPECT_NEAR(stuck["total_energy"], pinned["total_energy"], 1e-12);
  EXPECT_NEAR(stuck.force(), reference_force(1.), 3e-5);
}

TEST(LineHysteresis, LinesThatMoveDoSoAtTheThreshold)
{
  const Ridge free_line(ridge(0., 0.)), little(ridge(6e-4, 6e-4)), more(ridge(1.2e-3, never)),
      backwards(ridge(never, 6e-4));
  EXPECT_TRUE(free_line.model.inequalities().empty());
  EXPECT_NEAR(free_line.force(), 0., 1e-10);
  EXPECT_NEAR(free_line.radius(), 1.018518, 2e-3); // independent code, converged
  EXPECT_NEAR(little.force(), 6e-4, 1e-10);
  EXPECT_NEAR(more.force(), 1.2e-3, 1e-10);
  EXPECT_EQ(backwards.radius(), 1.);
  EXPECT_GT(free_line.radius(), little.radius());
  EXPECT_GT(little.radius(), more.radius());
  EXPECT_GT(more.radius(), 1.003);

  // The force is what the energy yields on the swept area: a trapezoid of a curve that is nearly straight.
  const double yields = more.stored_energy() - little.stored_energy();
  const double swept  = area(little.radius()) - area(more.radius());
  EXPECT_NEAR(yields, 0.5 * (6e-4 + 1.2e-3) * swept, 1e-3 * yields);
  EXPECT_NEAR(little["pinning_dissipation"], 6e-4 * (area(little.radius()) - area(1.)), 1e-12);
}

TEST(LineHysteresis, DropsThatGrowAndShrink)
{
  constexpr double advancing = 1.2e-3, receding = 9e-4;
  Ridge drop(ridge(advancing, receding));
  const double first = drop.radius();
  drop.fill(2.15);
  const double largest = drop.radius();
  EXPECT_GT(largest, first + 0.015);
  EXPECT_NEAR(drop.force(), advancing, 1e-10);
  const double outwards = advancing * (area(largest) - area(1.));
  EXPECT_NEAR(drop["pinning_dissipation"], outwards, 1e-12);

  drop.fill(2.1);
  EXPECT_EQ(drop.radius(), largest);
  EXPECT_LT(drop.force(), advancing - 5e-4);
  EXPECT_GT(drop.force(), -receding);
  EXPECT_NEAR(drop["pinning_dissipation"], outwards, 1e-12);

  drop.fill(2.);
  const double back = drop.radius();
  EXPECT_LT(back, largest - 0.005);
  EXPECT_GT(back, first + 0.01); // the same volume as the first
  EXPECT_NEAR(drop.force(), -receding, 1e-10);
  EXPECT_NEAR(drop["pinning_dissipation"], outwards + receding * (area(largest) - area(back)), 1e-12);

  drop.fill(2.03);
  EXPECT_EQ(drop.radius(), back);
  EXPECT_GT(drop.force(), -receding + 2e-4);
}

TEST(LineHysteresis, Refusals)
{
  RidgeScene scene       = ridge(1e-3, 1e-3);
  scene.branch.parameter = "Tensions/Solid gas";
  expect_user_error([&] { scene.check(); }, {"Continuation/Parameter = Tensions/Solid gas", "dissipated", "Load"});
  scene.branch.parameter.clear();
  scene.load.parameter = "Free contact line/Advancing threshold";
  scene.load.to        = "2e-3";
  expect_user_error([&] { scene.check(); }, {"Free contact line/Advancing threshold"});
}
} // namespace

// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact angle hysteresis: lines that stick, advance, recede and slide.
#include "../expect_user_error.h"
#include "../mpi_environment.h"
#include "../record.h"

#include <pellicle/models/droplet_scene.h>
#include <pellicle/models/line_forces.h>
#include <pellicle/models/line_pinning.h>
#include <pellicle/models/surface_model.h>
#include <pellicle/potentials/potential_library.h>
#include <pellicle/potentials/wetting/line_pinning.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

constexpr double degree         = pi / 180.;
constexpr double unit_weight    = 0.62996052494743658; // Bond number of rho g = gamma/L^2 at volume 2 pi/3
constexpr double angle_of_nodes = 1e-3;                // degrees, at nodes that slip on coarse meshes in space

struct Drop
{
  DropletScene scene = make_droplet_scene(
      droplet_effects(), {"liquid surface", "volume constraint", "wetting", "gravity", "line pinning"}, {});

  Drop(const std::string &symmetry, const double advancing, const double receding)
  {
    scene.mesh.symmetry         = symmetry;
    scene.mesh.refinements      = symmetry == "axial" ? 2 : 1;
    scene.newton.max_iterations = 20;
    pinning().advancing_angle   = advancing;
    pinning().receding_angle    = receding;
  }
  LinePinningParameters &pinning()
  {
    for (const auto &effect : scene.effects)
      if (auto *found = dynamic_cast<LinePinningEffect *>(effect.get()))
        return found->parameters;
    throw std::logic_error("the effect is not in the scene");
  }
};

/** A drop's model in load steps. */
class LoadSteps
{
public:
  explicit LoadSteps(Drop &start)
      : drop(start)
      , model(start.scene, communicator, timing)
  {
    start.scene.check();
    result = model.solve(0, record);
  }

  StepResult step(const std::function<void(DropletScene &)> &change)
  {
    change(drop.scene);
    drop.scene.check();
    model.update(drop.scene);
    return result = model.solve(++n, record);
  }
  void tilt(const double inclination)
  {
    step([&](DropletScene &scene) { scene.droplet.inclination = inclination; });
    ASSERT_TRUE(result.converged) << result.failure;
  }
  void fill(const double volume)
  {
    step([&](DropletScene &scene) { scene.droplet.volume = volume; });
    ASSERT_TRUE(result.converged) << result.failure;
  }
  double operator[](const std::string &name) const
  {
    for (const auto &[reported, value] : model.quantities())
      if (reported == name)
        return value;
    throw std::logic_error("the model does not report " + name);
  }
  const LinePinning &pinning() const { return dynamic_cast<const LinePinning &>(*model.inequalities().front()); }
  const EdgeLoop &line() const { return model.mesh().edges.front(); }

  Drop &drop;
  Communicator communicator;
  Timing timing;
  Record record;
  SurfaceModel model;
  StepResult result;
  int n = 0;
};

// The line keeps its radius between the two angles and moves at exactly these; what it dissipates is friction times
// swept area, gamma (cos 90 - cos 110) outwards and gamma (cos 60 - cos 90) inwards.
TEST(LinePinning, DropsThatGrowAndShrink)
{
  Drop drop("axial", 110., 60.);
  drop.scene.droplet.bond_number = unit_weight;
  LoadSteps run(drop);
  const double settled = run["contact_radius"];
  EXPECT_NEAR(settled, 1.069538931973, 1e-7); // shooting, Young and Laplace
  EXPECT_NEAR(run["contact_angle_degrees"], 90., 1e-8);

  run.fill(2.6);
  EXPECT_NEAR(run["contact_radius"], settled, 1e-14);
  EXPECT_GT(run["contact_angle_degrees"], 99.);
  EXPECT_EQ(run["pinning_dissipation"], 0.);
  run.fill(3.4);
  run.fill(4.);
  const double largest = run["contact_radius"];
  EXPECT_GT(largest, 1.13);
  EXPECT_NEAR(run["contact_angle_degrees"], 110., 1e-7);
  const double outwards = -std::cos(110. * degree) * pi * (largest * largest - settled * settled);
  EXPECT_NEAR(run["pinning_dissipation"], outwards, 1e-9);

  for (const double volume : {3.6, 2.6, 1.9})
  {
    run.fill(volume);
    EXPECT_NEAR(run["contact_radius"], largest, 1e-14) << volume;
  }
  run.fill(0.6);
  const double last = run["contact_radius"];
  EXPECT_LT(last, 0.9);
  EXPECT_NEAR(run["contact_angle_degrees"], 60., 1e-7);
  EXPECT_NEAR(run["pinning_dissipation"], outwards + 0.5 * pi * (largest * largest - last * last), 1e-9);
}

// Where the line moves at theta_A, the shape is that of a drop with theta = theta_A and no hysteresis.
TEST(LinePinning, AdvancingDropsAreThoseOfTheAdvancingAngle)
{
  Drop drop("axial", 120., 60.);
  drop.scene.substrate.shape  = "sphere";
  drop.scene.substrate.side   = "inside";
  drop.scene.substrate.radius = 2.;
  drop.scene.droplet.volume   = pi / 6.;
  LoadSteps run(drop);
  const double settled = run["solid_liquid_area"];
  run.fill(2. * pi / 3.);
  EXPECT_NEAR(run["contact_radius"], 0.95526847862504, 2e-6); // closed form, two spherical caps
  EXPECT_NEAR(run["contact_angle_degrees"], 120., 1e-7);
  EXPECT_NEAR(run["pinning_dissipation"], 0.5 * (run["solid_liquid_area"] - settled), 1e-9);
}

// A hemisphere whose rim is held, with a weight of 0.1 per volume along the plane. First order in the weight:
// theta = 90 + (2/3) 0.1 rad downhill; energy by an independent 3-D computation (Surface Evolver).
TEST(LinePinning, PinnedHemisphere)
{
  Drop drop("none", 180., 0.);
  drop.scene.droplet.bond_number = 0.1 * unit_weight;
  drop.scene.droplet.inclination = 90.;
  LoadSteps run(drop);
  ASSERT_TRUE(run.result.converged) << run.result.failure;
  EXPECT_LE(run.result.iterations, 8);
  EXPECT_NEAR(run["total_energy"], 2. * pi - 0.00193129097, 5e-7);
  EXPECT_NEAR(run["pressure"], 1.9977754, 2e-6);
  const double smallest = run["contact_angle_degrees_min"], largest = run["contact_angle_degrees_max"];
  EXPECT_NEAR(0.5 * (largest - smallest), 0.1 * 2. / 3. / degree, 5e-3);
  EXPECT_NEAR(0.5 * (largest + smallest), 90., 0.05);
  const NodalVectors &before = run.model.mesh().positions, now = run.model.positions();
  for (const std::size_t node : run.line().cell_nodes)
    for (unsigned int c = 0; c < 3; ++c)
      EXPECT_EQ(before[3 * node + c], now[3 * node + c]);
  for (const auto &[name, count] : run.model.unknown_counts())
    EXPECT_NE(name, "rigid motions");
}

// Level, the line settles: a gauge holds the drop. Then it sticks, the front advances, the rear recedes, and in the end
// the drop slides. Weight and pull of the line are in balance all the way, and the width of the wetted base bounds
// what it can hold (Furmidge 1962).
TEST(LinePinning, TiltedPlane)
{
  Drop drop("none", 110., 60.);
  drop.scene.droplet.bond_number = unit_weight;
  LoadSteps run(drop);
  ASSERT_TRUE(run.result.converged) << run.result.failure;
  EXPECT_NEAR(run["contact_radius"], 1.069538931973, 1e-6);
  const NodalVectors settled = run.model.positions();
  const auto n_moved         = [&]
  {
    const NodalVectors now = run.model.positions();
    std::size_t n          = 0;
    for (const auto &[node, force] : line_forces(run.model.equilibrium(), run.line(), PlaneChart{}))
      n += now[3 * node] != settled[3 * node] || now[3 * node + 1] != settled[3 * node + 1];
    return n;
  };
  const auto check_balance = [&](const double inclination)
  {
    double pull = 0., left = 0., right = 0.;
    for (const auto &[node, force] : line_forces(run.model.equilibrium(), run.line(), PlaneChart{}))
    {
      pull += force.pull * force.across[0];
      const double y = run.model.positions()[3 * node + 1] * run.model.scales().length;
      left           = std::min(left, y);
      right          = std::max(right, y);
    }
    const double weight = run["liquid_weight"] * std::sin(inclination * degree);
    EXPECT_NEAR(-pull * run.model.scales().length, weight, 2e-3 * weight + 1e-9) << inclination;
    EXPECT_LT(weight, (right - left) * (std::cos(60. * degree) - std::cos(110. * degree)));
    EXPECT_LT(run["contact_angle_degrees_max"], 110. + angle_of_nodes);
    EXPECT_GT(run["contact_angle_degrees_min"], 60. - angle_of_nodes);
  };

  for (const double inclination : {12., 24.})
  {
    run.tilt(inclination);
    EXPECT_EQ(n_moved(), 0u);
    check_balance(inclination);
  }
  run.tilt(42.);
  LinePinning::Counts counts = run.pinning().counts();
  EXPECT_GT(counts.advancing, 5u);
  EXPECT_EQ(counts.receding, 0u);
  EXPECT_EQ(n_moved(), counts.advancing);
  EXPECT_NEAR(run["contact_angle_degrees_max"], 110., angle_of_nodes);
  check_balance(42.);
  run.tilt(50.);
  counts = run.pinning().counts();
  EXPECT_GT(counts.receding, 5u);
  EXPECT_GT(counts.stuck, 5u);
  EXPECT_NEAR(run["contact_angle_degrees_min"], 60., angle_of_nodes);
  check_balance(50.);

  const NodalVectors tilted = run.model.positions();
  const double dissipated   = run["pinning_dissipation"];
  run.tilt(44.); // back: the line sticks where it is
  EXPECT_EQ(run.pinning().counts().stuck, counts.stuck + counts.advancing + counts.receding);
  for (const std::size_t node : run.line().cell_nodes)
    EXPECT_EQ(run.model.positions()[3 * node], tilted[3 * node]);
  EXPECT_NEAR(run["pinning_dissipation"], dissipated, 1e-12);

  const StepResult slid = run.step([](DropletScene &scene) { scene.droplet.inclination = 80.; });
  EXPECT_FALSE(slid.converged);
  EXPECT_NE(slid.failure.find("the contact line has depinned and the drop slides"), std::string::npos) << slid.failure;
}

TEST(LinePinning, Refusals)
{
  const auto refuses = [](const std::string &text, const std::function<void(Drop &)> &change)
  {
    Drop drop("none", 110., 60.);
    change(drop);
    expect_user_error([&] { drop.scene.check(); }, {text});
  };
  refuses("Contact angle = 120 must lie between", [](Drop &drop) { drop.scene.droplet.contact_angle = 120.; });
  refuses("Contact angle = 50 must lie between", [](Drop &drop) { drop.scene.droplet.contact_angle = 50.; });
  refuses("must be below Line pinning/Advancing angle = 60", [](Drop &drop) { drop.pinning().advancing_angle = 60.; });
  refuses("Droplet/Base = membrane with 'line pinning'",
          [](Drop &drop)
          {
            drop.scene.droplet.base = "membrane";
            drop.scene.effects.push_back(droplet_effects().create("contact"));
          });
  refuses("Contact angle field", [](Drop &drop) { drop.scene.droplet.angle_field = "90 + x"; });
  refuses("Use section Load", [](Drop &drop) { drop.scene.branch.parameter = "Droplet/Volume"; });
  refuses("add 'wetting'", [](Drop &drop) { drop.scene.effects.erase(drop.scene.effects.begin() + 2); });
  refuses("nothing holds the drop on the inclined plane",
          [](Drop &drop)
          {
            drop.scene.effects.pop_back();
            drop.scene.droplet.bond_number = 0.5;
            drop.scene.droplet.inclination = 10.;
          });
}
} // namespace

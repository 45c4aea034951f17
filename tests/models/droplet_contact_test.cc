// SPDX-License-Identifier: LGPL-2.1-or-later
// Drops and balloons whose whole surface is there, in contact with plates; drops between plates by their free surface
// alone. References: theory's table for 180 degrees; Delaunay surfaces between plates and axisymmetric membranes by
// shooting, checked by dE/dh = -F.
#include "droplet_runs.h"

#include <pellicle/assembly/edge_frames.h>
#include <pellicle/kinematics/box.h>
#include <pellicle/models/nodal_contact.h>
#include <pellicle/potentials/elastic_skin.h>
#include <pellicle/potentials/energies/neo_hookean_skin.h>

#include <gtest/gtest.h>

#include <memory>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

DropletScene whole_drop(const double angle, const DropMesh &mesh, const std::vector<std::string> &effects)
{
  DropletScene scene          = make_droplet_scene(droplet_effects(), effects, {});
  scene.droplet.volume        = reference_volume;
  scene.droplet.contact_angle = angle;
  scene.droplet.base          = "membrane";
  scene.mesh.symmetry         = mesh.symmetry;
  scene.mesh.degree           = mesh.degree;
  scene.mesh.refinements      = mesh.refinements;
  return scene;
}

void expect_near_relative(const Solved &solved, const std::string &quantity, const double reference, const double bound)
{
  EXPECT_NEAR(solved.quantity(quantity), reference, bound * std::abs(reference)) << quantity;
}

TEST(DropletContact, BaseMembraneAgreesWithTheCapAlone)
{
  struct Case
  {
    double angle, bond, radius;
  };
  for (const Case c :
       {Case{60., 0., 1.276185946466}, {120., 0., 0.727415757314}, {90., unit_bond_number, 1.069538931973}})
    for (const char *symmetry : {"axial", "none"})
    {
      SCOPED_TRACE(std::to_string(c.angle) + " " + symmetry);
      DropletScene scene        = whole_drop(c.angle, {symmetry, 3, symmetry[0] == 'a' ? 2 : 1},
                                             {"liquid surface", "volume constraint", "wetting", "gravity", "contact"});
      scene.droplet.bond_number = c.bond;
      DropletScene alone        = drop(c.angle, {symmetry, 3, scene.mesh.refinements}, {"gravity"});
      alone.droplet.bond_number = c.bond;
      scene.check();
      const Solved whole(scene), cap(alone);
      ASSERT_TRUE(whole.result.converged && cap.result.converged);
      const double bound = symmetry[0] == 'a' ? 1e-6 : 1e-5;
      expect_near_relative(whole, "contact_radius", c.radius, bound);
      for (const char *quantity : {"contact_radius", "pressure", "liquid_gas_area", "base_pressure_force"})
        expect_near_relative(whole, quantity, cap.quantity(quantity), bound);
      EXPECT_NEAR(whole.quantity("contact_angle_degrees"), c.angle, 1e-4);
    }
}

TEST(DropletContact, DropThatDoesNotWet)
{
  struct Case
  {
    DropMesh mesh;
    double bound;
  };
  for (const Case c : {Case{{"axial", 3, 2}, 1e-4}, Case{{"none", 3, 2}, 1e-3}})
  {
    SCOPED_TRACE(c.mesh.symmetry);
    DropletScene scene        = whole_drop(180., c.mesh, {"liquid surface", "volume constraint", "gravity", "contact"});
    scene.droplet.bond_number = unit_bond_number; // rho g = 1
    scene.check();
    const Solved solved(scene);
    ASSERT_TRUE(solved.result.converged);
    const double weight = solved.quantity("liquid_weight");
    EXPECT_NEAR(std::sqrt(weight / (pi * solved.quantity("pressure"))), 0.448665072, c.bound * 0.448665072);
    expect_near_relative(solved, "contact_radius", 0.448665072, c.bound);
    expect_near_relative(solved, "apex_height", 1.243774869, c.bound);
    expect_near_relative(solved, "base_pressure_force", weight, c.bound);

    // Complementarity at the nodes.
    const auto &contact          = dynamic_cast<const NodalContact &>(*solved.model.inequalities().front());
    const NodalVectors positions = solved.model.positions(), forces = solved.model.equilibrium().nodal_forces().total;
    EXPECT_GT(contact.n_active(), 1u);
    for (std::size_t I = 0; I < solved.model.mesh().n_nodes; ++I)
    {
      EXPECT_GT(positions[3 * I + 2], -1e-9);
      if (contact.touches(I, 0))
      {
        EXPECT_NEAR(positions[3 * I + 2], 0., 1e-14);
        EXPECT_GT(forces[3 * I + 2], -1e-8);
      }
    }
  }
}

TEST(DropletContact, BetweenPlates)
{
  struct Case
  {
    double angle, h, radius, pressure, force;
  };
  for (const Case c : {Case{60., 0.8, 0.987042787653, -0.201334947032, -5.987120130040},
                       {120., 0.8, 0.840064942953, 2.298539703402, 0.524850936337},
                       {150., 1., 0.614024121598, 2.783665063631, 1.368128823802}})
    for (const char *symmetry : {"axial", "none"})
    {
      SCOPED_TRACE(std::to_string(c.angle) + " " + symmetry);
      DropletScene scene             = drop(c.angle, {symmetry, 3, 2});
      scene.substrate.plate_distance = c.h;
      scene.check();
      const Solved solved(scene);
      ASSERT_TRUE(solved.result.converged);
      EXPECT_LE(solved.record.iterations.size(), 8u);
      const double bound = c.angle > 149. ? 5e-5 : symmetry[0] == 'a' ? 1e-7 : 1e-5;
      expect_near_relative(solved, "contact_radius", c.radius, bound);
      expect_near_relative(solved, "pressure", c.pressure, bound);
      expect_near_relative(solved, "plate_force", c.force, bound);
    }
}

TEST(DropletContact, BetweenPlatesThatAreNotWetted)
{
  DropletScene scene = whole_drop(180., {"axial", 3, 3}, {"liquid surface", "volume constraint", "contact"});
  scene.substrate.plate_distance = 0.8;
  scene.check();
  const Solved solved(scene);
  ASSERT_TRUE(solved.result.converged);
  expect_near_relative(solved, "contact_radius", 0.624681275369, 1e-3);
  expect_near_relative(solved, "plate_force", 4.124714854278, 2e-3);
  expect_near_relative(solved, "total_energy", 8.920161927164, 1e-5);
  expect_near_relative(solved, "plate_force", solved.quantity("base_pressure_force"), 1e-6);
}

// A neo-Hookean balloon, blown up to 1.5 times the volume at which it is free of stress, then squeezed.
TEST(DropletContact, BalloonBetweenPlates)
{
  DropletScene scene   = whole_drop(180., {"axial", 3, 4}, {"neo-hookean skin", "volume constraint", "contact"});
  scene.droplet.volume = 1.5 * 4. * pi / 3.;
  scene.droplet.reference_volume = 4. * pi / 3.;
  scene.substrate.plate_distance = 2.2;
  scene.check();
  Solved solved(scene);
  ASSERT_TRUE(solved.result.converged) << solved.result.failure;
  struct Case
  {
    double h, radius, pressure, force, energy;
  };
  for (const Case c : {Case{2., 0.367632660158, 0.441022325412, 0.187257241330, 0.526077196269},
                       {1.6, 0.670896841160, 0.538016812559, 0.760776718984, 0.700920122471}})
  {
    SCOPED_TRACE(c.h);
    const double from = scene.substrate.plate_distance;
    for (int step = 1; step <= 4; ++step)
    {
      scene.substrate.plate_distance = from + 0.25 * step * (c.h - from);
      solved.model.update(scene);
      Record record;
      ASSERT_TRUE(solved.model.solve(step, record).converged);
    }
    expect_near_relative(solved, "contact_radius", c.radius, 3e-3);
    expect_near_relative(solved, "pressure", c.pressure, 1e-3);
    expect_near_relative(solved, "plate_force", c.force, 5e-3);
    expect_near_relative(solved, "total_energy", c.energy, 1e-4);
  }
}

/** A drop on a box instead of the plane. Lengths of the box in units of R_eq. */
class DropOnPillar : public DropletScene
{
public:
  explicit DropOnPillar(const double half_width)
      : half_width(half_width)
  {
  }

protected:
  void set_targets(const Scales &scales, SceneTargets &targets) const override
  {
    DropletScene::set_targets(scales, targets);
    targets.droplet->bodies = {
        std::make_shared<Box>(Vector3<double>(0., 0., -0.5), Vector3<double>(half_width, half_width, 0.5))};
  }

private:
  double half_width;
};

// The contact area on a plane has radius .565 R_eq. A pillar that is wider changes nothing; on a narrower one the drop
// hangs over the edges and sinks; a node exactly on an edge has no normal, and the message says so.
TEST(DropletContact, ObstacleWithEdges)
{
  const auto on_pillar = [](const double half_width)
  {
    auto scene = std::make_unique<DropOnPillar>(half_width);
    list_effects(*scene, droplet_effects(), {"liquid surface", "volume constraint", "gravity", "contact"}, {});
    scene->droplet.volume        = reference_volume;
    scene->droplet.contact_angle = 180.;
    scene->droplet.base          = "membrane";
    scene->droplet.bond_number   = unit_bond_number;
    return std::make_unique<Solved>(*scene);
  };
  double height = 1.243774869;
  for (const double half_width : {0.7, 0.4})
  {
    SCOPED_TRACE(half_width);
    const auto solved = on_pillar(half_width);
    ASSERT_TRUE(solved->result.converged) << solved->result.failure;
    const double weight = solved->quantity("liquid_weight");
    EXPECT_NEAR(solved->quantity("base_pressure_force"), weight, 1e-2 * weight);
    if (half_width > 0.565)
      EXPECT_NEAR(solved->quantity("apex_height"), height, 1e-3 * height);
    else
      EXPECT_LT(solved->quantity("apex_height"), height - 0.01);
    height = solved->quantity("apex_height");
  }
  const auto stuck = on_pillar(0.5);
  EXPECT_FALSE(stuck->result.converged);
  EXPECT_NE(stuck->result.failure.find("on the box"), std::string::npos) << stuck->result.failure;
}
} // namespace

// SPDX-License-Identifier: LGPL-2.1-or-later
// Drops on balls, in cavities, on height fields, and where the contact angle varies. References without weight are
// spheres that cross; those with weight come from an independent integration along the meridian.
#include "droplet_runs.h"

#include <pellicle/base/expression_of_place.h>
#include <pellicle/models/free_motions.h>

#include "expect_user_error.h"

#include <gtest/gtest.h>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

struct OnSphere
{
  const char *side;
  double radius, angle;
  bool heavy;
  double contact_radius, pressure, energy;
};
const std::vector<OnSphere> on_spheres{
    {"outside", 1., 60., false, 0.93509148448969, 2.1793023103534, 6.2173422348188},
    {"outside", 1., 90., true, 0.831095178874, 2.737954787682, 7.874419624594},
    {"outside", 2., 90., false, 0.82593620252088, 2.2637953493073, 6.8857914910843},
    {"outside", 5., 120., true, 0.791664416025, 3.006393801708, 8.545475868615},
    {"inside", 1., 60., false, 1.5403243418036, -1.3284300948221, -0.27630223682958}, // a concave meniscus
    {"inside", 1., 90., true, 1.414213562373, 1., 4.450589592586},                    // a flat one
    {"inside", 2., 120., true, 1.018174751239, 2.845349559829, 8.138809121317},
    {"inside", 5., 150., false, 0.46230393408357, 2.5025485661953, 7.8697566921217}};

DropletScene scene_of(const OnSphere &c, const DropMesh &mesh)
{
  DropletScene scene     = c.heavy ? heavy_drop(c.angle, mesh) : drop(c.angle, mesh);
  scene.substrate.shape  = "sphere";
  scene.substrate.side   = c.side;
  scene.substrate.radius = c.radius;
  return scene;
}

TEST(DropletSubstrates, Spheres)
{
  for (const DropMesh mesh : {DropMesh{"axial", 3, 2}, DropMesh{"none", 3, 1}})
    for (const OnSphere &c : on_spheres)
    {
      SCOPED_TRACE(::testing::Message() << c.side << " " << c.radius << ", " << c.angle << " " << mesh.symmetry);
      const Solved solved(scene_of(c, mesh));
      EXPECT_TRUE(solved.result.converged);
      EXPECT_LE(solved.record.iterations.size(), 8u);
      const double bound = mesh.refinements == 2 ? 1e-6 : 3e-5;
      EXPECT_LT(relative_error(solved.quantity("contact_radius"), c.contact_radius), bound);
      EXPECT_LT(relative_error(solved.quantity("pressure"), c.pressure), 2. * bound);
      EXPECT_LT(relative_error(solved.quantity("total_energy"), c.energy), bound);
    }
}

struct OnHeightField
{
  const char *height;
  double angle;
  bool heavy;
  double contact_radius, pressure, energy;
  int unstable_modes; // sideways
};
const char *const ripples  = "0.1*cos(3*sqrt(x^2+y^2))-0.1";
const char *const bowl     = "0.15*(x^2+y^2)";
const char *const mountain = "-0.15*(x^2+y^2)";
const std::vector<OnHeightField> on_fields{{ripples, 60., true, 1.488443695896, 1.092941163144, 4.302762902832, 0},
                                           {ripples, 120., false, 0.568230592815, 2.457055239490, 7.695449881879, 2},
                                           {bowl, 60., false, 1.361103392800, 0.925670334943, 3.361550286047, 0},
                                           {bowl, 90., true, 1.153266538917, 2.277131707826, 6.575553543831, 0},
                                           {mountain, 90., false, 0.895974474112, 2.175785048518, 6.675889660685, 2},
                                           {mountain, 120., true, 0.769385949374, 3.013164148495, 8.575368785219, 2}};

DropletScene over(const char *height, DropletScene scene)
{
  scene.substrate.shape  = "height field";
  scene.substrate.height = height;
  return scene;
}

TEST(DropletSubstrates, HeightFields)
{
  for (const DropMesh mesh : {DropMesh{"axial", 3, 2}, DropMesh{"none", 3, 1}})
    for (const OnHeightField &c : on_fields)
    {
      SCOPED_TRACE(::testing::Message() << c.height << ", " << c.angle << " " << mesh.symmetry);
      const Solved solved(over(c.height, c.heavy ? heavy_drop(c.angle, mesh) : drop(c.angle, mesh)));
      EXPECT_TRUE(solved.result.converged);
      EXPECT_LE(solved.record.iterations.size(), 8u);
      const double bound = mesh.refinements == 2 ? 1e-6 : 3e-5;
      EXPECT_LT(relative_error(solved.quantity("contact_radius"), c.contact_radius), bound);
      EXPECT_LT(relative_error(solved.quantity("pressure"), c.pressure), bound);
      EXPECT_LT(relative_error(solved.quantity("total_energy"), c.energy), bound);
      EXPECT_EQ(solved.negative_eigenvalues(), mesh.refinements == 2 ? 0 : c.unstable_modes);
    }
}

TEST(DropletSubstrates, PlaneAsAHeightField)
{
  // Tilted, the same cap: the motions over the plane are found and held.
  for (const char *height : {"0", "0.2*x + 0.1*y"})
  {
    const Solved solved(over(height, drop(90., {"none", 3, 1})));
    EXPECT_TRUE(solved.result.converged);
    EXPECT_LE(solved.record.iterations.size(), 8u);
    EXPECT_LT(relative_error(solved.quantity("contact_radius"), 1.), 1e-5) << height;
    EXPECT_LT(relative_error(solved.quantity("total_energy"), 2. * pi), 1e-6) << height;
  }
}

TEST(DropletSubstrates, RoughWithoutSymmetry)
{
  // Degrees 4 and 5 on finer meshes agree in these digits.
  const Solved solved(over("-0.05*(cos(4*x) + cos(3*y))", drop(75., {"none", 3, 1})));
  EXPECT_TRUE(solved.result.converged);
  EXPECT_LT(relative_error(solved.quantity("contact_radius"), 1.1095136016), 1e-6);
  EXPECT_LT(relative_error(solved.quantity("pressure"), 1.7539324750), 1e-6);
  EXPECT_LT(relative_error(solved.quantity("total_energy"), 5.1003329173), 1e-7);
  EXPECT_NEAR(solved.quantity("contact_angle_degrees"), 75., 1e-3);
  EXPECT_EQ(solved.negative_eigenvalues(), 0);
}

TEST(DropletSubstrates, FreeMotionsAreFound)
{
  const Vector3<double> down(0., 0., -1.), none;
  const auto motions = [](const char *height, const Vector3<double> &force)
  { return free_motions_over(ExpressionOfPlace(height), 1., force); };
  EXPECT_EQ(motions("0", down).size(), 3u);
  EXPECT_EQ(motions("0.2*x", none).size(), 3u);
  ASSERT_EQ(motions("0.2*x", down).size(), 1u); // along y only
  EXPECT_NEAR(motions("0.2*x", down)[0].translation[0], 0., 1e-9);
  ASSERT_EQ(motions("cos(x + y)", down).size(), 1u);
  const auto along = motions("cos(x + y)", down)[0].translation;
  EXPECT_NEAR(along[0] + along[1], 0., 1e-9);
  ASSERT_EQ(motions("cos(x) + 0.3*y", none).size(), 1u);
  const auto up = motions("cos(x) + 0.3*y", none)[0].translation;
  EXPECT_NEAR(up[2], 0.3 * up[1], 1e-9);
  EXPECT_TRUE(motions("cos(x) + 0.3*y", down).empty());
  ASSERT_EQ(motions(ripples, down).size(), 1u);
  EXPECT_EQ(motions(ripples, down)[0].rotation[2], 1.);
  EXPECT_TRUE(motions(ripples, {0.1, 0., -1.}).empty());
  EXPECT_TRUE(motions("sin(x)*cos(y)", none).empty());
}

TEST(DropletSubstrates, ContactAngleOfPlace)
{
  // Axisymmetric: the cap whose angle is that of the field at its own line.
  const double angle = angle_of_cap([](const double a) { return 60. + 20. * a * a; }, 60., 120.);
  for (const DropMesh mesh : {DropMesh{"axial", 3, 2}, DropMesh{"none", 3, 2}})
  {
    DropletScene scene        = drop(80., mesh);
    scene.droplet.angle_field = "60 + 20*(x^2 + y^2)";
    const Solved solved(scene);
    EXPECT_TRUE(solved.result.converged);
    EXPECT_LT(relative_error(solved.quantity("contact_radius"), radius_of_cap(angle)), 1e-6);
    EXPECT_NEAR(solved.quantity("contact_angle_degrees"), angle, 1e-4);
  }

  DropletScene scene        = drop(80., {"none", 3, 2});
  scene.droplet.angle_field = "70 + 15*x^2 + 8*y^2";
  const Solved solved(scene);
  EXPECT_TRUE(solved.result.converged);
  const ExpressionOfPlace field(scene.droplet.angle_field, solved.model.scales().length);
  double smallest = 180., largest = 0.;
  for (const std::size_t node : solved.model.mesh().edges.front().cell_nodes)
  {
    const double here = field.at(solved.positions()[3 * node], solved.positions()[3 * node + 1]).value;
    smallest          = std::min(smallest, here);
    largest           = std::max(largest, here);
  }
  EXPECT_GT(largest - smallest, 2.);
  EXPECT_NEAR(solved.quantity("contact_angle_degrees_min"), smallest, 0.05);
  EXPECT_NEAR(solved.quantity("contact_angle_degrees_max"), largest, 0.05);
}

TEST(DropletSubstrates, WhatDoesNotFitIsRefused)
{
  DropletScene scene    = drop(120., {"axial", 3, 1});
  scene.substrate.shape = "sphere";
  scene.substrate.side  = "inside";
  scene.droplet.volume  = 5.;
  expect_user_error([&] { scene.start_mesh(); }, {"Droplet/Volume = 5", "does not fit", "Substrate/Radius = 1"});
  // Any drop has room on a ball.
  scene.substrate.side = "outside";
  EXPECT_LT(relative_error(Solved(scene).quantity("volume"), 5.), 1e-8);
}
} // namespace

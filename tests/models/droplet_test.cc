// SPDX-License-Identifier: LGPL-2.1-or-later
// Drops on a plane: spherical caps, and the equation of Young and Laplace with gravity. References with weight come
// from an independent integration of that equation along the meridian.
#include "droplet_runs.h"

#include <pellicle/potentials/edges/line_tension.h>

#include <gtest/gtest.h>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

struct WithWeight
{
  double angle, radius, height, pressure, gravity_energy, energy;
};
const std::vector<WithWeight> with_weight{
    {60., 1.332567052010, 0.655300788259, 1.675216511574, 0.486898079654, 4.775949806280},
    {90., 1.069538931973, 0.880630769504, 2.452759290254, 0.689062752985, 7.016507814302},
    {120., 0.845326416754, 1.070866201334, 2.981925967915, 0.901096678590, 8.466900035761},
    {150., 0.632736072819, 1.200834588833, 3.245626859197, 1.083267509374, 9.113169987773}};

double axial_bound(const double angle)
{
  return angle > 149. ? 1e-5 : 1e-6;
}

void expect_converged(const Solved &solved)
{
  EXPECT_TRUE(solved.result.converged);
  EXPECT_LE(solved.record.iterations.size(), 8u);
}

/** 2 pi a sin(theta) + weight = force of the pressure on the base, relative to the first. */
double force_error(const Solved &solved, const double angle)
{
  const double pull = 2. * pi * solved.quantity("contact_radius") * std::sin(angle * degree);
  return (pull + solved.quantity("liquid_weight") - solved.quantity("base_pressure_force")) / pull;
}

TEST(Droplet, AxialCaps)
{
  for (const double angle : {60., 90., 120., 150.})
  {
    SCOPED_TRACE(angle);
    std::vector<double> errors;
    for (const int refinements : {1, 2, 3})
    {
      const Solved solved(drop(angle, {"axial", 3, refinements}));
      expect_converged(solved);
      errors.push_back(relative_error(solved.quantity("contact_radius"), radius_of_cap(angle)));
    }
    EXPECT_LT(errors[1], axial_bound(angle));
    EXPECT_GT(std::log2(errors[0] / errors[1]), 5.5);
    EXPECT_GT(std::log2(errors[1] / errors[2]), 5.5);
  }
}

TEST(Droplet, AxialCapsFromFlatToRound)
{
  struct Case
  {
    double angle, radius_bound, energy_bound;
  };
  for (const Case c : {Case{5., 1e-10, 1e-11}, {30., 1e-8, 1e-10}, {170., 1e-3, 1e-7}, {175., 1e-2, 1e-6}})
  {
    SCOPED_TRACE(c.angle);
    const Solved solved(drop(c.angle, {"axial", 3, 2}));
    expect_converged(solved);
    const double a = radius_of_cap(c.angle), sphere = a / std::sin(c.angle * degree);
    EXPECT_LT(relative_error(solved.quantity("contact_radius"), a), c.radius_bound);
    EXPECT_LT(relative_error(solved.quantity("total_energy"), 3. * reference_volume / sphere), c.energy_bound);
    EXPECT_LT(relative_error(solved.quantity("pressure"), 2. / sphere), 1e-6);
    EXPECT_LT(relative_error(solved.quantity("apex_height"), sphere * (1. - std::cos(c.angle * degree))), 1e-4);
    EXPECT_LT(relative_error(solved.quantity("volume"), reference_volume), 1e-10);
  }
}

TEST(Droplet, AxialDropsWithWeight)
{
  for (const WithWeight &c : with_weight)
  {
    SCOPED_TRACE(c.angle);
    std::vector<double> errors;
    for (const int refinements : {1, 2, 3})
    {
      const Solved solved(heavy_drop(c.angle, {"axial", 3, refinements}));
      expect_converged(solved);
      errors.push_back(relative_error(solved.quantity("contact_radius"), c.radius));
      if (refinements != 2)
        continue;
      EXPECT_LT(relative_error(solved.quantity("apex_height"), c.height), 2e-5);
      EXPECT_LT(relative_error(solved.quantity("pressure"), c.pressure), 1e-7);
      EXPECT_LT(relative_error(solved.quantity("gravity_energy"), c.gravity_energy), 1e-6);
      EXPECT_LT(relative_error(solved.quantity("total_energy"), c.energy), 1e-8);
      EXPECT_LT(std::abs(force_error(solved, c.angle)), c.angle > 149. ? 2e-6 : 1e-7);
    }
    EXPECT_LT(errors[1], axial_bound(c.angle));
    EXPECT_GT(std::log2(errors[0] / errors[1]), 5.5);
    EXPECT_GT(std::log2(errors[1] / errors[2]), 5.5);
  }
}

TEST(Droplet, BalanceOfForcesOnFineMeshes)
{
  for (const double angle : {60., 90., 120.})
    EXPECT_LT(std::abs(force_error(Solved(heavy_drop(angle, {"axial", 4, 3})), angle)), 1e-8) << angle;
}

TEST(Droplet, InSpace)
{
  for (const bool heavy : {false, true})
    for (const WithWeight &c : with_weight)
    {
      SCOPED_TRACE(::testing::Message() << c.angle << (heavy ? " with weight" : ""));
      const double exact = heavy ? c.radius : radius_of_cap(c.angle);
      std::vector<double> errors;
      for (const int refinements : {1, 2})
      {
        const DropMesh mesh{"none", 3, refinements};
        const Solved solved(heavy ? heavy_drop(c.angle, mesh) : drop(c.angle, mesh));
        expect_converged(solved);
        EXPECT_EQ(solved.negative_eigenvalues(), 0);
        errors.push_back(relative_error(solved.quantity("contact_radius"), exact));
      }
      EXPECT_LT(errors[1], 1e-5);
      EXPECT_GT(std::log2(errors[0] / errors[1]), 4.);
    }
}

TEST(Droplet, InSpaceOneLevelFiner)
{
  const WithWeight &steepest = with_weight.back();
  const Solved solved(heavy_drop(steepest.angle, {"none", 3, 3}));
  expect_converged(solved);
  EXPECT_LT(relative_error(solved.quantity("contact_radius"), steepest.radius), 1e-6);
}

TEST(Droplet, DegreesOfTheMesh)
{
  for (const int mesh_degree : {2, 4, 5})
  {
    const Solved solved(heavy_drop(120., {"none", mesh_degree, 1}));
    expect_converged(solved);
    const double bound = mesh_degree == 2 ? 2e-3 : mesh_degree == 4 ? 1e-6 : 1e-7;
    EXPECT_LT(relative_error(solved.quantity("contact_radius"), with_weight[2].radius), bound) << mesh_degree;
  }
}

TEST(Droplet, NewtonsMethodConvergesQuadratically)
{
  const Solved solved(heavy_drop(120., {"none", 3, 1}));
  expect_quadratic_tail(solved.record.iterations, 0.1, 10., 1e-11);
}

TEST(Droplet, HangsUnderNegativeBondNumbers)
{
  for (const char *symmetry : {"axial", "none"})
  {
    DropletScene scene        = heavy_drop(90., {symmetry, 3, 1});
    scene.droplet.bond_number = -0.3;
    const Solved solved(scene);
    expect_converged(solved);
    // Upside down the weight pulls the drop off the plane.
    const double pull = 2. * pi * solved.quantity("contact_radius");
    EXPECT_NEAR(pull - solved.quantity("liquid_weight"), solved.quantity("base_pressure_force"), 1e-6 * pull);
    EXPECT_GT(solved.quantity("apex_height"), 1.);
  }
}

TEST(Droplet, EnergyChangesWithParametersAsItShould)
{
  const DropletScene scene = heavy_drop(75., {"axial", 4, 3});
  const Solved solved(scene);
  // Lengths are in units of R_eq inside, energies of gamma R_eq^2.
  const double unit = solved.model.scales().length, radius = solved.quantity("contact_radius");
  const auto slope = [&](const std::string &parameter)
  { return solved.model.energy_slope(scene, parameter).value() * unit * unit; };
  EXPECT_NEAR(slope("Droplet/Bond number"), solved.quantity("gravity_energy") / unit_bond_number, 1e-9);
  EXPECT_NEAR(slope("Droplet/Contact angle"), degree * std::sin(75. * degree) * pi * radius * radius, 1e-9);
  EXPECT_NEAR(slope("Droplet/Volume"), solved.quantity("pressure"), 1e-9);
}

TEST(Droplet, TensionOfTheLine)
{
  // Modified law of Young: cos(theta) = cos(60) - Lambda/(gamma a).
  const double lambda = 0.1;
  const double angle  = angle_of_cap([&](const double a) { return std::acos(0.5 - lambda / a) / degree; }, 60., 90.);
  for (const char *symmetry : {"axial", "none"})
  {
    DropletScene scene                                       = drop(60., {symmetry, 3, 2}, {"line tension"});
    effect<LineTensionEffect>(scene).parameters.line_tension = lambda;
    const Solved solved(scene);
    expect_converged(solved);
    EXPECT_LT(relative_error(solved.quantity("contact_radius"), radius_of_cap(angle)), 1e-7);
    EXPECT_LT(relative_error(solved.quantity("contact_angle_degrees"), angle), 1e-5);
  }
}

TEST(Droplet, WalksToAnotherAngle)
{
  Solved solved(drop(60., {"axial", 3, 2}));
  EXPECT_EQ(walk(solved, 4, [](const double t) { return drop(60. + 60. * t, {"axial", 3, 2}); }), 1.);
  EXPECT_LT(relative_error(solved.quantity("contact_radius"), radius_of_cap(120.)), 1e-4);
}
} // namespace

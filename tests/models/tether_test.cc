// SPDX-License-Identifier: LGPL-2.1-or-later
// A tube pulled from a flat membrane under tension: force and energies against length.
#include "equilibrium_runs.h"
#include "expect_user_error.h"

#include <pellicle/potentials/constraints/tether.h>

#include <gtest/gtest.h>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

/** kappa = 1, sigma = 1/2 (a tube of radius 1, force f0 = 2 pi), ring of radius 20, tip of radius 0.2. Values:
 * independent axisymmetric solution (shape equations, spectral elements checked by shooting). */
struct Pull
{
  double length;
  double force; ///< over f0
  double bending;
  double area_gained; ///< over the flat annulus
  double mid_height_radius;
};
constexpr Pull pulls[] = {
    {2., 0.41128736264, 0.5447374652, 4.124567137, 5.467986243},
    {5., 0.93083658567, 3.5463702586, 23.980627004, 4.938175216},
    {7.737, 1.15327360529, 9.7743723446, 48.417417832, 3.718309342},
    {10., 1.00155976747, 20.5324085118, 57.749700226, 1.755601532},
    {15., 1.00034525754, 36.1550374467, 89.041096195, 0.932708865},
    {25., 1.00000072150, 67.5893361384, 151.846846144, 1.003053478},
};
constexpr double f0 = 2. * pi, ring = 20., tip = 0.2, sigma = 0.5;
constexpr double flat_area = pi * (ring * ring - tip * tip);

/** The same pull in units of one's own: length_unit and kappa are how large they are in them. */
VesicleScene pulled_to(const double length, const int degree, const int refinements,
                       const std::string &symmetry = "axial", const double length_unit = 1., const double kappa = 1.)
{
  VesicleScene scene                                               = scene_with({"helfrich bending", "tether"});
  scene.mesh.degree                                                = degree;
  scene.mesh.refinements                                           = refinements;
  scene.mesh.symmetry                                              = symmetry;
  effect<HelfrichBendingEffect>(scene).parameters.bending_rigidity = kappa;
  TetherParameters &tether                                         = effect<TetherEffect>(scene).parameters;
  tether.length                                                    = length * length_unit;
  tether.ring_radius                                               = ring * length_unit;
  tether.tip_radius                                                = tip * length_unit;
  tether.tension                                                   = sigma * kappa / (length_unit * length_unit);
  return scene;
}

/** Pulls on in steps of at most 1.5; whether it got there. */
bool pull(Solved &solved, const double from, const double to, const std::function<VesicleScene(double length)> &scene)
{
  const int steps = static_cast<int>(std::ceil((to - from) / 1.5));
  return walk(solved, steps, [&](const double t) { return scene(from + t * (to - from)); }) == 1.;
}

void expect_pull(const Solved &solved, const Pull &exact, const double tolerance, const double length_unit = 1.,
                 const double kappa = 1.)
{
  const double area = flat_area + exact.area_gained;
  // In space the length of the polynomial rim, over which the height is the mean, counts as well.
  const bool axial = solved.model.mesh().kind == SurfaceDiscretization::Kind::meridian;
  EXPECT_LT(relative_error(solved.quantity("length"), exact.length * length_unit), axial ? 1e-9 : 1e-5)
      << "L = " << exact.length;
  EXPECT_LT(relative_error(solved.quantity("force"), exact.force * f0 * kappa / length_unit), tolerance)
      << "L = " << exact.length;
  EXPECT_LT(relative_error(solved.quantity("bending_energy"), exact.bending * kappa), tolerance)
      << "L = " << exact.length;
  EXPECT_LT(relative_error(solved.quantity("area") / (length_unit * length_unit) - flat_area, exact.area_gained),
            tolerance)
      << "L = " << exact.length;
  EXPECT_LT(relative_error(solved.quantity("total_energy"), kappa * (exact.bending + sigma * area)), tolerance)
      << "L = " << exact.length;
  EXPECT_EQ(solved.negative_eigenvalues(), 0) << "L = " << exact.length;
  if (axial)
  {
    EXPECT_NEAR(solved.quantity("mid_height_radius") / length_unit, exact.mid_height_radius, 10. * tolerance)
        << "L = " << exact.length;
  }
}

// From the flat membrane over the highest force, where a dome becomes a tube, to the plateau.
TEST(Tether, ForceAgainstLength)
{
  const auto scene = [](const double length) { return pulled_to(length, 5, 3); };
  Solved solved(scene(0.));
  ASSERT_TRUE(solved.result.converged) << solved.result.failure;
  EXPECT_NEAR(solved.quantity("force"), 0., 1e-9);
  EXPECT_NEAR(solved.quantity("area"), flat_area, 1e-9 * flat_area);
  double length = 0.;
  for (const Pull &exact : pulls)
  {
    ASSERT_TRUE(pull(solved, length, exact.length, scene)) << "L = " << exact.length << ": " << solved.result.failure;
    expect_pull(solved, exact, 1e-7);
    length = exact.length;
    if (length >= 15.)
    {
      EXPECT_LT(relative_error(solved.quantity("force"), f0), 1e-3) << "plateau, L = " << length;
    }
  }
}

TEST(Tether, ForceIsTheSlopeOfTheEnergy)
{
  constexpr double step = 0.01;
  double energy[2];
  Solved solved(pulled_to(0., 4, 3));
  ASSERT_TRUE(solved.result.converged);
  double length = 0.;
  double force  = 0.;
  for (const double next : {5. - step, 5., 5. + step})
  {
    ASSERT_TRUE(pull(solved, length, next, [](const double L) { return pulled_to(L, 4, 3); })) << solved.result.failure;
    length = next;
    if (next == 5.)
      force = solved.quantity("force");
    else
      energy[next < 5. ? 0 : 1] = solved.quantity("total_energy");
  }
  EXPECT_LT(relative_error((energy[1] - energy[0]) / (2. * step), force), 1e-5);
}

TEST(Tether, UnitsDoNotMatter)
{
  struct Units
  {
    double length, kappa;
  };
  for (const Units &units : {Units{5., 1.}, Units{1e-8, 8e-20}})
  {
    const auto scene = [&](const double length) { return pulled_to(length, 4, 3, "axial", units.length, units.kappa); };
    Solved solved(scene(0.));
    ASSERT_TRUE(pull(solved, 0., 5., scene)) << solved.result.failure;
    expect_pull(solved, pulls[1], 1e-7, units.length, units.kappa);
  }
}

TEST(Tether, InSpace)
{
  const auto scene = [](const double length) { return pulled_to(length, 3, 0, "none"); };
  Solved solved(scene(0.));
  ASSERT_TRUE(pull(solved, 0., 2., scene)) << solved.result.failure;
  expect_pull(solved, pulls[0], 0.01);
}

TEST(Tether, Refusals)
{
  EXPECT_USER_ERROR(scene_with({"tether"}).check(), "tether", "helfrich bending", "Effects");
  VesicleScene scene                                = pulled_to(1., 3, 2);
  effect<TetherEffect>(scene).parameters.tip_radius = 25.;
  EXPECT_USER_ERROR(scene.check(), "Tether/Tip radius = 25", "Tether/Ring radius = 20");
}
} // namespace

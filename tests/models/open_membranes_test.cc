// SPDX-License-Identifier: LGPL-2.1-or-later
// Open membranes whose rims are held: films between rings, caps, discs under pressure.
#include "expect_user_error.h"
#include "open_membranes.h"

#include <gtest/gtest.h>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

/** Film between two rings of radius 1 at the distance H: r = a cosh(z/a) with the waist a, the larger of two. */
struct Catenoid
{
  explicit Catenoid(const double H)
      : H(H)
  {
    // a cosh(H/(2a)) = 1 has its larger solution above the a at which the left side is least, t tanh t = 1, t = H/(2a).
    double low = H / (2. * 1.19967864025773), high = 1.;
    for (int i = 0; i < 100; ++i)
    {
      a                                               = 0.5 * (low + high);
      (a * std::cosh(H / (2. * a)) > 1. ? high : low) = a;
    }
  }
  double area() const { return pi * a * (H + a * std::sinh(H / a)); }
  double force() const { return 2. * pi * a; } ///< of unit tension on a ring, at the waist

  double H, a = 0.;
};
constexpr double largest_distance = 1.3254868; // of rings of radius 1

VesicleScene film(const double H, const OpenMesh &mesh, const std::vector<std::string> &effects = {"surface tension"})
{
  VesicleScene scene       = open_scene(effects, "tube", "hinged", mesh);
  scene.vesicle.area       = 2. * pi * H;
  scene.vesicle.tube_ratio = H;
  return scene;
}

/** Sum over a rim of the z components of the forces that hold its nodes, the user's units. */
double force_on(const Solved &solved, const std::string &rim)
{
  const NodalVectors forces = solved.model.equilibrium().nodal_forces().total;
  const EdgeLoop &loop      = loop_named(solved, rim);
  const std::set<std::size_t> nodes(loop.cell_nodes.begin(), loop.cell_nodes.end());
  double sum = 0.;
  for (const std::size_t node : nodes)
    sum += forces[3 * node + 2];
  return sum * solved.model.scales().of({1, -1});
}

TEST(OpenMembranes, FilmBetweenRings)
{
  struct Case
  {
    OpenMesh mesh;
    double area_tolerance, force_tolerance;
  };
  for (const Case &c : {Case{{"axial", 4, 3}, 1e-10, 1e-7}, Case{{"none", 3, 2}, 5e-6, 2e-3}})
    for (const double H : {0.5, 1., 1.3})
    {
      const std::string what = std::string(c.mesh.symmetry) + ", H = " + std::to_string(H);
      const Catenoid exact(H);
      const Solved solved(film(H, c.mesh));
      ASSERT_TRUE(solved.result.converged) << what << ": " << solved.result.failure;
      EXPECT_LT(relative_error(solved.quantity("area"), exact.area()), c.area_tolerance) << what;
      EXPECT_NEAR(force_on(solved, "upper rim"), exact.force(), c.force_tolerance) << what;
      EXPECT_NEAR(force_on(solved, "lower rim"), -exact.force(), c.force_tolerance) << what;
      EXPECT_EQ(solved.negative_eigenvalues(), 0) << what;
    }
}

TEST(OpenMembranes, FilmsOfOrderTwiceTheDegree)
{
  const Catenoid exact(1.);
  const Solved coarse(film(1., {"axial", 2, 2})), fine(film(1., {"axial", 2, 3}));
  ASSERT_TRUE(coarse.result.converged && fine.result.converged);
  const double error = relative_error(fine.quantity("area"), exact.area());
  EXPECT_LT(error, 1e-6);
  EXPECT_NEAR(std::log2(relative_error(coarse.quantity("area"), exact.area()) / error), 4., 0.3);
}

// No film where no catenoid is: the neck collapses, and there is a message.
TEST(OpenMembranes, NoFilmBetweenDistantRings)
{
  for (const OpenMesh &mesh : {OpenMesh{"axial", 4, 2}, OpenMesh{"none", 3, 1}})
  {
    const Solved near(film(1.32, mesh)), far(film(1.34, mesh));
    EXPECT_TRUE(near.result.converged) << mesh.symmetry << ": " << near.result.failure;
    EXPECT_EQ(near.negative_eigenvalues(), 0) << mesh.symmetry;
    EXPECT_FALSE(far.result.converged) << mesh.symmetry;
    EXPECT_FALSE(far.result.failure.empty()) << mesh.symmetry;
  }
  EXPECT_TRUE(Solved(film(largest_distance - 1e-4, {"axial", 4, 3})).result.converged);
  EXPECT_FALSE(Solved(film(largest_distance + 1e-4, {"axial", 4, 3})).result.converged);
}

// A minimal surface has no mean curvature: bending changes nothing, hinges bear no moment.
TEST(OpenMembranes, FilmThatBends)
{
  const Catenoid exact(1.);
  for (const OpenMesh &mesh : {OpenMesh{"axial", 4, 3}, OpenMesh{"none", 3, 2}})
  {
    const bool axial = mesh.symmetry == std::string("axial");
    const Solved solved(film(1., mesh, {"helfrich bending", "surface tension"}));
    ASSERT_TRUE(solved.result.converged) << mesh.symmetry << ": " << solved.result.failure;
    EXPECT_NEAR(solved.quantity("bending_energy"), 0., axial ? 1e-10 : 1e-5) << mesh.symmetry;
    EXPECT_LT(relative_error(solved.quantity("area"), exact.area()), axial ? 1e-10 : 1e-6) << mesh.symmetry;
    EXPECT_NEAR(force_on(solved, "upper rim"), exact.force(), axial ? 1e-6 : 2e-3) << mesh.symmetry;
    EXPECT_EQ(solved.negative_eigenvalues(), 0) << mesh.symmetry;
  }
}

// Part of a sphere of radius 1 in a clamp that fits it, P = 2 sigma/R + kappa C0^2/R - 2 kappa C0/R^2.
TEST(OpenMembranes, ClampedCaps)
{
  constexpr double sigma = 1.5;
  for (const OpenMesh &mesh : {OpenMesh{"axial", 4, 2}, OpenMesh{"none", 3, 1}})
    for (const double angle : {60., 120.})
      for (const double C0 : {0., 0.7})
      {
        const std::string what =
            std::string(mesh.symmetry) + ", angle " + std::to_string(angle) + ", C0 = " + std::to_string(C0);
        const double height = 1. - std::cos(angle * pi / 180.), area = 2. * pi * height;
        VesicleScene scene = open_scene({"helfrich bending", "surface tension", "pressure"}, "cap", "clamped", mesh);
        scene.vesicle.area = area;
        scene.vesicle.cap_angle                                               = angle;
        effect<HelfrichBendingEffect>(scene).parameters.spontaneous_curvature = C0;
        effect<SurfaceTensionEffect>(scene).parameters.tension                = sigma;
        effect<PressureEffect>(scene).parameters.pressure                     = 2. * sigma + C0 * C0 - 2. * C0;
        const Solved solved(scene);
        ASSERT_TRUE(solved.result.converged) << what << ": " << solved.result.failure;
        const double tolerance = mesh.symmetry == std::string("axial") ? 1e-10 : 5e-5;
        EXPECT_LT(relative_error(solved.quantity("area"), area), tolerance) << what;
        EXPECT_LT(relative_error(solved.quantity("height"), height), tolerance) << what;
        EXPECT_LT(relative_error(solved.quantity("bending_energy"), 0.5 * (2. - C0) * (2. - C0) * area), tolerance)
            << what;
        EXPECT_EQ(solved.negative_eigenvalues(), 0) << what;
      }
}

/** A disc of radius 1 under pressure from below, kappa = sigma = 1. Values: independent axisymmetric solution (shape
 * equations, spectral elements checked by shooting). */
struct Bulge
{
  const char *rim;
  double pressure;
  double height, bending, area_gained, volume;
};
constexpr Bulge bulges[] = {
    {"clamped", 5., 0.073974636845, 0.184707170460, 0.011513419792, 0.077995128702},
    {"clamped", 20., 0.437178179090, 5.257580790734, 0.390628385811, 0.461260904912},
    {"hinged", 5., 0.220557393943, 0.701299118606, 0.124857141266, 0.312510005703},
};

VesicleScene bulging_disc(const std::string &rim, const double pressure, const OpenMesh &mesh,
                          const double kappa_G = 0.)
{
  std::vector<std::string> effects{"helfrich bending", "surface tension", "pressure"};
  if (kappa_G != 0.)
    effects.push_back("gaussian curvature");
  VesicleScene scene                                = open_scene(effects, "disc", rim, mesh);
  scene.vesicle.area                                = pi;
  effect<PressureEffect>(scene).parameters.pressure = pressure;
  if (kappa_G != 0.)
    effect<GaussianCurvatureEffect>(scene).parameters.gaussian_modulus = kappa_G;
  return scene;
}

TEST(OpenMembranes, BulgingDiscs)
{
  struct Case
  {
    OpenMesh mesh;
    double tolerance;
  };
  for (const Case &c : {Case{{"axial", 4, 3}, 1e-8}, Case{{"none", 3, 1}, 1e-4}})
    for (const Bulge &exact : bulges)
    {
      const std::string what =
          std::string(c.mesh.symmetry) + ", " + exact.rim + ", P = " + std::to_string(exact.pressure);
      const Solved solved(bulging_disc(exact.rim, exact.pressure, c.mesh));
      ASSERT_TRUE(solved.result.converged) << what << ": " << solved.result.failure;
      EXPECT_LT(relative_error(solved.quantity("height"), exact.height), c.tolerance) << what;
      EXPECT_LT(relative_error(solved.quantity("bending_energy"), exact.bending), c.tolerance) << what;
      EXPECT_NEAR(solved.quantity("area") - pi, exact.area_gained, c.tolerance) << what;
      EXPECT_NEAR(-solved.quantity("pressure_energy") / exact.pressure, exact.volume, c.tolerance) << what;
      EXPECT_EQ(solved.negative_eigenvalues(), 0) << what;
    }
}

TEST(OpenMembranes, BulgesOfOrderTwiceTheDegree)
{
  const Bulge &exact = bulges[0];
  const auto error   = [&](const int refinements)
  {
    const Solved solved(bulging_disc(exact.rim, exact.pressure, {"axial", 3, refinements}));
    EXPECT_TRUE(solved.result.converged) << solved.result.failure;
    return relative_error(solved.quantity("bending_energy"), exact.bending);
  };
  EXPECT_NEAR(std::log2(error(1) / error(2)), 6., 0.5);
}

// Beyond the pressure of the fold, known as the bulges are, the disc inflates without end.
TEST(OpenMembranes, HighestPressureOfABulge)
{
  constexpr double hinged = 7.914074486, clamped = 20.520385651;
  for (const auto &[rim, highest] : {std::pair{"hinged", hinged}, std::pair{"clamped", clamped}})
  {
    const Solved below(bulging_disc(rim, 0.995 * highest, {"axial", 4, 2})),
        above(bulging_disc(rim, 1.005 * highest, {"axial", 4, 2}));
    EXPECT_TRUE(below.result.converged) << rim << ": " << below.result.failure;
    EXPECT_EQ(below.negative_eigenvalues(), 0) << rim;
    EXPECT_FALSE(above.result.converged) << rim;
    EXPECT_FALSE(above.result.failure.empty()) << rim;
  }
}

// A hinge bears the moment -kappa_G times the normal curvature along the rim. The meridian, which is checked elsewhere,
// against the surface.
TEST(OpenMembranes, GaussianModulusAtAHinge)
{
  const Solved axial(bulging_disc("hinged", 5., {"axial", 4, 3}, -0.5)),
      surface(bulging_disc("hinged", 5., {"none", 3, 1}, -0.5));
  ASSERT_TRUE(axial.result.converged) << axial.result.failure;
  ASSERT_TRUE(surface.result.converged) << surface.result.failure;
  EXPECT_GT(axial.quantity("height"), 1.1 * bulges[2].height);
  for (const char *name : {"height", "bending_energy", "gaussian_energy", "area", "pressure_energy"})
    EXPECT_LT(relative_error(surface.quantity(name), axial.quantity(name)), 2e-6) << name;
  EXPECT_EQ(surface.negative_eigenvalues(), 0);
}

TEST(OpenMembranes, Refusals)
{
  const OpenMesh mesh{"axial", 3, 2};
  EXPECT_USER_ERROR(open_scene({"surface tension", "volume constraint"}, "disc", "hinged", mesh).check(),
                    "volume constraint", "closed surface", "open");
  EXPECT_USER_ERROR(open_scene({"helfrich bending", "line tension"}, "disc", "clamped", mesh).check(), "line tension",
                    "Vesicle/Rim", "free");
  EXPECT_USER_ERROR(open_scene({"helfrich bending", "line tension"}, "prolate", "free", mesh).check(), "line tension",
                    "open");
  EXPECT_USER_ERROR(open_scene({"surface tension", "gaussian curvature"}, "disc", "hinged", mesh).check(),
                    "gaussian curvature", "helfrich bending");
}
} // namespace

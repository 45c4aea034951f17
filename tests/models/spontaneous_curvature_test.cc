// SPDX-License-Identifier: LGPL-2.1-or-later
// Vesicles with spontaneous curvature: energies, tensions and pressures of known branches; spheres by hand.
#include "equilibrium_runs.h"

#include <gtest/gtest.h>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

/** A vesicle of area 4 pi, kappa = 1. Values: independent axisymmetric solution (shape equations, spectral elements
 * checked by shooting), to the digits given. */
struct Vesicle
{
  const char *start;
  double reduced_volume, C0;
  double energy; ///< over 8 pi kappa
  double tension, pressure;
  double mean_curvature; ///< M/(4 pi)
};
constexpr Vesicle known[] = {
    {"prolate", 0.90, 1.2, 0.289174163999, -2.542365041, -6.850758680, 1.0503969707},
    {"prolate", 0.90, -1.2, 2.810102014328, -9.108776007, -15.840718822, 1.0503771146},
    {"prolate", 0.90, 2.4, 0.108690657148, -1.419798215, -2.357289406, 1.0504091740},
    {"prolate", 0.90, -2.4, 5.150549540201, -14.552561860, -20.337058750, 1.0503689260},
    {"oblate", 0.65, 1.2, 0.936864858190, -4.482628004, -15.426240475, 1.0424167920},
};

VesicleScene scene_of(const Vesicle &vesicle_known, const int degree, const int refinements,
                      const std::string &symmetry = "none")
{
  VesicleScene scene = vesicle(vesicle_known.start, vesicle_known.reduced_volume, degree, refinements, symmetry);
  effect<HelfrichBendingEffect>(scene).parameters.spontaneous_curvature = vesicle_known.C0;
  return scene;
}

std::string name_of(const Vesicle &v)
{
  return std::string(v.start) + " v = " + std::to_string(v.reduced_volume) + ", C0 = " + std::to_string(v.C0);
}

// On 32 cells of degree 5 the error h^10 is below the digits of the reference. Under a change of size the energy does
// not change but for C0, which gives the last line: 2 sigma A - 3 P V + C0^2 A - 2 C0 M = 0.
TEST(SpontaneousCurvature, AxialBranches)
{
  for (const Vesicle &exact : known)
  {
    const Solved solved(scene_of(exact, 5, 3, "axial"));
    ASSERT_TRUE(solved.result.converged) << name_of(exact) << ": " << solved.result.failure;
    EXPECT_LT(relative_error(solved.energy(), exact.energy), 1e-8) << name_of(exact);
    EXPECT_NEAR(solved.sigma(), exact.tension, 1e-6) << name_of(exact);
    EXPECT_NEAR(solved.pressure(), exact.pressure, 1e-6) << name_of(exact);
    const double M = solved.quantity("integrated_mean_curvature"), A = 4. * pi, V = exact.reduced_volume * A / 3.;
    EXPECT_NEAR(M / A, exact.mean_curvature, 1e-8) << name_of(exact);
    EXPECT_NEAR(2. * solved.sigma() * A - 3. * solved.pressure() * V + exact.C0 * (exact.C0 * A - 2. * M), 0., 1e-6)
        << name_of(exact);
    EXPECT_EQ(solved.negative_eigenvalues(), 0) << name_of(exact);
  }
}

TEST(SpontaneousCurvature, EnergyConvergesAtTwiceTheDegree)
{
  struct Mesh
  {
    int degree;
    double fine_error; ///< allowed on 64 cells
  };
  for (const Mesh mesh : {Mesh{2, 1e-6}, Mesh{3, 1e-9}})
    for (const Vesicle &exact : {known[0], known[4]})
    {
      const Solved coarse(scene_of(exact, mesh.degree, 3, "axial")), fine(scene_of(exact, mesh.degree, 4, "axial"));
      ASSERT_TRUE(coarse.result.converged && fine.result.converged) << name_of(exact);
      const double error = relative_error(fine.energy(), exact.energy);
      EXPECT_LT(error, mesh.fine_error) << name_of(exact) << ", degree " << mesh.degree;
      EXPECT_NEAR(std::log2(relative_error(coarse.energy(), exact.energy) / error), 2. * mesh.degree, 0.3)
          << name_of(exact) << ", degree " << mesh.degree;
    }
}

// Cubic cells: order 6, so the 384 cells gain a factor 64 over the 96.
TEST(SpontaneousCurvature, InSpace)
{
  const Vesicle &exact = known[0];
  const Solved coarse(scene_of(exact, 3, 2)), fine(scene_of(exact, 3, 3));
  ASSERT_TRUE(coarse.result.converged) << coarse.result.failure;
  ASSERT_TRUE(fine.result.converged) << fine.result.failure;
  EXPECT_LT(relative_error(fine.energy(), exact.energy), 1e-6);
  EXPECT_GT(std::log2(relative_error(coarse.energy(), exact.energy) / relative_error(fine.energy(), exact.energy)), 5.);
  EXPECT_NEAR(fine.sigma(), exact.tension, 1e-4);
  EXPECT_NEAR(fine.pressure(), exact.pressure, 1e-4);
  EXPECT_NEAR(coarse.sigma(), exact.tension, 2e-3);
  EXPECT_NEAR(coarse.pressure(), exact.pressure, 2e-3);
}

// C0 is a curvature, of dimension 1/length.
TEST(SpontaneousCurvature, UnitsDoNotMatter)
{
  const Vesicle &exact    = known[0];
  constexpr double length = 5e-6, kappa = 8e-20;
  VesicleScene scene            = scene_of(exact, 5, 3, "axial");
  scene.vesicle.area            = 4. * pi * length * length;
  auto &bending                 = effect<HelfrichBendingEffect>(scene).parameters;
  bending.bending_rigidity      = kappa;
  bending.spontaneous_curvature = exact.C0 / length;
  const Solved solved(scene);
  ASSERT_TRUE(solved.result.converged) << solved.result.failure;
  EXPECT_LT(relative_error(solved.quantity("bending_energy_over_8_pi_kappa"), exact.energy), 1e-8);
  EXPECT_LT(relative_error(solved.quantity("bending_energy"), 8. * pi * kappa * exact.energy), 1e-8);
  EXPECT_LT(relative_error(solved.quantity("tension"), exact.tension * kappa / (length * length)), 1e-6);
  EXPECT_LT(relative_error(solved.quantity("pressure"), exact.pressure * kappa / std::pow(length, 3)), 1e-6);
}

// With R = 2/C0 the sphere costs nothing, and no tension is needed to hold its area. What remains is the error of the
// mesh, of order h^6.
TEST(SpontaneousCurvature, StressFreeSphere)
{
  struct Mesh
  {
    const char *symmetry;
    int refinements;
    double tolerance;
  };
  for (const Mesh mesh : {Mesh{"axial", 3, 1e-9}, Mesh{"none", 2, 1e-6}})
  {
    VesicleScene scene        = scene_with({"helfrich bending", "area constraint"});
    scene.vesicle.start_shape = "ellipsoid";
    scene.vesicle.semi_axes   = {1., 1., 1.2};
    scene.mesh.degree         = 3;
    scene.mesh.refinements    = mesh.refinements;
    scene.mesh.symmetry       = mesh.symmetry;
    effect<HelfrichBendingEffect>(scene).parameters.spontaneous_curvature = 2.;
    const Solved sphere(scene);
    ASSERT_TRUE(sphere.result.converged) << mesh.symmetry << ": " << sphere.result.failure;
    EXPECT_NEAR(sphere.energy(), 0., mesh.tolerance) << mesh.symmetry;
    EXPECT_NEAR(sphere.sigma(), 0., 10. * mesh.tolerance) << mesh.symmetry;
    EXPECT_NEAR(sphere.shape().height, 2., 100. * mesh.tolerance) << mesh.symmetry;
    EXPECT_EQ(sphere.negative_eigenvalues(), 0) << mesh.symmetry;
  }
}

// The multiplier of a sphere's volume: P = 2 sigma/R + kappa C0^2/R - 2 kappa C0/R^2.
TEST(SpontaneousCurvature, PressureOfASphere)
{
  constexpr double sigma = 3., kappa = 2., v = 0.8;
  const double R = std::cbrt(v);
  for (const double C0 : {1.5, -1.})
  {
    VesicleScene scene           = scene_with({"helfrich bending", "surface tension", "volume constraint"});
    scene.vesicle.start_shape    = "ellipsoid";
    scene.vesicle.semi_axes      = {1., 1., 1.2};
    scene.vesicle.reduced_volume = v;
    scene.mesh.degree            = 4;
    scene.mesh.refinements       = 3;
    scene.mesh.symmetry          = "axial";
    effect<HelfrichBendingEffect>(scene).parameters        = {kappa, C0};
    effect<SurfaceTensionEffect>(scene).parameters.tension = sigma;
    const Solved sphere(scene);
    ASSERT_TRUE(sphere.result.converged) << "C0 = " << C0 << ": " << sphere.result.failure;
    const double exact = 2. * sigma / R + kappa * C0 * C0 / R - 2. * kappa * C0 / (R * R);

    EXPECT_NEAR(sphere.quantity("pressure"), exact, 1e-7) << "C0 = " << C0;
    EXPECT_NEAR(sphere.quantity("bending_energy"), 2. * pi * kappa * (2. - C0 * R) * (2. - C0 * R), 1e-6)
        << "C0 = " << C0;
  }
}
} // namespace

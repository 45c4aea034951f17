// SPDX-License-Identifier: LGPL-2.1-or-later
// Integrated mean curvature: its values on spheres, its multiplier, pears, and area-difference elasticity.
#include "equilibrium_runs.h"
#include "expect_user_error.h"

#include <pellicle/potentials/constraints/bilayer_curvature.h>

#include <gtest/gtest.h>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

/** A vesicle of area 4 pi, kappa = 1, C0 = 0. Values: independent axisymmetric solution (shape equations, spectral
 * elements checked by shooting). */
struct Vesicle
{
  const char *start;
  double reduced_volume;
  double mean_curvature; ///< M/(4 pi)
  double energy;         ///< over 8 pi kappa
  double tension, pressure, multiplier;
};
constexpr Vesicle discocyte = {"oblate", 0.65, 1.05, 1.858985725724, 4.32324613, -13.82106125, -16.79064960};
constexpr Vesicle dumbbell  = {"prolate", 0.65, 1.33, 1.843380009795, -2.17940474, -12.55147796, -2.85688060};
constexpr Vesicle symmetric = {"prolate", 0.90, 1.06, 1.313226014928, 28.09533726, 34.95096616, -23.33472167};
constexpr Vesicle pear      = {"prolate", 0.90, 1.06, 1.253739211965, 13.69731648, 15.33951640, -12.81987566};
constexpr Vesicle slim_pear = {"prolate", 0.90, 1.10, 1.472113474174, 12.50852367, 16.39103064, -9.33192705};

VesicleScene scene_of(const std::vector<std::string> &effects, const Vesicle &v, const int degree,
                      const int refinements, const std::string &symmetry)
{
  VesicleScene scene           = scene_with(effects);
  scene.vesicle.start_shape    = v.start;
  scene.vesicle.reduced_volume = v.reduced_volume;
  scene.mesh.degree            = degree;
  scene.mesh.refinements       = refinements;
  scene.mesh.symmetry          = symmetry;
  return scene;
}

VesicleScene coupled(const Vesicle &v, const int degree, const int refinements, const std::string &symmetry = "axial")
{
  VesicleScene scene = scene_of({"helfrich bending", "area constraint", "volume constraint", "bilayer coupling"}, v,
                                degree, refinements, symmetry);
  effect<BilayerCouplingEffect>(scene).parameters.integrated_mean_curvature = 4. * pi * v.mean_curvature;
  return scene;
}

void expect_solution(const SurfaceModel &model, const Vesicle &exact, const double energy_tolerance,
                     const double multiplier_tolerance)
{
  EXPECT_LT(relative_error(quantity(model, "bending_energy") / (8. * pi), exact.energy), energy_tolerance);
  EXPECT_NEAR(quantity(model, "tension"), exact.tension, multiplier_tolerance);
  EXPECT_NEAR(quantity(model, "pressure"), exact.pressure, multiplier_tolerance);
  EXPECT_NEAR(quantity(model, "bilayer_coupling_multiplier"), exact.multiplier, multiplier_tolerance);
  EXPECT_NEAR(quantity(model, "area"), 4. * pi, 1e-9);
  EXPECT_LT(relative_error(quantity(model, "reduced_volume"), exact.reduced_volume), 1e-9);
}

// M = 4 pi R and E = 2 pi kappa (2 - C0 R)^2 at any multiplier Q, though Q shifts the moment and with it both of the
// sums that they are differences of. Errors of order h^2k: of M at Q = 0, and of the shift's energy Q^2 r/2, r = A/(4
// kappa).
TEST(BilayerCoupling, SpheresAtAnyMultiplier)
{
  constexpr double kappa = 2., C0 = 0.6;
  struct Mesh
  {
    const char *symmetry;
    int refinements;
    double tolerance;
  };
  for (const Mesh mesh : {Mesh{"axial", 3, 1e-9}, Mesh{"none", 2, 1e-6}})
    for (const double R : {0.5, 1., 3.})
    {
      VesicleScene scene                              = scene_with({"helfrich bending", "bilayer coupling"});
      scene.vesicle.start_shape                       = "ellipsoid";
      scene.vesicle.semi_axes                         = {1., 1., 1.};
      scene.vesicle.area                              = 4. * pi * R * R;
      scene.mesh.degree                               = 3;
      scene.mesh.refinements                          = mesh.refinements;
      scene.mesh.symmetry                             = mesh.symmetry;
      effect<HelfrichBendingEffect>(scene).parameters = {kappa, C0};
      const SurfaceDiscretization sphere              = make_start_shape(scene.start_shape());
      Communicator communicator;
      Timing timing;
      SurfaceProblem problem(sphere, scene.potentials(Scales{}), {}, communicator, "mumps", timing);
      for (const double Q : {0., 3., -40.})
      {
        SurfaceState state = problem.state();
        state.multipliers  = {Q};
        problem.set_state(state);
        const double M = problem.values().constraints[0], shift = Q * Q * pi * R * R / (2. * kappa);
        EXPECT_LT(relative_error(M, 4. * pi * R), mesh.tolerance) << mesh.symmetry << ", R = " << R << ", Q = " << Q;
        EXPECT_NEAR(problem.energy(), 2. * pi * kappa * (2. - C0 * R) * (2. - C0 * R),
                    mesh.tolerance * (8. * pi * kappa + shift))
            << mesh.symmetry << ", R = " << R << ", Q = " << Q;
      }
    }
}

TEST(BilayerCoupling, AxialBranches)
{
  for (const Vesicle &exact : {discocyte, dumbbell})
  {
    const Solved solved(coupled(exact, 5, 4));
    ASSERT_TRUE(solved.result.converged) << exact.start << ": " << solved.result.failure;
    expect_solution(solved.model, exact, 1e-8, 1e-6);
    EXPECT_NEAR(solved.quantity("integrated_mean_curvature") / (4. * pi), exact.mean_curvature, 1e-8);
    EXPECT_EQ(solved.negative_eigenvalues(), 0);

    // Cubic cells: the energy of order 6.
    const Solved coarse(coupled(exact, 3, 3)), fine(coupled(exact, 3, 4));
    ASSERT_TRUE(coarse.result.converged && fine.result.converged);
    const double error = relative_error(fine.energy(), exact.energy);
    EXPECT_LT(error, 1e-8);
    EXPECT_NEAR(std::log2(relative_error(coarse.energy(), exact.energy) / error), 6., 0.5) << exact.start;
  }
}

// In space that disc is a saddle towards lobed shapes; the axisymmetric one is found all the same.
TEST(BilayerCoupling, InSpace)
{
  const Solved solved(coupled(discocyte, 3, 2, "none"));
  ASSERT_TRUE(solved.result.converged) << solved.result.failure;
  expect_solution(solved.model, discocyte, 2e-4, 0.1);
}

// d/dM0 of the lowest energy under M = M0 is -Q.
TEST(BilayerCoupling, MultiplierIsTheSlopeOfTheEnergy)
{
  constexpr double step = 2.5e-4; // of M/(4 pi)
  std::vector<double> energy;
  double Q = 0.;
  for (const double difference : {-step, 0., step})
  {
    Vesicle v = dumbbell;
    v.mean_curvature += difference;
    const Solved solved(coupled(v, 4, 3));
    ASSERT_TRUE(solved.result.converged) << solved.result.failure;
    energy.push_back(solved.quantity("bending_energy"));
    if (difference == 0.)
      Q = solved.quantity("bilayer_coupling_multiplier");
  }
  // The remainder is of order step^2.
  EXPECT_NEAR((energy[2] - energy[0]) / (2. * step * 4. * pi), -Q, 1e-4);
}

// Beyond M/(4 pi) = 1.05048 the prolate is a saddle, from which pears branch off.
TEST(BilayerCoupling, Pears)
{
  VesicleScene scene = coupled(symmetric, 4, 4);
  {
    const Solved saddle(scene);
    ASSERT_TRUE(saddle.result.converged) << saddle.result.failure;
    EXPECT_EQ(saddle.negative_eigenvalues(), 1);
    expect_solution(saddle.model, symmetric, 1e-8, 1e-5);
  }
  scene.stability.follow_unstable_mode = true;
  Solved solved(scene);
  ASSERT_TRUE(solved.result.converged) << solved.result.failure;
  EXPECT_EQ(solved.negative_eigenvalues(), 0);
  expect_solution(solved.model, pear, 1e-8, 1e-5);

  solved.model.update(coupled(slim_pear, 4, 4));
  const StepResult slimmer = solved.model.solve(2, solved.record);
  ASSERT_TRUE(slimmer.converged) << slimmer.failure;
  EXPECT_EQ(solved.negative_eigenvalues(), 0);
  expect_solution(solved.model, slim_pear, 1e-8, 1e-5);
}

// (kbar/2)(M - M0)^2 pulls with Q = kbar (M - M0): the shapes are those of bilayer coupling at M.
TEST(BilayerCoupling, AreaDifferenceElasticity)
{
  constexpr double stiffness = 1.5;
  VesicleScene scene =
      scene_of({"helfrich bending", "area constraint", "volume constraint", "area difference elasticity"}, dumbbell, 5,
               4, "axial");
  const double M                                           = 4. * pi * dumbbell.mean_curvature;
  effect<AreaDifferenceElasticityEffect>(scene).parameters = {M - dumbbell.multiplier / stiffness, stiffness};
  const Solved solved(scene);
  ASSERT_TRUE(solved.result.converged) << solved.result.failure;
  expect_solution(solved.model, dumbbell, 1e-8, 1e-6);
  EXPECT_NEAR(solved.quantity("integrated_mean_curvature"), M, 1e-7);
  const double difference = dumbbell.multiplier * dumbbell.multiplier / (2. * stiffness);
  EXPECT_LT(relative_error(solved.quantity("area_difference_energy"), difference), 1e-8);
  EXPECT_LT(relative_error(solved.quantity("total_energy"), 8. * pi * dumbbell.energy + difference), 1e-8);
  EXPECT_EQ(solved.negative_eigenvalues(), 0);
}

TEST(BilayerCoupling, NeedsBending)
{
  for (const std::string name : {"bilayer coupling", "area difference elasticity"})
    EXPECT_USER_ERROR(scene_with({name, "surface tension", "volume constraint"}).check(), name, "helfrich bending",
                      "Effects");
}
} // namespace

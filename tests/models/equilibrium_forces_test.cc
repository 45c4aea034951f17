// SPDX-License-Identifier: LGPL-2.1-or-later
// Spheres, drops, penalties, refusals: what follows from a force balance by hand.
#include "equilibrium_runs.h"
#include "expect_user_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

VesicleScene unit_sphere(VesicleScene scene, const int degree, const int refinements,
                         const std::string &symmetry = "none")
{
  scene.vesicle.start_shape = "ellipsoid";
  scene.vesicle.semi_axes   = {1., 1., 1.};
  scene.mesh.degree         = degree;
  scene.mesh.refinements    = refinements;
  scene.mesh.symmetry       = symmetry;
  return scene;
}

/** Work of the forces at the nodes of an exact sphere on the normal displacement u(x), chart graph; and how nearly they
 * cancel, cell by cell. */
struct SphereForces
{
  double work;
  double relative_residual;
};
SphereForces forces_on_sphere(const double C0, const double sigma, const double pressure, const int degree,
                              const int refinements, const std::function<double(const Vector3<double> &)> &u)
{
  VesicleScene scene =
      unit_sphere(scene_with({"helfrich bending", "surface tension", "pressure"}), degree, refinements);
  effect<HelfrichBendingEffect>(scene).parameters.spontaneous_curvature = C0;
  effect<SurfaceTensionEffect>(scene).parameters.tension                = sigma;
  effect<PressureEffect>(scene).parameters.pressure                     = pressure;
  const SurfaceDiscretization mesh                                      = make_start_shape(scene.start_shape());
  Communicator communicator;
  Timing timing;
  SurfaceProblem problem(mesh, scene.potentials(Scales{}), {}, communicator, "mumps", timing);
  problem.use_chart(PositionChart::graph, mesh.positions);
  problem.linearize();
  const Numbering &numbering = problem.numbering();
  double work                = 0.;
  for (std::size_t I = 0; I < mesh.n_nodes; ++I)
  {
    const Vector3<double> x(mesh.positions[3 * I], mesh.positions[3 * I + 1], mesh.positions[3 * I + 2]);
    work += u(x) * problem.residual()[numbering.first[I * numbering.n_fields()]];
  }
  return {work, problem.relative_residual()};
}

// Normal force per area on a sphere: 2 sigma/R + kappa C0^2/R - 2 kappa C0/R^2 - P. Forces at nodes are of order k - 2
// only (bending is of fourth order), their work on smooth displacements is of order 2k.
TEST(EquilibriumForces, SphereRelationWithSpontaneousCurvature)
{
  const double sigma = 0.7;
  struct Displacement
  {
    std::function<double(const Vector3<double> &)> u;
    double integral; // over the sphere
  };
  const std::vector<Displacement> displacements = {
      {[](const Vector3<double> &) { return 1.; }, 4. * pi},
      {[](const Vector3<double> &x) { return x[0] * x[0] * x[0] * x[0] - 0.3 * x[1] * x[2]; }, 4. * pi / 5.}};
  for (const double C0 : {2., -1.5})
    for (const auto &[u, integral] : displacements)
    {
      const double pressure     = 2. * sigma + C0 * C0 - 2. * C0;
      const SphereForces coarse = forces_on_sphere(C0, sigma, pressure, 3, 2, u),
                         fine   = forces_on_sphere(C0, sigma, pressure, 3, 3, u);
      const SphereForces off    = forces_on_sphere(C0, sigma, pressure + 0.01, 3, 3, u);
      EXPECT_LT(std::abs(fine.work), 1e-6);
      EXPECT_GT(std::log2(std::abs(coarse.work / fine.work)), 4.);
      EXPECT_LT(fine.relative_residual, 0.6 * coarse.relative_residual);
      // 0.01 too much pressure does the work -0.01 times the integral of u.
      EXPECT_NEAR(off.work - fine.work, -0.01 * integral, 1e-6);
    }
}

TEST(EquilibriumForces, DropBecomesASphere)
{
  for (const std::string symmetry : {"none", "axial"})
  {
    VesicleScene scene        = scene_with({"surface tension", "volume constraint"});
    scene.vesicle.start_shape = "ellipsoid";
    scene.vesicle.semi_axes   = {1., 1., 1.3};
    if (symmetry == "none")
      scene.vesicle.semi_axes[0] = 0.9;
    scene.vesicle.reduced_volume                           = 0.9;
    scene.mesh.degree                                      = 3;
    scene.mesh.refinements                                 = 2;
    scene.mesh.symmetry                                    = symmetry;
    effect<SurfaceTensionEffect>(scene).parameters.tension = 3.;
    Solved drop(scene);
    ASSERT_TRUE(drop.result.converged) << symmetry << ": " << drop.result.failure;
    const double R            = std::cbrt(0.9);
    const double units        = drop.model.scales().of(dimensions::pressure);
    const double pressure     = -units * drop.model.equilibrium().state().multipliers[0];
    const ShapeMeasures shape = drop.shape();
    EXPECT_NEAR(pressure / (2. * 3. / R), 1., 1e-5);
    EXPECT_NEAR(shape.area, 4. * pi * R * R, 1e-5);
    EXPECT_NEAR(shape.height, 2. * R, 1e-3);
    EXPECT_NEAR(shape.equatorial_radius, R, 1e-3);
    EXPECT_EQ(drop.negative_eigenvalues(), 0);
  }
}

TEST(EquilibriumForces, ExactSphereUnderBothConstraintsIsRefused)
{
  for (const std::string symmetry : {"none", "axial", "axial mirror"})
  {
    SCOPED_TRACE(symmetry);
    Communicator communicator;
    Timing timing;
    EXPECT_USER_ERROR(SurfaceModel(unit_sphere(vesicle("ellipsoid", 0.95, 3, 2), 3, 2, symmetry), communicator, timing),
                      "sphere", "area constraint", "volume constraint", "Vesicle/Start shape", "Semi axes");
  }
}

TEST(EquilibriumForces, OneConstraintAndAPenaltyAreFineOnASphere)
{
  Communicator communicator;
  Timing timing;
  VesicleScene scene                                       = unit_sphere(vesicle("ellipsoid", 0.95, 3, 1), 3, 1);
  effect<AreaConstraintEffect>(scene).parameters.stiffness = 100.;
  EXPECT_NO_THROW(SurfaceModel(scene, communicator, timing));
}

// Finite stiffness c: sigma = c (A - A0), and the exact constraint in the limit.
TEST(EquilibriumForces, PenaltyOnTheArea)
{
  double last = 1.;
  for (const double c : {1e2, 1e4, 1e6})
  {
    VesicleScene scene                                       = vesicle("prolate", 0.95, 3, 1);
    effect<AreaConstraintEffect>(scene).parameters.stiffness = c;
    const Solved solved(scene);
    ASSERT_TRUE(solved.result.converged) << "c = " << c << ": " << solved.result.failure;
    const double stretch = solved.shape().area - 4. * pi;
    EXPECT_NEAR(solved.sigma(), c * stretch, 1e-10 * c);
    EXPECT_LT(solved.sigma(), 0.);
    EXPECT_LT(std::abs(stretch), last);
    last = std::abs(stretch);
  }
  EXPECT_LT(last, 1e-5);
}
} // namespace

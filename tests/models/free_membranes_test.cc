// SPDX-License-Identifier: LGPL-2.1-or-later
// Open membranes with free rims: line tension, Gaussian modulus, and the flat disc that they make unstable.
#include "open_membranes.h"

#include <pellicle/models/edge_conditions.h>

#include <gtest/gtest.h>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

VesicleScene free_disc(const double C0, const double kappa_G, const double lambda, const OpenMesh &mesh)
{
  std::vector<std::string> effects{"helfrich bending", "area constraint", "line tension"};
  if (kappa_G != 0.)
    effects.push_back("gaussian curvature");
  VesicleScene scene                                                    = open_scene(effects, "disc", "free", mesh);
  scene.vesicle.area                                                    = pi;
  effect<HelfrichBendingEffect>(scene).parameters.spontaneous_curvature = C0;
  effect<LineTensionEffect>(scene).parameters.line_tension              = lambda;
  if (kappa_G != 0.)
    effect<GaussianCurvatureEffect>(scene).parameters.gaussian_modulus = kappa_G;
  return scene;
}

/** A membrane of area pi, kappa = 1, kappa_G = -1/2, with a free rim. Values: independent axisymmetric solution (shape
 * equations, spectral elements checked by shooting). The first is part of the sphere of radius 1, by hand: 1/R = 2
 * C0/(4 + 2 kappa_G/kappa) and sigma = 3/8. */
struct Dish
{
  double C0, lambda;
  double energy, bending, gaussian, line, tension;
  double rim_radius, rim_angle, height;
};
constexpr double kappa_G = -0.5;
constexpr Dish dishes[]  = {
     {1.5, 0., -1.178097245096, 0.392699081699, -1.570796326795, 0., 0.375, 0.8660254038, 1.0471975512, 0.5},
     {0.5, 1., 6.040365103185, 0.158493576452, -0.258395306190, 6.140266832923, -0.8994468973, 0.9772538184,
      0.4084181394, 0.2167872471},
     {0.5, 2., 12.123119924014, 0.582318324845, -0.457657467871, 11.998459067040, -1.7645501149, 0.9548070350,
      0.5465492541, 0.3112608838},
     {0.5, 2.8, 16.778660015889, 2.768324195601, -1.178731990719, 15.189067811007, -2.1069111902, 0.8633625797,
      0.8959235928, 0.5444254093},
};
constexpr double largest_lambda = 2.8498156946; // where the branch of the last three turns back

TEST(FreeMembranes, Dishes)
{
  for (const Dish &exact : dishes)
  {
    const std::string what = "C0 = " + std::to_string(exact.C0) + ", lambda = " + std::to_string(exact.lambda);
    const Solved solved(free_disc(exact.C0, kappa_G, exact.lambda, {"axial", 4, 3}));
    ASSERT_TRUE(solved.result.converged) << what << ": " << solved.result.failure;
    EXPECT_NEAR(solved.quantity("total_energy"), exact.energy, 1e-9) << what;
    EXPECT_NEAR(solved.quantity("bending_energy"), exact.bending, 1e-7) << what;
    EXPECT_NEAR(solved.quantity("gaussian_energy"), exact.gaussian, 1e-7) << what;
    EXPECT_NEAR(solved.quantity("line_tension_energy"), exact.line, 1e-7) << what;
    EXPECT_NEAR(solved.quantity("tension"), exact.tension, 1e-6) << what;
    EXPECT_NEAR(solved.quantity("height"), exact.height, 1e-7) << what;
    EXPECT_EQ(solved.negative_eigenvalues(), 0) << what;

    // Moments balance at the rim, |P| = kappa (c1 + c2 - C0) = -kappa_G c2, c2 = sin(psi)/r there.
    const EdgeLoop &rim    = loop_named(solved, "rim");
    const Scales &scales   = solved.model.scales();
    const NodalVectors &P  = solved.model.equilibrium().state().fields[1];
    const std::size_t node = rim.cell_nodes.front();
    const double r         = loop_length(rim, solved.positions()) * scales.length / (2. * pi);
    EXPECT_NEAR(r, exact.rim_radius, 1e-7) << what;
    EXPECT_NEAR(std::hypot(P[3 * node], P[3 * node + 2]) * scales.of(dimensions::line_tension),
                -kappa_G * std::sin(exact.rim_angle) / exact.rim_radius, 1e-6)
        << what;
  }
}

// In space a line tension is needed: a patch of the sphere of the first dish is in equilibrium whatever its outline.
TEST(FreeMembranes, DishesInSpace)
{
  struct Case
  {
    Dish exact;
    int refinements;
    double energy_tolerance, tolerance;
  };
  for (const Case &c : {Case{dishes[1], 0, 5e-6, 2e-4}, Case{dishes[1], 1, 1e-7, 1e-5}, Case{dishes[3], 0, 5e-4, 5e-3}})
  {
    const std::string what =
        "lambda = " + std::to_string(c.exact.lambda) + ", " + std::to_string(c.refinements) + " refinements";
    const Solved solved(free_disc(c.exact.C0, kappa_G, c.exact.lambda, {"none", 3, c.refinements}));
    ASSERT_TRUE(solved.result.converged) << what << ": " << solved.result.failure;
    EXPECT_NEAR(solved.quantity("total_energy"), c.exact.energy, c.energy_tolerance) << what;
    EXPECT_NEAR(solved.quantity("bending_energy"), c.exact.bending, c.tolerance) << what;
    EXPECT_NEAR(solved.quantity("gaussian_energy"), c.exact.gaussian, c.tolerance) << what;
    EXPECT_NEAR(solved.quantity("line_tension_energy"), c.exact.line, c.tolerance) << what;
    EXPECT_NEAR(solved.quantity("tension"), c.exact.tension, c.tolerance) << what;
    EXPECT_NEAR(solved.quantity("height"), c.exact.height, c.tolerance) << what;
    EXPECT_EQ(solved.negative_eigenvalues(), 0) << what;
  }
}

TEST(FreeMembranes, DishesOfOrderTwiceTheDegree)
{
  const Dish &exact = dishes[1];
  double error[2];
  for (const int i : {0, 1})
  {
    const Solved solved(free_disc(exact.C0, kappa_G, exact.lambda, {"axial", 2, 2 + i}));
    ASSERT_TRUE(solved.result.converged) << solved.result.failure;
    error[i] = std::abs(solved.quantity("total_energy") - exact.energy);
  }
  EXPECT_LT(error[1], 1e-6);
  EXPECT_NEAR(std::log2(error[0] / error[1]), 4., 0.5);
}

// A larger line tension closes the dish.
TEST(FreeMembranes, NoDishBeyondTheFold)
{
  const Solved below(free_disc(0.5, kappa_G, 0.997 * largest_lambda, {"axial", 4, 2})),
      above(free_disc(0.5, kappa_G, 1.01 * largest_lambda, {"axial", 4, 2}));
  EXPECT_TRUE(below.result.converged) << below.result.failure;
  EXPECT_EQ(below.negative_eigenvalues(), 0);
  EXPECT_FALSE(above.result.converged);
  EXPECT_FALSE(above.result.failure.empty());
}

/**
 * The line tension at which a flat disc of radius 1 buckles. It is under the tension -lambda/R. For a small deflection
 * w(r) with the slope f = w' the second variation is
 *
 *     pi [ kappa int (f' + f/r)^2 r dr + kappa_G f(R)^2 - (lambda/R) int f^2 r dr ],
 *
 * stationary for f = J1(x r/R) with x^2 = lambda R/kappa and kappa x J0(x) + kappa_G J1(x) = 0. The trial f = r, parts
 * of spheres, gives the upper bound lambda R = 4 (2 kappa + kappa_G). (Deflections that depend on the angle lengthen
 * the line as well.)
 */
double critical_line_tension(const double gaussian_modulus)
{
  double low = 1., high = 2.404825557695773; // the zero of J0
  for (int i = 0; i < 60; ++i)
  {
    const double x                                                                                 = 0.5 * (low + high);
    (x * std::cyl_bessel_j(0., x) + gaussian_modulus * std::cyl_bessel_j(1., x) > 0. ? low : high) = x;
  }
  return low * low;
}

TEST(FreeMembranes, FlatDiscUnderLineTension)
{
  struct Case
  {
    OpenMesh mesh;
    double kappa_G;
  };
  for (const Case &c : {Case{{"axial", 3, 2}, 0.}, Case{{"axial", 3, 2}, -0.5}, Case{{"axial", 3, 2}, -1.5},
                        Case{{"none", 3, 0}, 0.}, Case{{"none", 3, 0}, -0.5}})
  {
    const double critical  = critical_line_tension(c.kappa_G);
    const std::string what = std::string(c.mesh.symmetry) + ", kappa_G = " + std::to_string(c.kappa_G);
    EXPECT_LT(critical, 4. * (2. + c.kappa_G)) << what;
    for (const double factor : {0.99, 1.01})
    {
      const Solved disc(free_disc(0., c.kappa_G, factor * critical, c.mesh));
      ASSERT_TRUE(disc.result.converged) << what << ": " << disc.result.failure;
      EXPECT_NEAR(disc.quantity("height"), 0., 1e-9) << what;
      // The rim of a surface in space is a polynomial, on which kappa_G does not quite leave the moment zero.
      EXPECT_NEAR(disc.quantity("bending_energy"), 0., c.mesh.symmetry == std::string("axial") ? 1e-9 : 1e-6) << what;
      EXPECT_LT(relative_error(disc.quantity("line_tension_energy"), 2. * pi * factor * critical), 1e-5) << what;
      EXPECT_LT(relative_error(disc.quantity("tension"), -factor * critical), 1e-5) << what;
      EXPECT_EQ(disc.negative_eigenvalues(), factor < 1. ? 0 : 1) << what << ", " << factor << " of critical";
    }
  }
}

/** The problem of an open scene in the user's units, at its start shape. */
struct Problem
{
  explicit Problem(const VesicleScene &scene)
      : mesh(make_start_shape(scene.start_shape()))
  {
    SceneTargets targets         = scene.targets(Scales{});
    targets.euler_characteristic = 1;
    const PotentialSet set       = scene.potentials(Scales{}, targets);
    for (const NamedQuantity &constant : set.constants)
      constants += constant.value;
    problem =
        std::make_unique<SurfaceProblem>(mesh, set, edge_conditions(mesh, targets), communicator, "mumps", timing);
  }

  Communicator communicator;
  Timing timing;
  SurfaceDiscretization mesh;
  std::unique_ptr<SurfaceProblem> problem;
  double constants = 0.; ///< energies that no shape changes
};

// The first of the dishes as it is, in space: its energy is E(x) with the moment that the rim bears, -kappa_G c2.
TEST(FreeMembranes, EnergyOfASphericalDishInSpace)
{
  double error[2];
  for (const int i : {0, 1})
  {
    VesicleScene scene      = open_scene({"helfrich bending", "gaussian curvature"}, "cap", "free", {"none", 3, 1 + i});
    scene.vesicle.area      = pi;
    scene.vesicle.cap_angle = 60.;
    effect<HelfrichBendingEffect>(scene).parameters.spontaneous_curvature = dishes[0].C0;
    effect<GaussianCurvatureEffect>(scene).parameters.gaussian_modulus    = kappa_G;
    const Problem dish(scene);
    error[i] = std::abs(dish.problem->energy() + dish.constants - dishes[0].energy);
  }
  EXPECT_LT(error[1], 1e-7);
  EXPECT_GT(std::log2(error[0] / error[1]), 4.5);
}

// No energy knows where the surface is and how it is turned.
TEST(FreeMembranes, RigidMotions)
{
  VesicleScene scene = open_scene({"helfrich bending", "surface tension", "line tension", "gaussian curvature"}, "cap",
                                  "free", {"none", 3, 1});
  scene.vesicle.cap_angle                                               = 70.;
  effect<HelfrichBendingEffect>(scene).parameters.spontaneous_curvature = 0.4;
  Problem cap(scene);
  SurfaceProblem &problem            = *cap.problem;
  const SurfaceState before          = problem.state();
  const std::vector<double> at_first = problem.values().energies;

  const Vector3<double> axis(2. / 7., 3. / 7., 6. / 7.), shift(0.7, -3., 2.);
  const double angle = 1.1;
  SurfaceState state = before;
  for (std::size_t f = 0; f < state.fields.size(); ++f)
    for (std::size_t I = 0; I < cap.mesh.n_nodes; ++I)
    {
      const double *const v = before.fields[f].data() + 3 * I;
      const Vector3<double> x(v[0], v[1], v[2]);
      // Rodrigues' formula
      const Vector3<double> y =
          std::cos(angle) * x + std::sin(angle) * cross(axis, x) + ((1. - std::cos(angle)) * dot(axis, x)) * axis;
      for (unsigned int c = 0; c < 3; ++c)
        state.fields[f][3 * I + c] = y[c] + (f == 0 ? shift[c] : 0.);
    }
  problem.set_state(state);
  for (std::size_t k = 0; k < at_first.size(); ++k)
    EXPECT_NEAR(problem.values().energies[k], at_first[k], 1e-10) << problem.potentials().energies[k]->name();
}

TEST(FreeMembranes, ClosedSurfacesHaveAConstantGaussianEnergy)
{
  constexpr double modulus = -0.7;
  for (const auto &[shape, symmetry, integral] :
       {std::tuple{"prolate", "axial", 4. * pi}, std::tuple{"prolate", "none", 4. * pi},
        std::tuple{"torus", "none", 0.}})
  {
    VesicleScene plain = vesicle(shape, 0.7, 3, 1, symmetry),
                 scene = scene_with({"helfrich bending", "gaussian curvature", "area constraint", "volume constraint"});
    if (symmetry == std::string("axial"))
      plain.mesh.refinements = 3;
    scene.vesicle                                                      = plain.vesicle;
    scene.mesh                                                         = plain.mesh;
    effect<GaussianCurvatureEffect>(scene).parameters.gaussian_modulus = modulus;
    if (shape == std::string("torus"))
    {
      Communicator communicator;
      Timing timing;
      const SurfaceModel model(scene, communicator, timing);
      EXPECT_EQ(quantity(model, "gaussian_energy"), 0.);
      continue;
    }
    const Solved without(plain), with(scene);
    ASSERT_TRUE(without.result.converged && with.result.converged) << symmetry;
    EXPECT_LT(relative_error(with.quantity("gaussian_energy"), integral * modulus), 1e-14) << symmetry;
    EXPECT_LT(relative_error(with.quantity("total_energy"), without.quantity("total_energy") + integral * modulus),
              1e-12)
        << symmetry;
    EXPECT_NEAR(with.quantity("tension"), without.quantity("tension"), 1e-9) << symmetry;
  }
}
} // namespace

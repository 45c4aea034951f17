// SPDX-License-Identifier: LGPL-2.1-or-later
// Elastic skins through the solver: balloons under pressure, and deflated capsules.
#include "equilibrium_runs.h"

#include <pellicle/potentials/energies/incompressible_rubber_skin.h>
#include <pellicle/potentials/energies/neo_hookean_skin.h>
#include <pellicle/potentials/energies/skalak_skin.h>
#include <pellicle/potentials/energies/tu_ou_yang_skin.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

/** A sphere of reference radius R stretched by l: energy W(l) per reference area and pressure p(l)/R, by hand from the
 * principal stretches, moduli 1. p = dW/dl / l^2, for the work P 4 pi R^2 l^2 R dl is 4 pi R^2 dW. */
struct Law
{
  const char *name;
  std::function<double(double l)> energy, pressure;
};
const std::vector<Law> laws = {
    {"neo-hookean skin", [](const double l) { return l * l - 1. - 2. * std::log(l); },
     [](const double l) { return 2. * (1. / l - std::pow(l, -3)); }},
    {"incompressible rubber skin", [](const double l) { return l * l + 0.5 * std::pow(l, -4) - 1.5; },
     [](const double l) { return 2. * (1. / l - std::pow(l, -7)); }},
    {"skalak skin",
     [](const double l)
     {
       const double l2 = l * l, I1 = 2. * l2 - 2., I2 = l2 * l2 - 1.;
       return 0.25 * (I1 * I1 + 2. * I1 - 2. * I2 + I2 * I2);
     },
     [](const double l) { return 2. * ((l * l - 1.) + l * l * (std::pow(l, 4) - 1.)) / l; }},
    {"tu-ou-yang skin", [](const double l) { return std::pow(l * l - 1., 2) / (4. * 0.7); },
     [](const double l) { return (l * l - 1.) / (0.7 * l); }},
};
/** "skalak skin" -> "skalak_skin_energy". */
std::string energy_of(const Law &law)
{
  std::string name = law.name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name + "_energy";
}

const Law &neo_hookean = laws[0], &skalak = laws[2];

struct Mesh
{
  const char *symmetry;
  int degree, refinements;
  double tolerance; ///< of lengths
};
constexpr Mesh meridian{"axial", 4, 3, 1e-9}, surface{"none", 3, 2, 2e-5};

VesicleScene scene_on(const Mesh &mesh, const std::vector<std::string> &effects, const std::string &start_shape)
{
  VesicleScene scene        = scene_with(effects);
  scene.vesicle.start_shape = start_shape;
  scene.mesh.degree         = mesh.degree;
  scene.mesh.refinements    = mesh.refinements;
  scene.mesh.symmetry       = mesh.symmetry;
  return scene;
}

/** A skin without stress on a sphere of radius 1, under pressure. */
VesicleScene balloon(const Mesh &mesh, const std::string &skin, const double pressure)
{
  VesicleScene scene                                = scene_on(mesh, {skin, "pressure"}, "ellipsoid");
  scene.vesicle.semi_axes                           = {1., 1., 1.};
  effect<PressureEffect>(scene).parameters.pressure = pressure;
  return scene;
}

void expect_sphere(const Solved &solved, const double radius, const double tolerance, const std::string &what)
{
  EXPECT_NEAR(0.5 * solved.quantity("height") / radius, 1., tolerance) << what;
  EXPECT_NEAR(solved.quantity("equatorial_radius") / radius, 1., tolerance) << what;
  EXPECT_NEAR(solved.quantity("volume") / (4. * pi / 3. * std::pow(radius, 3)), 1., 3. * tolerance) << what;
}

// Also without pressure, where there are no forces at all that a residual could be compared with.
TEST(Skins, BalloonsByPressure)
{
  for (const Mesh &mesh : {meridian, surface})
    for (const Law &law : laws)
      for (const double l : {1., 1.05, 1.3})
      {
        const std::string what = law.name + std::string(" ") + mesh.symmetry + " l = " + std::to_string(l);
        const Solved solved(balloon(mesh, law.name, law.pressure(l)));
        ASSERT_TRUE(solved.result.converged) << what << ": " << solved.result.failure;
        expect_sphere(solved, l, mesh.tolerance, what);
        const double sensitivity = 4. * pi * l * l * l * law.pressure(l); // of the energy to l
        EXPECT_NEAR(solved.quantity(energy_of(law)), 4. * pi * law.energy(l), sensitivity * mesh.tolerance + 1e-12)
            << what;
        EXPECT_EQ(solved.negative_eigenvalues(), 0) << what;
      }
}

// The highest pressure is 4 mu/(3 sqrt(3) R) = 0.7698, at l = sqrt(3).
TEST(Skins, NoBalloonBeyondTheHighestPressure)
{
  const double highest = 4. / (3. * std::sqrt(3.));
  for (const Mesh &mesh : {meridian, Mesh{"none", 2, 1, 0.}})
  {
    const Solved below(balloon(mesh, neo_hookean.name, 0.98 * highest));
    EXPECT_TRUE(below.result.converged) << mesh.symmetry << ": " << below.result.failure;
    EXPECT_LT(0.5 * below.quantity("height"), std::sqrt(3.)) << mesh.symmetry;
    const Solved above(balloon(mesh, neo_hookean.name, 1.02 * highest));
    EXPECT_FALSE(above.result.converged) << mesh.symmetry;
    EXPECT_NE(above.result.failure.find("Newton/Maximum iterations"), std::string::npos) << above.result.failure;
  }
}

// Started from an ellipsoid of area 4 pi, the skin becomes the sphere that its reference, of another size, is blown up
// to.
TEST(Skins, ReferenceShapeIsNotTheStartShape)
{
  constexpr double R = 0.8;
  for (const Mesh &mesh : {meridian, surface})
    for (const double l : {1., 1.4})
    {
      VesicleScene scene            = balloon(mesh, skalak.name, skalak.pressure(l) / R);
      scene.vesicle.semi_axes       = {1., 1., 1.3};
      scene.vesicle.reference_shape = "sphere";
      scene.vesicle.reference_area  = 4. * pi * R * R;
      const Solved solved(scene);
      const std::string what = std::string(mesh.symmetry) + " l = " + std::to_string(l);
      ASSERT_TRUE(solved.result.converged) << what << ": " << solved.result.failure;
      expect_sphere(solved, l * R, mesh.tolerance, what);
      EXPECT_NEAR(solved.quantity("skalak_skin_energy"), 4. * pi * R * R * skalak.energy(l), 30. * mesh.tolerance)
          << what;
    }
}

/** A capsule: Skalak skin with G = 10 and the given C, stress free on the sphere of area 4 pi, bending with kappa = 1,
 * less volume than the sphere. */
VesicleScene capsule(const Mesh &mesh, const std::string &start_shape, const double reduced_volume, const double C)
{
  VesicleScene scene            = scene_on(mesh, {"helfrich bending", "skalak skin", "volume constraint"}, start_shape);
  scene.vesicle.reduced_volume  = reduced_volume;
  scene.vesicle.reference_shape = "sphere";
  effect<SkinEffect<SkalakSkin>>(scene).law = {10., C};
  return scene;
}

// A skin of small C is rather compressed than bent.
TEST(Skins, CapsuleStaysASphere)
{
  constexpr double v = 0.95;
  const double l     = std::cbrt(v);
  for (const std::string start : {"prolate", "oblate"})
  {
    const Solved solved(capsule(meridian, start, v, 1.));
    ASSERT_TRUE(solved.result.converged) << start << ": " << solved.result.failure;
    expect_sphere(solved, l, 1e-8, start);
    EXPECT_NEAR(solved.quantity("skalak_skin_energy"), 10. * 4. * pi * skalak.energy(l), 1e-7) << start;
    EXPECT_NEAR(solved.quantity("bending_energy"), 8. * pi, 1e-7) << start;
    EXPECT_NEAR(solved.quantity("pressure"), 10. * skalak.pressure(l), 1e-7) << start;
    EXPECT_EQ(solved.negative_eigenvalues(), 0) << start;
  }
}

/** The problem of a scene in the user's units, at its start shape. */
struct Problem
{
  explicit Problem(const VesicleScene &scene)
      : mesh(make_start_shape(scene.start_shape()))
  {
    SceneTargets targets = scene.targets(Scales{});
    targets.reference    = std::make_shared<const std::vector<ReferenceMetric>>(
        reference_metric(mesh, make_start_shape(*scene.reference_shape()).positions));
    problem = std::make_unique<SurfaceProblem>(mesh, scene.potentials(Scales{}, targets), NodalConditions{},
                                               communicator, "mumps", timing);
  }
  /** Energies and volume with the nodes elsewhere. */
  TermValues at(const NodalVectors &positions)
  {
    SurfaceState state = problem->state();
    state.fields[0]    = positions;
    problem->set_state(state);
    return problem->values();
  }

  Communicator communicator;
  Timing timing;
  SurfaceDiscretization mesh;
  std::unique_ptr<SurfaceProblem> problem;
};

// One of large C buckles, which costs less than compression. Its forces do no work under a change of size:
// dE/dl = 3 P V, of the discrete equilibrium as well.
TEST(Skins, CapsuleBuckles)
{
  constexpr double v = 0.9, C = 10.;
  const double l = std::cbrt(v), I1 = 2. * l * l - 2., I2 = std::pow(l, 4) - 1.;
  const double energy_of_sphere = 8. * pi + 10. * pi * (I1 * I1 + 2. * I1 - 2. * I2 + C * I2 * I2);
  double total[2], thickness[2];
  for (const int i : {0, 1})
  {
    const Mesh mesh = i == 0 ? meridian : surface;
    const Solved solved(capsule(mesh, "oblate", v, C));
    ASSERT_TRUE(solved.result.converged) << mesh.symmetry << ": " << solved.result.failure;
    total[i]     = solved.quantity("total_energy");
    thickness[i] = solved.quantity("height");
    EXPECT_LT(total[i], energy_of_sphere - 0.1) << mesh.symmetry;
    EXPECT_GT(solved.quantity("skalak_skin_energy"), 0.);
    EXPECT_LT(thickness[i], 1.9 * l) << mesh.symmetry;
    EXPECT_NEAR(solved.quantity("volume") / (4. * pi / 3.), v, 1e-9) << mesh.symmetry;

    constexpr double step = 1e-4;
    Problem problem(capsule(mesh, "oblate", v, C));
    double energy[2];
    for (const int sign : {0, 1})
    {
      NodalVectors scaled_positions = solved.positions();
      for (double &x : scaled_positions)
        x *= sign == 0 ? 1. - step : 1. + step;
      const TermValues values = problem.at(scaled_positions);
      energy[sign]            = values.energies[0] + values.energies[1];
    }
    const double work = 3. * solved.quantity("pressure") * solved.quantity("volume");
    EXPECT_LT(relative_error((energy[1] - energy[0]) / (2. * step), work), 1e-6) << mesh.symmetry;
  }
  EXPECT_LT(relative_error(total[1], total[0]), 1e-5);
  EXPECT_LT(relative_error(thickness[1], thickness[0]), 1e-3);
}

// Neither skin nor bending nor volume knows where the surface is and how it is turned.
TEST(Skins, RigidMotions)
{
  Problem problem(capsule({"none", 3, 1, 0.}, "stomatocyte", 0.6, 2.));
  const TermValues here = problem.at(problem.mesh.positions);
  EXPECT_GT(here.energies[0], 8. * pi);
  EXPECT_GT(here.energies[1], 0.1);
  const Vector3<double> axis(2. / 7., 3. / 7., 6. / 7.), shift(0.7, -3., 2.);
  const double angle = 1.1;
  NodalVectors moved = problem.mesh.positions;
  for (std::size_t I = 0; I < problem.mesh.n_nodes; ++I)
  {
    const Vector3<double> x(moved[3 * I], moved[3 * I + 1], moved[3 * I + 2]);
    // Rodrigues' formula
    const Vector3<double> y =
        std::cos(angle) * x + std::sin(angle) * cross(axis, x) + ((1. - std::cos(angle)) * dot(axis, x)) * axis + shift;
    for (unsigned int c = 0; c < 3; ++c)
      moved[3 * I + c] = y[c];
  }
  const TermValues there = problem.at(moved);
  for (std::size_t k = 0; k < 2; ++k)
    EXPECT_LT(relative_error(there.energies[k], here.energies[k]), 1e-11) << k;
  EXPECT_LT(relative_error(there.constraints[0], here.constraints[0]), 1e-11);
}
} // namespace

// SPDX-License-Identifier: LGPL-2.1-or-later
// Directors on a membrane with a domain of other moduli around its north pole.
#include "equilibrium_runs.h"
#include "expect_user_error.h"

#include <pellicle/models/director_scene.h>
#include <pellicle/potentials/constraints/lipid_domain.h>
#include <pellicle/potentials/director/director_effect.h>
#include <pellicle/potentials/edges/line_tension.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Mesh
{
  const char *symmetry;
  int degree, refinements;
};

DirectorScene scene_of(const std::vector<std::string> &effects)
{
  DirectorScene scene;
  list_effects(scene, director_effects(), effects, {});
  return scene;
}

/** Moduli of the membrane and of the domain. */
struct Moduli
{
  double k_t, K;
  double k_t_domain, K_domain;
};

void set_moduli(DirectorScene &scene, const Moduli &moduli)
{
  DirectorParameters &law = effect<DirectorEffect>(scene).parameters;
  law.tilt_modulus        = moduli.k_t;
  law.bending_modulus     = moduli.K;
  law.domain_tilt         = std::isinf(moduli.k_t) ? 1. : moduli.k_t_domain / moduli.k_t;
  law.domain_bending      = moduli.K_domain / moduli.K;
}

/** The unit sphere. */
DirectorScene held_sphere(const Moduli &moduli, const double area_fraction, const Mesh &mesh)
{
  DirectorScene scene                                       = scene_of({"director", "lipid domain"});
  scene.vesicle.start_shape                                 = "ellipsoid";
  scene.vesicle.semi_axes                                   = {1., 1., 1.};
  scene.carrier.motion                                      = "held";
  scene.mesh.symmetry                                       = mesh.symmetry;
  scene.mesh.degree                                         = mesh.degree;
  scene.mesh.refinements                                    = mesh.refinements;
  effect<LipidDomainEffect>(scene).parameters.area_fraction = area_fraction;
  set_moduli(scene, moduli);
  return scene;
}

// Normal directors, with which the models start: K/R^2 per area on either side, and the jump of the null term times the
// solid angle of the domain.
TEST(DirectorDomain, NormalDirectorsOnTheSphere)
{
  constexpr double f = 0.3, K = 2., K_domain = 5.;
  for (const Mesh mesh : {Mesh{"axial", 4, 3}, Mesh{"none", 3, 1}})
  {
    Communicator communicator;
    Timing timing;
    const SurfaceModel model(held_sphere({infinity, K, infinity, K_domain}, f, mesh), communicator, timing);
    const double tolerance = mesh.degree == 4 ? 2e-6 : 3e-3; // the normals at the nodes are those of the mesh
    EXPECT_LT(relative_error(quantity(model, "director_gradient_energy"), 4. * pi * (K + f * (K_domain - K))),
              tolerance);
    EXPECT_LT(relative_error(quantity(model, "domain_null_lagrangian_energy"), 4. * pi * f * (K_domain - K)),
              tolerance);
    EXPECT_LT(relative_error(quantity(model, "null_lagrangian_energy"), 4. * pi * K), tolerance);
  }
}

// They are no equilibrium: the moments of the two sides differ, and tilt balances them in a layer of width sqrt(K/k_t),
// with k_t = inf of a cell.
TEST(DirectorDomain, LayerAtTheLineOfAHeldSphere)
{
  constexpr double K = 2., K_domain = 5., f = 0.3, normal = 4. * pi * (K + 2. * f * (K_domain - K));
  double previous = 0.;
  for (const int refinements : {2, 3, 4})
  {
    const Solved solved(held_sphere({infinity, K, infinity, K_domain}, f, {"axial", 4, refinements}));
    ASSERT_TRUE(solved.result.converged) << solved.result.failure;
    const double gain = normal - solved.quantity("total_energy");
    EXPECT_GT(gain, 0.);
    if (refinements > 2)
    {
      EXPECT_NEAR(previous / gain, 2., 0.1);
    }
    previous = gain;
  }
}

/** Least energies on the unit sphere with directors in the meridian plane, from an independent axisymmetric solution
 * (the angle of the directors by spectral elements of degree 14 and 18, which agree in all digits). */
struct Held
{
  Moduli moduli;
  double area_fraction, tilt, gradient, null;
};
constexpr Held stiff_domain = {{1., 1., 10., 3.}, 0.15, 1.296824731876, 13.819066703152, 0.656280801698};
constexpr Held same_tilt    = {{1., 1., 1., 3.}, 0.15, 0.765565306560, 13.694108073666, 0.333386657089};
constexpr Held soft_domain  = {{20., 1., 2., 0.5}, 0.3, 0.309855327650, 10.393289877746, -2.470033542023};

void expect_held(const Held &exact, const Mesh &mesh, const double tolerance, const std::string &shear = "mixed")
{
  SCOPED_TRACE(std::string(mesh.symmetry) + ", K of the domain " + std::to_string(exact.moduli.K_domain) +
               ", k_t of the domain " + std::to_string(exact.moduli.k_t_domain) + ", " + shear);
  DirectorScene scene                            = held_sphere(exact.moduli, exact.area_fraction, mesh);
  effect<DirectorEffect>(scene).parameters.shear = shear;
  const Solved solved(scene);
  ASSERT_TRUE(solved.result.converged) << solved.result.failure;
  const double total = exact.tilt + exact.gradient + exact.null;
  EXPECT_LT(relative_error(solved.quantity("total_energy"), total), tolerance);
  // Of first order in the error of the solution.
  EXPECT_NEAR(solved.quantity("tilt_energy"), exact.tilt, 10. * tolerance * total);
  EXPECT_NEAR(solved.quantity("director_gradient_energy"), exact.gradient, 10. * tolerance * total);
  EXPECT_NEAR(solved.quantity("domain_null_lagrangian_energy"), exact.null, 10. * tolerance * total);
}

TEST(DirectorDomain, HeldSphere)
{
  for (const Held &exact : {stiff_domain, same_tilt, soft_domain})
  {
    expect_held(exact, {"axial", 4, 3}, 1e-9);
    expect_held(exact, {"axial", 4, 3}, 1e-9, "direct");
  }
}

TEST(DirectorDomain, HeldSphereInSpace)
{
  expect_held(stiff_domain, {"none", 3, 0}, 1e-5);
  expect_held(soft_domain, {"none", 3, 1}, 4e-6);
}

/** A vesicle of area 4 pi and reduced volume 0.9 with a domain and a line tension of 1. */
template <typename Scene>
Scene vesicle_with_domain(Scene scene, const Mesh &mesh)
{
  scene.vesicle.start_shape                                 = "prolate";
  scene.vesicle.reduced_volume                              = 0.9;
  scene.mesh.symmetry                                       = mesh.symmetry;
  scene.mesh.degree                                         = mesh.degree;
  scene.mesh.refinements                                    = mesh.refinements;
  effect<LipidDomainEffect>(scene).parameters.area_fraction = 0.15;
  effect<LineTensionEffect>(scene).parameters.line_tension  = 1.;
  return scene;
}

DirectorScene director_vesicle(const Moduli &moduli, const Mesh &mesh, const std::string &shear = "mixed")
{
  DirectorScene scene = vesicle_with_domain(
      scene_of({"director", "lipid domain", "line tension", "area constraint", "volume constraint"}), mesh);
  set_moduli(scene, moduli);
  effect<DirectorEffect>(scene).parameters.shear = shear;
  return scene;
}

// In the limit of normal directors the model is that of Helfrich, with one Gaussian modulus on both sides.
TEST(DirectorDomain, NormalDirectorsAreTheHelfrichModel)
{
  constexpr double K = 1., K_domain = 2.5;
  const Mesh mesh{"axial", 4, 3};
  VesicleScene helfrich = vesicle_with_domain(
      scene_with({"helfrich bending", "lipid domain", "line tension", "area constraint", "volume constraint"}), mesh);
  effect<LipidDomainEffect>(helfrich).parameters.bending_rigidity = K_domain;
  const Solved exact(helfrich);
  ASSERT_TRUE(exact.result.converged) << exact.result.failure;

  const Solved solved(director_vesicle({infinity, K, infinity, K_domain}, mesh));
  ASSERT_TRUE(solved.result.converged) << solved.result.failure;
  // (K/2)|grad O|^2 is (K/2)(2H)^2 without K K_G, of which the jump at the line is there.
  EXPECT_LT(relative_error(solved.quantity("total_energy") + 4. * pi * K, exact.quantity("total_energy")), 1e-9);
  EXPECT_NEAR(solved.quantity("domain_boundary_length"), exact.quantity("domain_boundary_length"), 1e-5);
  EXPECT_NEAR(solved.quantity("height"), exact.quantity("height"), 1e-5);
  for (const char *force : {"pressure", "tension", "domain_tension"})
    EXPECT_NEAR(solved.quantity(force), exact.quantity(force), 1e-4) << force;
}

// The surface has a kink at the line, for the line tension pulls along n as well and the tilt bears it. The two forms
// of the shear are different discretisations, and agree.
TEST(DirectorDomain, ShearJumpsAtTheLineOfAVesicle)
{
  for (const Moduli &moduli : {Moduli{40., 1., 40., 2.}, {40., 1., 200., 2.}})
  {
    SCOPED_TRACE("k_t of the domain " + std::to_string(moduli.k_t_domain));
    const Mesh mesh{"axial", 3, 4};
    const Solved mixed(director_vesicle(moduli, mesh)), direct(director_vesicle(moduli, mesh, "direct"));
    ASSERT_TRUE(mixed.result.converged && direct.result.converged);
    EXPECT_LT(relative_error(mixed.quantity("total_energy"), direct.quantity("total_energy")), 1e-10);
    EXPECT_NEAR(mixed.quantity("tilt_energy"), direct.quantity("tilt_energy"), 1e-7);
    EXPECT_NEAR(mixed.quantity("domain_boundary_length"), direct.quantity("domain_boundary_length"), 1e-6);
    EXPECT_NEAR(mixed.quantity("domain_tension"), direct.quantity("domain_tension"), 1e-5);

    const Solved in_space(director_vesicle(moduli, {"none", 3, 0}));
    ASSERT_TRUE(in_space.result.converged) << in_space.result.failure;
    EXPECT_LT(relative_error(in_space.quantity("total_energy"), mixed.quantity("total_energy")), 1e-4);
    EXPECT_NEAR(in_space.quantity("domain_boundary_length"), mixed.quantity("domain_boundary_length"), 1e-2);
  }
}

TEST(DirectorDomain, WhatIsRefused)
{
  DirectorScene scene                                     = scene_of({"director"});
  scene.carrier.motion                                    = "held";
  effect<DirectorEffect>(scene).parameters.domain_bending = 3.;
  EXPECT_USER_ERROR(scene.check(), "Domain bending ratio = 3", "lipid domain");

  DirectorScene listed                                          = held_sphere({1., 1., 1., 1.}, 0.2, {"axial", 3, 2});
  effect<LipidDomainEffect>(listed).parameters.bending_rigidity = 3.;
  EXPECT_USER_ERROR(listed.check(), "Lipid domain/Bending rigidity", "Domain bending ratio");
  effect<LipidDomainEffect>(listed).parameters.bending_rigidity = 1.;
  listed.carrier.shape                                          = "inclusion";
  EXPECT_USER_ERROR(listed.check(), "Surface/Shape", "vesicle");
}
} // namespace

// SPDX-License-Identifier: LGPL-2.1-or-later
// Directors on a membrane with a domain of other moduli around its north pole.
#include "equilibrium_runs.h"
#include "expect_user_error.h"

#include <pellicle/models/director_scene.h>
#include <pellicle/potentials/constraints/lipid_domain.h>
#include <pellicle/potentials/director/director_effect.h>
#include <pellicle/potentials/edges/gaussian_curvature.h>
#include <pellicle/potentials/edges/line_tension.h>

#include <gtest/gtest.h>

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

DirectorScene scene_of(const std::vector<std::string> &effects, const Mesh &mesh, const double area_fraction)
{
  DirectorScene scene;
  list_effects(scene, director_effects(), effects, {});
  scene.mesh.symmetry                                       = mesh.symmetry;
  scene.mesh.degree                                         = mesh.degree;
  scene.mesh.refinements                                    = mesh.refinements;
  effect<LipidDomainEffect>(scene).parameters.area_fraction = area_fraction;
  return scene;
}

/** Moduli of the membrane and of the domain. */
struct Moduli
{
  double k_t, K;
  double k_t_domain, K_domain;
};

/** The unit sphere. */
DirectorScene held_sphere(const Moduli &moduli, const double area_fraction, const Mesh &mesh)
{
  DirectorScene scene              = scene_of({"director", "lipid domain"}, mesh, area_fraction);
  scene.vesicle.start_shape        = "ellipsoid";
  scene.vesicle.semi_axes          = {1., 1., 1.};
  scene.carrier.motion             = "held";
  DirectorParameters &law          = effect<DirectorEffect>(scene).parameters;
  law.tilt_modulus                 = moduli.k_t;
  law.bending_modulus              = moduli.K;
  law.domain_tilt                  = std::isinf(moduli.k_t) ? 1. : moduli.k_t_domain / moduli.k_t;
  law.domain_bending               = moduli.K_domain / moduli.K;
  return scene;
}

// Normal directors: K/R^2 per area on either side, and the jump of the null term times the solid angle of the domain.
TEST(DirectorDomain, NormalDirectorsOnTheHeldSphere)
{
  constexpr double f = 0.3, K = 2., K_domain = 5.;
  for (const Mesh mesh : {Mesh{"axial", 4, 3}, Mesh{"none", 3, 0}})
  {
    const Solved solved(held_sphere({infinity, K, infinity, K_domain}, f, mesh));
    ASSERT_TRUE(solved.result.converged) << solved.result.failure;
    const double tolerance = mesh.degree == 4 ? 1e-9 : 2e-4;
    EXPECT_LT(relative_error(solved.quantity("director_gradient_energy"), 4. * pi * (K + f * (K_domain - K))), tolerance);
    EXPECT_LT(relative_error(solved.quantity("domain_null_lagrangian_energy"), 4. * pi * f * (K_domain - K)), tolerance);
    EXPECT_LT(relative_error(solved.quantity("null_lagrangian_energy"), 4. * pi * K), tolerance);
  }
}

/** Least energies on the unit sphere with directors in the meridian plane, from an independent axisymmetric solution
 * (the angle of the directors by spectral elements of degree 14 and 18, which agree in all digits). */
struct Held
{
  Moduli moduli;
  double area_fraction, tilt, gradient, null;
};
constexpr Held stiff_domain   = {{1., 1., 10., 3.}, 0.15, 1.296824731876, 13.819066703152, 0.656280801698};
constexpr Held same_tilt      = {{1., 1., 1., 3.}, 0.15, 0.765565306560, 13.694108073666, 0.333386657089};
constexpr Held soft_domain    = {{20., 1., 2., 0.5}, 0.3, 0.309855327650, 10.393289877746, -2.470033542023};

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
  EXPECT_NEAR(solved.quantity("tilt_energy"), exact.tilt, tolerance * total);
  EXPECT_NEAR(solved.quantity("director_gradient_energy"), exact.gradient, tolerance * total);
  EXPECT_NEAR(solved.quantity("domain_null_lagrangian_energy"), exact.null, tolerance * total);
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
  expect_held(stiff_domain, {"none", 3, 0}, 1e-4);
  expect_held(soft_domain, {"none", 3, 0}, 1e-4);
}

/** A vesicle with a domain and line tension; `effects` hold its bending energy. */
template <typename Scene>
void make_vesicle(Scene &scene, const Mesh &mesh)
{
  scene.vesicle.start_shape                                 = "prolate";
  scene.vesicle.reduced_volume                              = 0.9;
  scene.mesh.symmetry                                       = mesh.symmetry;
  scene.mesh.degree                                         = mesh.degree;
  scene.mesh.refinements                                    = mesh.refinements;
  effect<LipidDomainEffect>(scene).parameters.area_fraction = 0.15;
  effect<LineTensionEffect>(scene).parameters.line_tension  = 1.;
}

// In the limit of normal directors the model is that of Helfrich, with one Gaussian modulus on both sides.
TEST(DirectorDomain, NormalDirectorsAreTheHelfrichModel)
{
  constexpr double K = 1., K_domain = 2.5;
  const std::vector<std::string> common{"lipid domain", "line tension", "area constraint", "volume constraint"};
  std::vector<std::string> of_helfrich{"helfrich bending"}, of_directors{"director"};
  of_helfrich.insert(of_helfrich.end(), common.begin(), common.end());
  of_directors.insert(of_directors.end(), common.begin(), common.end());
  const Mesh mesh{"axial", 4, 3};

  VesicleScene helfrich = scene_with(of_helfrich);
  make_vesicle(helfrich, mesh);
  effect<LipidDomainEffect>(helfrich).parameters.bending_rigidity = K_domain;
  const Solved exact(helfrich);
  ASSERT_TRUE(exact.result.converged) << exact.result.failure;

  const auto compare = [&](const double k_t, const double tolerance)
  {
    SCOPED_TRACE("k_t = " + std::to_string(k_t));
    DirectorScene scene = scene_of(of_directors, mesh, 0.15);
    make_vesicle(scene, mesh);
    DirectorParameters &law = effect<DirectorEffect>(scene).parameters;
    law.tilt_modulus        = k_t;
    law.bending_modulus     = K;
    law.domain_bending      = K_domain / K;
    law.domain_tilt         = 2.;
    const Solved solved(scene);
    ASSERT_TRUE(solved.result.converged) << solved.result.failure;
    // (K/2)|grad O|^2 is (K/2)(2H)^2 without K K_G, of which the jump at the line is there.
    EXPECT_LT(relative_error(solved.quantity("total_energy") + 4. * pi * K, exact.quantity("total_energy")), tolerance);
    EXPECT_NEAR(solved.quantity("domain_boundary_length"), exact.quantity("domain_boundary_length"), 10. * tolerance);
    EXPECT_NEAR(solved.quantity("height"), exact.quantity("height"), 10. * tolerance);
    EXPECT_NEAR(solved.quantity("pressure"), exact.quantity("pressure"), 1e3 * tolerance);
    EXPECT_NEAR(solved.quantity("domain_tension"), exact.quantity("domain_tension"), 1e3 * tolerance);
  };
  compare(infinity, 1e-6);
  compare(1e4, 1e-2);
}

TEST(DirectorDomain, WhatIsRefused)
{
  DirectorScene scene;
  list_effects(scene, director_effects(), {"director"}, {});
  scene.carrier.motion                                    = "held";
  effect<DirectorEffect>(scene).parameters.domain_bending = 3.;
  EXPECT_USER_ERROR(scene.check(), "Domain bending ratio = 3", "lipid domain");

  DirectorScene listed = held_sphere({1., 1., 1., 1.}, 0.2, {"axial", 3, 2});
  effect<LipidDomainEffect>(listed).parameters.bending_rigidity = 3.;
  EXPECT_USER_ERROR(listed.check(), "Lipid domain/Bending rigidity", "Director/Domain bending ratio");
  effect<LipidDomainEffect>(listed).parameters.bending_rigidity = 1.;
  listed.carrier.shape                                          = "inclusion";
  EXPECT_USER_ERROR(listed.check(), "Surface/Shape", "vesicle");
}
} // namespace

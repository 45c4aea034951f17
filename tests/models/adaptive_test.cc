// SPDX-License-Identifier: LGPL-2.1-or-later
// Where a solution is local, meshes that follow it need fewer unknowns for the same error.
#include "adaptive_runs.h"

#include <pellicle/potentials/constraints/lipid_domain.h>
#include <pellicle/potentials/constraints/tether.h>

#include <gtest/gtest.h>

#include <iomanip>
#include <iostream>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

void print(const char *name, const std::vector<MeshResult> &levels, const double exact)
{
  std::cout << name << "\n";
  for (const MeshResult &level : levels)
    std::cout << std::setw(8) << level.cells << std::setw(8) << level.unknowns << std::scientific
              << std::setprecision(3) << std::setw(14) << relative_error(level.energy, exact) << std::fixed
              << std::setprecision(12) << std::setw(20) << level.energy << std::endl;
}

/** Bending energy of a spheroid whose axis along z is 1/10 of the others: all of it is at the rim. */
SceneAlongLoad flat_spheroid(const std::string &symmetry, const int degree, const int refinements)
{
  return [=](const double)
  {
    VesicleScene scene        = scene_with({"helfrich bending"});
    scene.vesicle.start_shape = "ellipsoid";
    scene.vesicle.semi_axes   = {1., 1., 0.1};
    scene.mesh.symmetry       = symmetry;
    scene.mesh.degree         = degree;
    scene.mesh.refinements    = refinements;
    return std::make_unique<VesicleScene>(std::move(scene));
  };
}

/** Independent solution of the pull to length 25: see tether_test.cc. */
SceneAlongLoad tether(const int degree, const int refinements)
{
  return [=](const double t)
  {
    VesicleScene scene     = scene_with({"helfrich bending", "tether"});
    scene.mesh.degree      = degree;
    scene.mesh.refinements = refinements;
    scene.mesh.symmetry    = "axial";
    TetherParameters &pull = effect<TetherEffect>(scene).parameters;
    pull.length            = 25. * t;
    pull.ring_radius       = 20.;
    pull.tip_radius        = 0.2;
    pull.tension           = 0.5;
    return std::make_unique<VesicleScene>(std::move(scene));
  };
}

SceneAlongLoad bud(const int degree, const int refinements, const double C0)
{
  return [=](const double t)
  {
    VesicleScene scene           = scene_with({"helfrich bending", "lipid domain", "line tension", "area constraint"});
    scene.mesh.degree            = degree;
    scene.mesh.refinements       = refinements;
    scene.mesh.symmetry          = "axial";
    scene.vesicle.start_shape    = "ellipsoid";
    scene.vesicle.semi_axes      = {1., 1., 1.02};
    auto &domain                 = effect<LipidDomainEffect>(scene).parameters;
    domain.area_fraction         = 0.1;
    domain.bending_rigidity      = 1.;
    domain.spontaneous_curvature = C0 * t;
    return std::make_unique<VesicleScene>(std::move(scene));
  };
}

void compare(const char *name, const std::function<SceneAlongLoad(int degree, int refinements)> &scene, int degree,
             int first, MeshFamily uniform, MeshFamily adaptive, const double exact)
{
  const auto label = std::string(name) + ", degree " + std::to_string(degree);
  Levels u(scene(degree, first), uniform);
  print((label + ", uniform").c_str(), u.run(), exact);
  Levels a(scene(degree, first), adaptive);
  print((label + ", adaptive").c_str(), a.run(), exact);
  for (const int n : a.iterations)
    std::cout << " " << n;
  std::cout << std::endl;
}

TEST(Adaptive, Explore)
{
  const auto flat = [](const std::string &symmetry)
  { return [=](const int degree, const int refinements) { return flat_spheroid(symmetry, degree, refinements); }; };
  const double exact = Levels(flat_spheroid("axial mirror", 5, 8), {1, 1, 0., false}).run()[0].energy;
  for (const int degree : {2, 3, 4})
    compare("axial rim", flat("axial"), degree, 1, {7, 1, 0., false}, {14, 1, 0.6, false}, exact);
  for (const int degree : {2, 3})
    compare("rim", flat("none"), degree, 1, {4, 1, 0., false}, {8, 1, 0.6, false}, exact);
}
TEST(Adaptive, Tether)
{
  const double exact = Levels(tether(5, 5), {1, 50, 0., true}).run()[0].energy;
  std::cout << std::setprecision(12) << exact << " " << 67.5893361384 + .5 * 151.846846144 << std::endl;
  for (const int degree : {2, 3, 4})
    compare("tether", tether, degree, 1, {5, 50, 0., true}, {10, 50, 0.6, true}, exact);
}
TEST(Adaptive, Bud)
{
  const auto budding = [](const int degree, const int refinements) { return bud(degree, refinements, 7.4); };
  const double exact = Levels(budding(5, 4), {1, 16, 0., true}).run()[0].energy;
  for (const int degree : {2, 3, 4})
    compare("bud", budding, degree, 1, {6, 16, 0., true}, {12, 16, 0.6, true}, exact);
}
} // namespace

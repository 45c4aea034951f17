// SPDX-License-Identifier: LGPL-2.1-or-later
// Where a solution is local, meshes that follow it need fewer nodes for the same error.
#include "adaptive_runs.h"

#include <gtest/gtest.h>

#include <iomanip>
#include <iostream>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

void solve_it(SurfaceModel &model)
{
  Record record;
  const StepResult result = model.solve(1, record);
  ASSERT_TRUE(result.converged) << result.failure;
}

void print(const char *name, const std::vector<MeshResult> &levels, const double exact)
{
  std::cout << name << "\n";
  for (const MeshResult &level : levels)
    std::cout << std::setw(8) << level.cells << std::setw(8) << level.nodes << std::scientific << std::setprecision(3)
              << std::setw(14) << relative_error(level.value, exact) << std::setw(14) << level.indicators << std::fixed
              << std::setprecision(12) << std::setw(20) << level.value << "\n";
}

/** Bending energy of a spheroid whose axis along z is 1/10 of the others: all of it is at the rim. */
VesicleScene flat_spheroid(const std::string &symmetry, const int degree, const int refinements)
{
  VesicleScene scene        = scene_with({"helfrich bending"});
  scene.vesicle.start_shape = "ellipsoid";
  scene.vesicle.semi_axes   = {1., 1., 0.1};
  scene.mesh.symmetry       = symmetry;
  scene.mesh.degree         = degree;
  scene.mesh.refinements    = refinements;
  return scene;
}

TEST(Adaptive, Explore)
{
  const double exact = uniformly(flat_spheroid("axial mirror", 5, 8), 1, as_built)[0].value;
  for (const int degree : {2, 3, 4})
  {
    print("axial uniform", uniformly(flat_spheroid("axial", degree, 1), 7, as_built), exact);
    print("axial adaptive", adaptively(flat_spheroid("axial", degree, 1), 12, 0.6, as_built), exact);
  }
  for (const int degree : {2, 3})
  {
    print("uniform", uniformly(flat_spheroid("none", degree, 1), 4, as_built), exact);
    print("adaptive", adaptively(flat_spheroid("none", degree, 1), 8, 0.6, as_built), exact);
  }
}
} // namespace

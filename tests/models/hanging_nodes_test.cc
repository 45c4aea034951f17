// SPDX-License-Identifier: LGPL-2.1-or-later
// Equilibria on meshes that are refined in places: continuity, order, Newton's method, all fields and charts.
#include "director_runs.h"
#include "droplet_runs.h"
#include "shell_runs.h"

#include <pellicle/models/nodal_curvature.h>

#include "../discretization/local_refinement.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <utility>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

/** Cuts the cells of a scene's start mesh whose middle is where it is wanted. */
void cut_where(SurfaceScene &scene, const std::function<bool(const Vector3<double> &)> &wanted)
{
  const std::vector<CellPlace> places = cells_where(scene.start_mesh(), wanted);
  scene.mesh.cut.insert(scene.mesh.cut.end(), places.begin(), places.end());
}

/** Twice around a point on the positive x axis. */
void cut_around(SurfaceScene &scene, const double x, const double radius)
{
  for (const double r : {radius, 0.6 * radius})
    cut_where(scene, [=](const Vector3<double> &y) { return norm(y - Vector3<double>(x, 0., 0.)) < r; });
}

VesicleScene refined_prolate(const int degree, const int refinements)
{
  VesicleScene scene = vesicle("prolate", 0.9, degree, refinements);
  cut_around(scene, 0.9, 0.9);
  return scene;
}

double largest_crack_of_fields(const SurfaceModel &model)
{
  double crack = 0.;
  for (const NodalVectors &field : model.equilibrium().state().fields)
    crack = std::max(crack, largest_crack(model.mesh(), field));
  return crack;
}

// E/(8 pi kappa) of the prolate of v = 0.9, from axial meshes of degree 5 (doc/numerics.md).
double exact_prolate()
{
  static const double value = Solved(vesicle("prolate", 0.9, 5, 4, "axial mirror")).energy();
  return value;
}

TEST(HangingNodes, ProlateConvergesQuadraticallyAndStaysWhole)
{
  for (const std::string chart : {"graph", "ale"})
  {
    SCOPED_TRACE(chart);
    VesicleScene scene = refined_prolate(3, 1);
    scene.newton.chart = chart;
    const Solved solved(scene);
    ASSERT_TRUE(solved.result.converged) << solved.result.failure;
    ASSERT_FALSE(solved.model.mesh().hanging.empty());
    EXPECT_LT(largest_crack_of_fields(solved.model), 1e-13);
    EXPECT_EQ(solved.negative_eigenvalues(), 0);
    expect_quadratic_tail(solved.record.iterations, 1e-3, 1e4, 1e-11);
    const double error = relative_error(solved.energy(), exact_prolate());
    EXPECT_LT(error, relative_error(Solved(vesicle("prolate", 0.9, 3, 1)).energy(), exact_prolate()));
  }
}

// The order of energies, 2k, when all cells of such a mesh are cut.
TEST(HangingNodes, EnergiesKeepTheirOrder)
{
  for (const int degree : {2, 3})
  {
    VesicleScene scene = refined_prolate(degree, 1);
    const Solved coarse(scene);
    scene.mesh.cut = coarse.model.mesh().cell_places;
    const Solved fine(scene);
    ASSERT_TRUE(coarse.result.converged && fine.result.converged);
    EXPECT_EQ(fine.model.mesh().n_cells, 4 * coarse.model.mesh().n_cells);
    const double first = relative_error(coarse.energy(), exact_prolate()),
                 last  = relative_error(fine.energy(), exact_prolate());
    EXPECT_GT(std::log2(first / last), 2. * degree - 0.7) << "degree " << degree << ": " << first << ", " << last;
  }
}

// The same of a shape that is given: only the moment is solved for. Spheroid with semi axes 1/2, 1/2, 1: closed form.
TEST(HangingNodes, MomentsOfGivenShapesKeepTheirOrder)
{
  constexpr double exact = 30.903213288654;
  Communicator communicator;
  Timing timing;
  for (const auto &[degree, refinements] : {std::pair<int, int>{2, 2}, {3, 1}})
  {
    std::array<double, 2> errors{};
    for (int finer = 0; finer < 2; ++finer)
    {
      VesicleScene scene        = scene_with({"helfrich bending"});
      scene.vesicle.start_shape = "ellipsoid";
      scene.vesicle.semi_axes   = {0.5, 0.5, 1.};
      scene.vesicle.area        = 5.369608831971;
      scene.mesh.degree         = degree;
      scene.mesh.refinements    = refinements + finer;
      cut_where(scene, [](const Vector3<double> &x) { return x[0] > 0.; });
      const SurfaceModel model(scene, communicator, timing);
      EXPECT_FALSE(model.mesh().hanging.empty());
      EXPECT_LT(largest_crack_of_fields(model), 1e-13);
      errors[finer] = relative_error(model.equilibrium().energy(), exact);
    }
    EXPECT_GT(std::log2(errors[0] / errors[1]), 2. * degree - 0.7)
        << "degree " << degree << ": " << errors[0] << ", " << errors[1];
  }
}

// 1/R everywhere, also where cells of different sizes meet.
TEST(HangingNodes, CurvatureOfASphere)
{
  VesicleScene scene        = scene_with({"helfrich bending"});
  scene.vesicle.start_shape = "ellipsoid";
  scene.vesicle.semi_axes   = {1., 1., 1.};
  scene.mesh.refinements    = 2;
  cut_around(scene, 1., 0.6);
  const SurfaceDiscretization mesh = scene.start_mesh();
  const NodalCurvature curvature   = nodal_curvature(mesh, mesh.positions);
  double largest                   = 0.;
  for (const double H : curvature.mean_outward)
    largest = std::max(largest, std::abs(H - 1.));
  EXPECT_LT(largest, 0.02);
  EXPECT_LT(largest_crack(mesh, curvature.curvature_vector), 1e-13);
}

// Unit vectors at the nodes that others hang on, and the stress of degree k - 1: Newton's method must see the second
// derivative of their normalisation in what the hanging ones do.
TEST(HangingNodes, DirectorsOnATorus)
{
  for (const std::string shear : {"mixed", "direct"})
  {
    SCOPED_TRACE(shear);
    DirectorScene uniform                            = on_torus(1, 1.);
    effect<DirectorEffect>(uniform).parameters.shear = shear;
    DirectorScene scene                              = on_torus(1, 1.);
    effect<DirectorEffect>(scene).parameters.shear   = shear;
    cut_around(scene, std::sqrt(2.) + 1., 1.);
    const Solved solved(scene), coarse(uniform);
    ASSERT_TRUE(solved.result.converged) << solved.result.failure;
    ASSERT_FALSE(solved.model.mesh().hanging.empty());
    EXPECT_LT(largest_crack_of_fields(solved.model), 1e-12);
    expect_quadratic_tail(solved.record.iterations, 1e-2, 1e3, 1e-11);
    EXPECT_LT(relative_error(solved.quantity("total_energy"), coarse.quantity("total_energy")), 0.02);
  }
}

// A shell: material nodes, extensible directors, stresses of degree k - 1. Cells at one of the forces are small.
TEST(HangingNodes, PinchedHemisphere)
{
  ShellScene scene = pinched_hemisphere(1., 3, 1);
  const Solved uniform(scene);
  cut_around(scene, 10., 5.);
  const Solved solved(scene);
  ASSERT_TRUE(solved.result.converged) << solved.result.failure;
  ASSERT_FALSE(solved.model.mesh().hanging.empty());
  for (std::size_t f = 0; f < solved.model.equilibrium().state().fields.size(); ++f)
  {
    const NodalVectors &field = solved.model.equilibrium().state().fields[f];
    double largest            = 0.;
    for (const double component : field)
      largest = std::max(largest, std::abs(component));
    EXPECT_LT(largest_crack(solved.model.mesh(), field), 1e-13 * largest) << "field " << f;
  }
  EXPECT_LE(solved.result.iterations, uniform.result.iterations + 1);
  EXPECT_LT(relative_error(solved.quantity("total_energy"), uniform.quantity("total_energy")), 0.03);
}

// The contact line moves over the plane; cells at one side of it are small. Closed form: the cap's radius. Newton's
// method goes as it does on the uniform mesh.
TEST(HangingNodes, SessileDrop)
{
  DropletScene scene = drop(60., {"none", 3, 1});
  const Solved uniform(scene);
  cut_around(scene, radius_of_cap(60.), 0.6);
  const Solved solved(scene);
  ASSERT_TRUE(solved.result.converged) << solved.result.failure;
  ASSERT_FALSE(solved.model.mesh().hanging.empty());
  EXPECT_LT(largest_crack_of_fields(solved.model), 1e-13);
  EXPECT_EQ(solved.result.iterations, uniform.result.iterations);
  EXPECT_LT(relative_error(solved.quantity("contact_radius"), radius_of_cap(60.)), 3e-7);
}
} // namespace

// SPDX-License-Identifier: LGPL-2.1-or-later
// Drops on a soft cylinder, axisymmetric (gamma_LG = .08, V = 2, R = 2, H = 1, nu = .3), against numbers of an
// independent program: fan meshes of degree 3 down to 1e-6 at the line, whose digits given here are sure.
#include "equilibrium_runs.h"

#include <pellicle/models/ridge_scene.h>
#include <pellicle/potentials/potential_library.h>

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

struct Mesh
{
  int degree, refinements;
  double cell_size;
};

/** A scene whose default is the free line with tensions .08/.06/.06. */
RidgeScene ridge(const Mesh &mesh)
{
  RidgeScene scene;
  list_effects(scene, ridge_effects(), {"liquid surface", "volume constraint", "solid", "solid skins"}, {});
  scene.line.motion      = "free";
  scene.mesh.degree      = mesh.degree;
  scene.mesh.refinements = mesh.refinements;
  scene.line.cell_size   = mesh.cell_size;
  return scene;
}

/** Equilibria from a tenth of all tensions to the whole of them. */
class Ridge
{
public:
  explicit Ridge(RidgeScene given)
      : scene(std::move(given))
      , run(at_scale(0.1))
  {
    const auto at = [&](const double t) -> const RidgeScene & { return at_scale(0.1 + 0.9 * t); };
    EXPECT_EQ(walk(run, 9, at), 1.) << run.result.failure;
  }
  double operator[](const std::string &name) const { return run.quantity(name); }
  const std::vector<IterationReport> &iterations() const { return run.record.iterations; }

private:
  const RidgeScene &at_scale(const double scale)
  {
    scene.tensions.scale = scale;
    scene.check();
    return scene;
  }
  RidgeScene scene;
  Solved run;
};

void expect_line(const Ridge &found, const double material_radius, const double radius, const double height,
                 const double pressure, const double tolerance)
{
  EXPECT_NEAR(found["contact_line_material_radius"], material_radius, tolerance);
  EXPECT_NEAR(found["ridge_radius"], radius, tolerance);
  // The ridge is pulled up into a cusp: its height converges slowly.
  EXPECT_NEAR(found["ridge_height"], height, 5. * tolerance);
  EXPECT_NEAR(found["pressure"], pressure, tolerance);
  EXPECT_NEAR(found["volume"], 2., 2e-10);
}

// The paper's tensions .08/.10/.04. Singular at the line: numbers of the same grading, .0175.
TEST(Ridge, PinnedLine)
{
  RidgeScene scene            = ridge({2, 2, .018});
  scene.line.motion           = "pinned";
  scene.tensions.solid_liquid = .10;
  scene.tensions.solid_gas    = .04;
  const Ridge found(std::move(scene));
  expect_line(found, 1., .86754, .05129, .181589, 2e-4);
  EXPECT_NEAR(found["apex_height"], 1.0351, 5e-4);
}

// With free sides the outer edge, where the skin ends, is pulled inwards by a sixth of the radius.
TEST(Ridge, FreeLineWithFreeSides)
{
  expect_line(Ridge(ridge({3, 1, .01})), 1.0760, 1.0050, .07149, .15707, 3e-4);
}

TEST(Ridge, FreeLineIsTheSameOnAllMeshes)
{
  for (const Mesh &mesh : {Mesh{2, 1, .02}, Mesh{2, 2, .005}, Mesh{3, 1, .01}})
  {
    SCOPED_TRACE(std::to_string(mesh.degree) + " " + std::to_string(mesh.cell_size));
    RidgeScene scene        = ridge(mesh);
    scene.substrate.lateral = "sliding";
    const Ridge found(std::move(scene));
    expect_line(found, 1.018518, 1.004357, .06841, .1571366, 3e-4);
    EXPECT_NEAR(found["total_energy"], 1.2162650, 1e-4);
  }
}

TEST(Ridge, IncompressibleSubstrate)
{
  RidgeScene scene        = ridge({2, 1, .01});
  scene.substrate.lateral = "sliding";
  scene.substrate.poisson = .5;
  expect_line(Ridge(std::move(scene)), .99677, 1.00128, .06071, .158264, 3e-4);
}

// A stiff substrate is a rigid one: Young's angle of 90 degrees, at the radius of half a sphere.
TEST(Ridge, StiffSubstrate)
{
  RidgeScene scene        = ridge({3, 1, .005});
  scene.substrate.lateral = "sliding";
  scene.substrate.young   = 40.;
  const Ridge found(std::move(scene));
  expect_line(found, .986878, .986533, .00572, .1621750, 1e-4);
  EXPECT_NEAR(found["apparent_contact_angle_degrees"], 89.389, .02);
  const double rigid = std::cbrt(3. / pi);
  EXPECT_NEAR(found["ridge_radius"], rigid, .002);
}

TEST(Ridge, NewtonConvergesQuadratically)
{
  const Ridge found(ridge({2, 1, .02}));
  std::vector<IterationReport> last;
  for (const IterationReport &report : found.iterations())
  {
    if (report.iteration == 1)
      last.clear();
    last.push_back(report);
    EXPECT_LE(report.iteration, 12);
  }
  expect_quadratic_tail(last, 1e-3, 1e3, 1e-12);
}

// Neumann's triangle closes as cells become smaller: what the solid pulls at the line goes to zero.
TEST(Ridge, ForcesOnTheLineBalance)
{
  const double coarse = Ridge(ridge({2, 1, .02}))["line_force_imbalance"],
               fine   = Ridge(ridge({2, 1, .005}))["line_force_imbalance"];
  EXPECT_LT(fine, .06);
  EXPECT_NEAR(std::log2(coarse / fine) / 2., .55, .1); // h^(theta_S/pi), theta_S the solid's angle, 96 degrees
}
} // namespace

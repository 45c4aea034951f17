// SPDX-License-Identifier: LGPL-2.1-or-later
// A patch of other lipids at the pole of a prolate vesicle: buds of known shape.
#include "equilibrium_runs.h"
#include "expect_user_error.h"

#include <pellicle/potentials/constraints/lipid_domain.h>
#include <pellicle/potentials/edges/line_tension.h>

#include <gtest/gtest.h>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

/** A vesicle of area 4 pi and reduced volume 0.9 with kappa = 1 everywhere, a fraction 0.15 of it with spontaneous
 * curvature C0, the rest without. Values: independent axisymmetric solution (shape equations, spectral elements checked
 * by shooting). */
struct Vesicle
{
  double C0;
  double energy;                           ///< over 8 pi kappa
  double domain_tension, membrane_tension; ///< on either side of the line
  double pressure;
  double line_radius, height;
};
constexpr double area_fraction = 0.15;
constexpr Vesicle flat    = {1., 1.000155778965, -2.523022956, -4.468020097, -9.643297849, 0.6015503824, 2.856132587};
constexpr Vesicle cap     = {3., 0.787266770438, -0.039217225, -2.702331897, -5.434166168, 0.5627070517, 2.794189109};
constexpr Vesicle bud     = {6., 0.926116196968, -2.728891579, 1.140696798, 3.138834624, 0.5420577828, 2.674154482};
constexpr double bud_neck = 0.5290650835;

VesicleScene scene_of(const double C0, const int degree, const int refinements, const std::string &symmetry = "axial",
                      const double line_tension = 0.)
{
  std::vector<std::string> effects{"helfrich bending", "lipid domain", "area constraint", "volume constraint"};
  if (line_tension != 0.)
    effects.push_back("line tension");
  VesicleScene scene                          = scene_with(effects);
  scene.vesicle.start_shape                   = "prolate";
  scene.vesicle.reduced_volume                = 0.9;
  scene.mesh.degree                           = degree;
  scene.mesh.refinements                      = refinements;
  scene.mesh.symmetry                         = symmetry;
  effect<LipidDomainEffect>(scene).parameters = {area_fraction, 1., C0};
  if (line_tension != 0.)
    effect<LineTensionEffect>(scene).parameters.line_tension = line_tension;
  return scene;
}

double line_radius(const Solved &solved)
{
  return solved.quantity("domain_boundary_length") / (2. * pi);
}

// 32 cells of degree 4: energies of order h^8. What happens at the one point where the line is, is of order h^5.
TEST(LipidDomain, Axial)
{
  for (const Vesicle &exact : {flat, cap, bud})
  {
    const bool is_bud = exact.C0 == bud.C0;
    const Solved solved(scene_of(exact.C0, 4, 3));
    ASSERT_TRUE(solved.result.converged) << "C0 = " << exact.C0 << ": " << solved.result.failure;
    EXPECT_LT(relative_error(solved.energy(), exact.energy), is_bud ? 1e-8 : 1e-10) << "C0 = " << exact.C0;
    EXPECT_LT(relative_error(solved.quantity("domain_area"), 4. * pi * area_fraction), 1e-9) << "C0 = " << exact.C0;
    EXPECT_LT(relative_error(solved.quantity("area"), 4. * pi), 1e-9) << "C0 = " << exact.C0;
    EXPECT_LT(relative_error(solved.quantity("reduced_volume"), 0.9), 1e-9) << "C0 = " << exact.C0;
    const double at_the_line = is_bud ? 2e-3 : 1e-4;
    EXPECT_NEAR(solved.quantity("domain_tension"), exact.domain_tension - exact.membrane_tension, at_the_line)
        << "C0 = " << exact.C0;
    EXPECT_NEAR(solved.quantity("tension"), exact.membrane_tension, at_the_line) << "C0 = " << exact.C0;
    EXPECT_NEAR(solved.quantity("pressure"), exact.pressure, at_the_line) << "C0 = " << exact.C0;
    EXPECT_NEAR(line_radius(solved), exact.line_radius, 0.01 * at_the_line) << "C0 = " << exact.C0;
    EXPECT_NEAR(solved.quantity("height"), exact.height, 0.01 * at_the_line) << "C0 = " << exact.C0;
    EXPECT_EQ(solved.negative_eigenvalues(), 0) << "C0 = " << exact.C0;
    if (is_bud)
    {
      EXPECT_NEAR(solved.quantity("neck_radius"), bud_neck, 2e-5);
    }
    else
    {
      EXPECT_THROW(solved.quantity("neck_radius"), std::logic_error) << "C0 = " << exact.C0;
    }
  }
}

// The curvature jumps at the line, the moment does not, and the mesh follows the line: the orders are those of smooth
// shapes, 2k of the energy and k + 1 of the tension.
TEST(LipidDomain, Orders)
{
  const Solved coarse(scene_of(flat.C0, 3, 3)), fine(scene_of(flat.C0, 3, 4));
  ASSERT_TRUE(coarse.result.converged && fine.result.converged);
  const auto energy_error  = [](const Solved &solved) { return relative_error(solved.energy(), flat.energy); };
  const auto tension_error = [](const Solved &solved)
  { return std::abs(solved.quantity("domain_tension") - (flat.domain_tension - flat.membrane_tension)); };
  EXPECT_LT(energy_error(fine), 1e-10);
  EXPECT_NEAR(std::log2(energy_error(coarse) / energy_error(fine)), 6., 0.5);
  EXPECT_LT(tension_error(fine), 1e-6);
  EXPECT_NEAR(std::log2(tension_error(coarse) / tension_error(fine)), 4., 0.5);
}

// Fine meshes need a start nearby: the line cannot move by more than a cell in one Newton step.
TEST(LipidDomain, InLoadSteps)
{
  Solved solved(scene_of(flat.C0, 5, 4));
  const double reached =
      walk(solved, 5, [](const double t) { return scene_of(flat.C0 + t * (bud.C0 - flat.C0), 5, 4); });
  ASSERT_EQ(reached, 1.) << solved.result.failure;
  EXPECT_LT(relative_error(solved.energy(), bud.energy), 1e-10);
  EXPECT_NEAR(solved.quantity("domain_tension"), bud.domain_tension - bud.membrane_tension, 1e-5);
  EXPECT_NEAR(line_radius(solved), bud.line_radius, 1e-7);
  EXPECT_NEAR(solved.quantity("neck_radius"), bud_neck, 1e-6);
}

// Lipids like the others: the line may be anywhere, and the tension is the same on both sides.
TEST(LipidDomain, OfTheSameLipids)
{
  const Solved solved(scene_of(0., 5, 4)), plain(vesicle("prolate", 0.9, 5, 4, "axial"));
  ASSERT_TRUE(solved.result.converged) << solved.result.failure;
  ASSERT_TRUE(plain.result.converged) << plain.result.failure;
  EXPECT_LT(relative_error(solved.energy(), plain.energy()), 1e-10);
  EXPECT_NEAR(solved.quantity("domain_tension"), 0., 1e-6);
  EXPECT_NEAR(solved.quantity("tension"), plain.quantity("tension"), 1e-6);
  EXPECT_NEAR(solved.quantity("pressure"), plain.quantity("pressure"), 1e-6);
}

TEST(LipidDomain, UnitsDoNotMatter)
{
  constexpr double length = 1e-7, kappa = 1e-19;
  VesicleScene scene                                               = scene_of(cap.C0 / length, 4, 3);
  scene.vesicle.area                                               = 4. * pi * length * length;
  effect<HelfrichBendingEffect>(scene).parameters.bending_rigidity = kappa;
  effect<LipidDomainEffect>(scene).parameters.bending_rigidity     = kappa;
  const Solved solved(scene);
  ASSERT_TRUE(solved.result.converged) << solved.result.failure;
  EXPECT_LT(relative_error(solved.quantity("bending_energy"), 8. * pi * kappa * cap.energy), 1e-9);
  EXPECT_LT(relative_error(solved.quantity("domain_tension"),
                           (cap.domain_tension - cap.membrane_tension) * kappa / (length * length)),
            5e-5);
  EXPECT_LT(relative_error(solved.quantity("domain_area"), area_fraction * 4. * pi * length * length), 1e-9);
}

// The lowest energy grows with the line tension as the line is long.
TEST(LipidDomain, LineTension)
{
  constexpr double lambda = 1., step = 1e-3;
  const Solved less(scene_of(cap.C0, 4, 3, "axial", lambda - step)), middle(scene_of(cap.C0, 4, 3, "axial", lambda)),
      more(scene_of(cap.C0, 4, 3, "axial", lambda + step));
  ASSERT_TRUE(less.result.converged && middle.result.converged && more.result.converged);
  const double slope  = (more.quantity("total_energy") - less.quantity("total_energy")) / (2. * step);
  const double length = 2. * pi * line_radius(middle);
  EXPECT_NEAR(slope, length, 1e-5);
  EXPECT_LT(relative_error(middle.quantity("line_tension_energy"), lambda * length), 1e-12);
  EXPECT_LT(length, 2. * pi * cap.line_radius);
}

// In space, with a line tension that keeps the line round.
TEST(LipidDomain, InSpace)
{
  constexpr double lambda = 1.;
  struct Mesh
  {
    double C0;
    int refinements;
    double energy_tolerance, tolerance;
  };
  for (const Mesh mesh : {Mesh{flat.C0, 0, 1e-5, 0.03}, Mesh{flat.C0, 1, 1e-6, 3e-3}, Mesh{cap.C0, 0, 2e-5, 0.05}})
  {
    const Solved axial(scene_of(mesh.C0, 4, 3, "axial", lambda)),
        solved(scene_of(mesh.C0, 3, mesh.refinements, "none", lambda));
    ASSERT_TRUE(axial.result.converged) << axial.result.failure;
    ASSERT_TRUE(solved.result.converged) << "C0 = " << mesh.C0 << ": " << solved.result.failure;
    EXPECT_LT(relative_error(solved.quantity("total_energy"), axial.quantity("total_energy")), mesh.energy_tolerance)
        << "C0 = " << mesh.C0;
    EXPECT_NEAR(solved.quantity("domain_tension"), axial.quantity("domain_tension"), mesh.tolerance)
        << "C0 = " << mesh.C0;
    EXPECT_NEAR(solved.quantity("tension"), axial.quantity("tension"), mesh.tolerance) << "C0 = " << mesh.C0;
    EXPECT_NEAR(line_radius(solved), line_radius(axial), 0.02 * mesh.tolerance) << "C0 = " << mesh.C0;
    EXPECT_LT(relative_error(solved.quantity("domain_area"), 4. * pi * area_fraction), 1e-9) << "C0 = " << mesh.C0;
    EXPECT_EQ(solved.negative_eigenvalues(), 0) << "C0 = " << mesh.C0;
  }
}

TEST(LipidDomain, NeedsBending)
{
  EXPECT_USER_ERROR(scene_with({"lipid domain", "surface tension", "volume constraint"}).check(), "lipid domain",
                    "helfrich bending", "Effects");
}
} // namespace

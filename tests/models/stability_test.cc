// SPDX-License-Identifier: LGPL-2.1-or-later
// Second variation at equilibria: closed forms on the sphere, thresholds of the oblate vesicle, the way down.
#include "equilibrium_runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

VesicleScene with_stability(VesicleScene scene, const int eigenvalues)
{
  scene.analyses              = {"stability"};
  scene.stability.eigenvalues = eigenvalues;
  return scene;
}

struct Mesh
{
  int degree, refinements;
  std::string symmetry;
};

/** A sphere of radius R = 1, kappa = 1, that tension sigma and pressure 2 sigma/R hold in equilibrium. */
VesicleScene sphere(const double sigma, const Mesh &mesh, const int eigenvalues)
{
  VesicleScene scene = with_stability(scene_with({"helfrich bending", "surface tension", "pressure"}), eigenvalues);
  scene.vesicle.start_shape                              = "ellipsoid";
  scene.vesicle.semi_axes                                = {1., 1., 1.};
  scene.mesh.degree                                      = mesh.degree;
  scene.mesh.refinements                                 = mesh.refinements;
  scene.mesh.symmetry                                    = mesh.symmetry;
  effect<SurfaceTensionEffect>(scene).parameters.tension = sigma;
  effect<PressureEffect>(scene).parameters.pressure      = 2. * sigma;
  return scene;
}

/**
 * mu_l R^4/kappa = (l - 1)(l + 2)(l (l + 1) + sigma R^2/kappa) for a normal displacement by a spherical harmonic
 * (Helfrich 1986; Milner & Safran, Phys. Rev. A 36, 4371 (1987), with P = 2 sigma/R). l = 0 is the breathing of a
 * bubble at given pressure, -2 sigma R^2/kappa: the second derivative of 4 pi sigma R^2 - (4 pi/3) P R^3 over 4 pi R^2.
 * l = 1 are translations, with eigenvalue zero; the gauge takes them out of the spectrum. Rotations move nothing along
 * the normal.
 */
double eigenvalue(const int l, const double sigma)
{
  return (l - 1) * (l + 2) * (l * (l + 1) + sigma);
}

/** Largest error of the eigenvalues of l = 2 and of l = 3, of which there are n_2 and n_3. */
struct Errors
{
  double of_2, of_3;
};
Errors errors_on_sphere(const double sigma, const Mesh &mesh)
{
  const int n_2 = mesh.symmetry == "none" ? 5 : 1, n_3 = mesh.symmetry == "none" ? 7 : 1;
  const Solved solved(sphere(sigma, mesh, 1 + n_2 + n_3));
  EXPECT_TRUE(solved.result.converged) << solved.result.failure;
  std::vector<double> mu = solved.model.stability().value().lowest;
  for (double &value : mu)
    value *= solved.model.scales().of({1, -4}); // internal units are not ours where |sigma| > kappa/R^2
  EXPECT_NEAR(mu.at(0), eigenvalue(0, sigma), 1e-4);
  // From above, as in Ritz' method: the first of each group shows it.
  const auto at = [&](const int i) { return mu.at(static_cast<std::size_t>(i)); };
  EXPECT_GT(at(1), eigenvalue(2, sigma));
  EXPECT_GT(at(1 + n_2), eigenvalue(3, sigma));
  return {at(n_2) - eigenvalue(2, sigma), at(n_2 + n_3) - eigenvalue(3, sigma)};
}

// Order 2k, that of energies: the eigenvalue is stationary at its mode, and the mode's moment is of order k in the norm
// of its energy. Multiplicities 2l + 1 are those of the sphere.
TEST(StabilityOfSpheres, InSpace)
{
  const double sigma  = 1.;
  const Errors coarse = errors_on_sphere(sigma, {3, 2, "none"}), fine = errors_on_sphere(sigma, {3, 3, "none"});
  EXPECT_LT(fine.of_2 / eigenvalue(2, sigma), 1e-6);
  EXPECT_LT(fine.of_3 / eigenvalue(3, sigma), 4e-6);
  EXPECT_NEAR(std::log2(coarse.of_2 / fine.of_2), 6., 0.2);
  EXPECT_NEAR(std::log2(coarse.of_3 / fine.of_3), 6., 0.2);
}

TEST(StabilityOfSpheres, OnAMeridian)
{
  for (int degree = 2; degree <= 4; ++degree)
  {
    const double sigma  = 1.;
    const Errors coarse = errors_on_sphere(sigma, {degree, 1, "axial"}),
                 fine   = errors_on_sphere(sigma, {degree, 2, "axial"});
    EXPECT_NEAR(std::log2(coarse.of_2 / fine.of_2), 2. * degree, 0.3) << degree;
    EXPECT_NEAR(std::log2(coarse.of_3 / fine.of_3), 2. * degree, 0.3) << degree;
  }
  const Errors compressed = errors_on_sphere(-3., {4, 3, "axial"});
  EXPECT_LT(compressed.of_2, 1e-8);
  EXPECT_LT(compressed.of_3, 1e-7);
}

TEST(StabilityOfSpheres, Units)
{
  const double R = 2., kappa = 20., sigma = 5.; // sigma R^2/kappa = 1
  VesicleScene scene                                               = sphere(sigma, {4, 3, "axial"}, 3);
  scene.vesicle.area                                               = 4. * pi * R * R;
  effect<HelfrichBendingEffect>(scene).parameters.bending_rigidity = kappa;
  effect<PressureEffect>(scene).parameters.pressure                = 2. * sigma / R;
  const Solved solved(scene);
  ASSERT_TRUE(solved.result.converged);
  const double unit             = solved.model.scales().of({1, -4}) / (kappa / std::pow(R, 4)); // energy/length^4
  const std::vector<double> &mu = solved.model.stability().value().lowest;
  EXPECT_NEAR(mu.at(0) * unit, -2., 1e-8);
  EXPECT_NEAR(mu.at(1) * unit, 28., 1e-7);
  EXPECT_NEAR(mu.at(2) * unit, 130., 1e-5);
}

// Compressed spheres buckle into harmonics l = 2 at sigma R^2/kappa = -6, l = 3 at -12.
TEST(StabilityOfSpheres, NumberOfUnstableModes)
{
  struct Count
  {
    double sigma;
    int in_space, on_meridian;
  };
  for (const Count &count : {Count{-5.9, 0, 0}, Count{-6.1, 5, 1}, Count{-13., 12, 2}})
  {
    const Solved in_space(sphere(count.sigma, {3, 2, "none"}, 0)), axial(sphere(count.sigma, {3, 2, "axial"}, 0));
    ASSERT_TRUE(in_space.result.converged && axial.result.converged) << count.sigma;
    EXPECT_EQ(in_space.model.stability().value().negative_eigenvalues, count.in_space) << count.sigma;
    EXPECT_EQ(axial.model.stability().value().negative_eigenvalues, count.on_meridian) << count.sigma;
    EXPECT_TRUE(in_space.model.stability()->lowest.empty());
  }
}

// Below v = .7497 axisymmetric oblates resist elliptic modes (Seifert, Berndl & Lipowsky 1991); above, the two of m = 2
// lead down, which a meridian does not know.
TEST(StabilityOfOblates, EllipticModes)
{
  const auto lowest = [](const double v)
  {
    const Solved solved(with_stability(vesicle("oblate", v, 3, 2), 3));
    EXPECT_TRUE(solved.result.converged) << solved.result.failure;
    return *solved.model.stability();
  };
  const Stability above = lowest(0.76), below = lowest(0.74);
  EXPECT_EQ(above.negative_eigenvalues, 2);
  EXPECT_EQ(below.negative_eigenvalues, 0);
  for (const Stability &stability : {above, below})
  {
    EXPECT_NEAR(stability.lowest[1] / stability.lowest[0], 1., 0.02); // cos 2 phi and sin 2 phi
    EXPECT_GT(stability.lowest[2], 20.);
  }
  const double slope = (below.lowest[0] - above.lowest[0]) / 0.02;
  EXPECT_NEAR(0.76 + above.lowest[0] / slope, 0.7497, 1e-3); // by a straight line

  const Solved axial(with_stability(vesicle("oblate", 0.76, 4, 3, "axial"), 1));
  EXPECT_EQ(axial.model.stability()->negative_eigenvalues, 0);
}

/** 1 for a displacement of a meridian that is symmetric under z -> -z, -1 for an antisymmetric one. */
double parity(const NodalVectors &positions, const NodalVectors &mode)
{
  double product = 0., square = 0.;
  for (std::size_t I = 0; I < positions.size() / 3; ++I)
  {
    std::size_t mirrored = 0;
    double nearest       = 1e100;
    for (std::size_t J = 0; J < positions.size() / 3; ++J)
    {
      const double distance =
          std::hypot(positions[3 * J] - positions[3 * I], positions[3 * J + 2] + positions[3 * I + 2]);
      if (distance < nearest)
      {
        nearest  = distance;
        mirrored = J;
      }
    }
    product += mode[3 * I] * mode[3 * mirrored] - mode[3 * I + 2] * mode[3 * mirrored + 2];
    square += mode[3 * I] * mode[3 * I] + mode[3 * I + 2] * mode[3 * I + 2];
  }
  return product / square;
}

// Towards the stomatocytes: v = .5104389224 in the independent axisymmetric solution (shape equations).
TEST(StabilityOfOblates, UpDownMode)
{
  const auto solve   = [](const double v) { return Solved(with_stability(vesicle("oblate", v, 5, 4, "axial"), 2)); };
  const Solved above = solve(0.52), below = solve(0.50), just_above = solve(0.511), just_below = solve(0.51);
  EXPECT_EQ(above.model.stability()->negative_eigenvalues, 0);
  EXPECT_EQ(just_above.model.stability()->negative_eigenvalues, 0);
  EXPECT_EQ(just_below.model.stability()->negative_eigenvalues, 1);
  EXPECT_EQ(below.model.stability()->negative_eigenvalues, 1);
  for (const Solved *solved : {&above, &below})
    EXPECT_NEAR(parity(solved->positions(), solved->model.stability()->modes[0]), -1., 1e-6);
  EXPECT_NEAR(parity(above.positions(), above.model.stability()->modes[1]), 1., 1e-6);
  const double mu_above = just_above.model.stability()->lowest[0], mu_below = just_below.model.stability()->lowest[0];
  EXPECT_NEAR(0.51 - 0.001 * mu_below / (mu_above - mu_below), 0.5104389224, 1e-6);
}

double l2_product(const SurfaceDiscretization &mesh, const NodalVectors &positions, const NodalVectors &u,
                  const NodalVectors &v)
{
  const ShapeTables &tables = mesh.tables;
  std::vector<double> x(18 * tables.n_points), a(x), b(x);
  double sum = 0.;
  for (std::size_t cell = 0; cell < mesh.n_cells; ++cell)
  {
    const std::size_t *nodes = &mesh.cell_nodes[cell * tables.n_nodes];
    evaluate_field(tables, nodes, positions, 3, x.data());
    evaluate_field(tables, nodes, u, 3, a.data());
    evaluate_field(tables, nodes, v, 3, b.data());
    for (unsigned int q = 0; q < 18 * tables.n_points; q += 18)
      sum += tables.weights[q / 18] *
             norm(cross(Vector3<double>(x[q + 3], x[q + 4], x[q + 5]), Vector3<double>(x[q + 6], x[q + 7], x[q + 8]))) *
             (a[q] * b[q] + a[q + 1] * b[q + 1] + a[q + 2] * b[q + 2]);
  }
  return sum;
}

TEST(StabilityModes, OrthonormalAndAllowedByTheConstraints)
{
  const Solved prolate(with_stability(vesicle("prolate", 0.9, 3, 1), 5));
  ASSERT_TRUE(prolate.result.converged);
  const Stability &stability = prolate.model.stability().value();
  EXPECT_EQ(stability.negative_eigenvalues, 0);
  EXPECT_TRUE(prolate.result.warnings.empty());
  ASSERT_EQ(stability.modes.size(), 5U);
  const auto forces = prolate.model.equilibrium().nodal_forces();
  for (std::size_t i = 0; i < 5; ++i)
  {
    for (std::size_t j = 0; j <= i; ++j)
      EXPECT_NEAR(l2_product(prolate.model.mesh(), prolate.positions(), stability.modes[i], stability.modes[j]),
                  i == j ? 1. : 0., 1e-9);
    for (const NodalVectors &gradient : forces.constraints)
    {
      double change = 0.;
      for (std::size_t k = 0; k < gradient.size(); ++k)
        change += gradient[k] * stability.modes[i][k];
      EXPECT_NEAR(change, 0., 1e-9);
    }
    // The sign: the component of largest size is positive.
    EXPECT_GE(*std::max_element(stability.modes[i].begin(), stability.modes[i].end()),
              -*std::min_element(stability.modes[i].begin(), stability.modes[i].end()));
  }
}

TEST(StabilityModes, FollowedDownhill)
{
  VesicleScene scene = with_stability(vesicle("oblate", 0.9, 3, 2), 1);
  const Solved saddle(scene);
  ASSERT_TRUE(saddle.result.converged);
  EXPECT_EQ(saddle.model.stability()->negative_eigenvalues, 2);
  ASSERT_EQ(saddle.result.warnings.size(), 1U);
  EXPECT_NE(saddle.result.warnings[0].find("2 negative eigenvalues"), std::string::npos);
  EXPECT_NE(saddle.result.warnings[0].find("Stability/Follow unstable mode = true"), std::string::npos);

  scene.stability.follow_unstable_mode = true;
  scene.stability.eigenvalues          = 0; // the mode is computed all the same
  const Solved minimum(scene);
  ASSERT_TRUE(minimum.result.converged) << minimum.result.failure;
  EXPECT_TRUE(minimum.result.warnings.empty());
  EXPECT_EQ(minimum.model.stability()->negative_eigenvalues, 0);
  EXPECT_NEAR(minimum.energy(), 1.1896440328, 3e-6); // the prolate of the independent axisymmetric solution
  EXPECT_NEAR(saddle.energy(), 1.2178602609, 3e-5);  // the oblate
}

TEST(StabilityModes, TooManyAskedFor)
{
  const Solved coarse(with_stability(vesicle("prolate", 0.9, 2, 0, "axial"), 100));
  EXPECT_TRUE(coarse.result.converged) << coarse.result.failure;
  EXPECT_EQ(coarse.model.stability().value().negative_eigenvalues, 0);
  EXPECT_FALSE(coarse.model.stability()->failure.empty());
  ASSERT_EQ(coarse.result.warnings.size(), 1U);
  EXPECT_NE(coarse.result.warnings[0].find("lowest eigenvalues were not found"), std::string::npos);
}
} // namespace

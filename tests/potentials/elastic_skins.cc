// SPDX-License-Identifier: LGPL-2.1-or-later
// Elastic skins at one point: a patch with a skew reference, deformed homogeneously and turned in space.
#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/energies/incompressible_rubber_skin.h>
#include <pellicle/potentials/energies/neo_hookean_skin.h>
#include <pellicle/potentials/energies/skalak_skin.h>
#include <pellicle/potentials/energies/tu_ou_yang_skin.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace
{
using namespace pellicle;

/** In-plane matrix {F11, F12, F21, F22}. */
using Matrix2 = std::array<double, 4>;
constexpr Matrix2 identity{1., 0., 0., 1.};

/** The skin of a law with reference base vectors X,1 and X,2, and the positions x,a = R F X,a with a fixed rotation. */
class Patch
{
public:
  template <typename Law>
  explicit Patch(const Law &law)
  {
    const double X1X1 = X[0][0] * X[0][0] + X[0][1] * X[0][1], X1X2 = X[0][0] * X[1][0] + X[0][1] * X[1][1],
                 X2X2 = X[1][0] * X[1][0] + X[1][1] * X[1][1];
    potential         = std::make_shared<DensityPotential<ElasticSkin<Law>>>(
        Law::name, ElasticSkin<Law>{law, std::make_shared<const std::vector<ReferenceMetric>>(
                                             1, ReferenceMetric{X1X1, X1X2, X2X2})});
  }

  /** W(F) per area of the reference. */
  double energy(const Matrix2 &F) const { return derivatives(F).value[0] / J_ref; }

  /** dW(F + t G)/dt at t = 0. */
  double slope(const Matrix2 &F, const Matrix2 &G) const { return product(derivatives(F).gradient, inputs(G)); }

  /** d2W(F + t G)/dt2 at t = 0. */
  double curvature(const Matrix2 &F, const Matrix2 &G) const
  {
    const PointSums sums                = derivatives(F);
    const std::vector<double> direction = inputs(G);
    double result                       = 0.;
    for (unsigned int i = 0; i < 9; ++i)
      for (unsigned int j = 0; j < 9; ++j)
        result += direction[i] * sums.hessian[9 * i + j] * direction[j];
    return result / J_ref;
  }

  /** Cauchy tension (1/J) (df/dx,a) (x) x,a in the turned axes, {11, 12, 21, 22}. */
  Matrix2 tension(const Matrix2 &F) const
  {
    const PointSums sums        = derivatives(F);
    const std::vector<double> x = inputs(F);
    const double J              = J_ref * (F[0] * F[3] - F[1] * F[2]);
    Matrix2 result{};
    for (unsigned int i = 0; i < 2; ++i)
      for (unsigned int j = 0; j < 2; ++j)
        for (unsigned int a = 0; a < 2; ++a)
          result[2 * i + j] += along(i, &sums.gradient[3 + 3 * a]) * along(j, &x[3 + 3 * a]) / J;
    return result;
  }

  /** Pressure of a sphere with reference radius 1 stretched by l, (dE/dl)/(dV/dl), and its derivative by l. */
  double balloon_pressure(const double l) const { return slope({l, 0., 0., l}, identity) / (l * l); }
  double balloon_pressure_slope(const double l) const
  {
    return (curvature({l, 0., 0., l}, identity) - 2. * slope({l, 0., 0., l}, identity) / l) / (l * l);
  }

private:
  /** Component along the i-th in-plane axis after the rotation. */
  static double along(const unsigned int i, const double *v)
  {
    return axis[i][0] * v[0] + axis[i][1] * v[1] + axis[i][2] * v[2];
  }

  static std::vector<double> inputs(const Matrix2 &F)
  {
    std::vector<double> result(9, 0.);
    for (unsigned int a = 0; a < 2; ++a)
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int c = 0; c < 3; ++c)
          result[3 + 3 * a + c] += axis[i][c] * (F[2 * i] * X[a][0] + F[2 * i + 1] * X[a][1]);
    return result;
  }

  PointSums derivatives(const Matrix2 &F) const
  {
    const std::vector<double> x = inputs(F);
    const unsigned int offset   = 0;
    PointSums sums;
    sums.reset(1, 9, Order::hessian);
    potential->add({0, 1, 9, x.data()}, &offset, 1., Order::hessian, sums);
    return sums;
  }

  static double product(const std::vector<double> &a, const std::vector<double> &b)
  {
    double result = 0.;
    for (unsigned int i = 0; i < 9; ++i)
      result += a[i] * b[i];
    return result / J_ref;
  }

  static constexpr double axis[2][3] = {{2. / 3., 2. / 3., -1. / 3.}, {-1. / 3., 2. / 3., 2. / 3.}};
  static constexpr double X[2][2]    = {{1.1, 0.1}, {-0.3, 0.9}};
  static constexpr double J_ref      = 1.1 * 0.9 + 0.3 * 0.1;
  std::shared_ptr<const Potential> potential;
};

constexpr double mu = 1.7, G = 0.8, C = 2.5, Y = 1.4, nu = 0.35;

/** A law with its moduli for small strains and the pressure of its balloon. */
struct Case
{
  Patch patch;
  double shear_modulus, area_modulus;
  std::function<double(double)> pressure;
};

std::vector<Case> cases()
{
  return {{Patch(NeoHookeanSkin{mu}), mu, mu, [](const double l) { return 2. * mu * (1. / l - std::pow(l, -3)); }},
          {Patch(IncompressibleRubberSkin{mu}), mu, 3. * mu,
           [](const double l) { return 2. * mu * (1. / l - std::pow(l, -7)); }},
          {Patch(SkalakSkin{G, C}), G, G * (1. + 2. * C),
           [](const double l) { return 2. * G * (l * l - 1. + C * l * l * (std::pow(l, 4) - 1.)) / l; }},
          {Patch(TuOuYangSkin{Y, nu}), Y / (2. * (1. + nu)), Y / (2. * (1. - nu)),
           [](const double l) { return Y * (l * l - 1.) / ((1. - nu) * l); }}};
}

TEST(ElasticSkins, BalloonPressure)
{
  for (const Case &skin : cases())
    for (const double l : {0.8, 1., 1.3, 2.})
      EXPECT_NEAR(skin.patch.balloon_pressure(l), skin.pressure(l), 1e-13 * (1. + std::abs(skin.pressure(l))));
}

TEST(ElasticSkins, LimitPointsOfTheBalloon)
{
  const Patch neo_hookean(NeoHookeanSkin{1.}), rubber(IncompressibleRubberSkin{1.});
  const double l = std::sqrt(3.), m = std::pow(7., 1. / 6.);
  EXPECT_NEAR(neo_hookean.balloon_pressure(l), 0.769800359, 5e-10);
  EXPECT_NEAR(neo_hookean.balloon_pressure_slope(l), 0., 1e-14);
  EXPECT_GT(neo_hookean.balloon_pressure_slope(l - 0.1), 0.01);
  EXPECT_LT(neo_hookean.balloon_pressure_slope(l + 0.1), -0.01);
  EXPECT_NEAR(rubber.balloon_pressure(m), 1.239462902, 5e-10);
  EXPECT_NEAR(rubber.balloon_pressure_slope(m), 0., 1e-14);
  EXPECT_GT(rubber.balloon_pressure_slope(m - 0.1), 0.1);
  EXPECT_LT(rubber.balloon_pressure_slope(m + 0.1), -0.1);
}

// W = K_A/2 (2 e)^2 for the strain e I, 2 G e^2 for the strains (e, -e) and (0 e; e 0).
TEST(ElasticSkins, ModuliForSmallStrains)
{
  for (const Case &skin : cases())
  {
    EXPECT_NEAR(skin.patch.curvature(identity, identity), 4. * skin.area_modulus, 1e-12);
    EXPECT_NEAR(skin.patch.curvature(identity, {1., 0., 0., -1.}), 4. * skin.shear_modulus, 1e-12);
    EXPECT_NEAR(skin.patch.curvature(identity, {0., 1., 1., 0.}), 4. * skin.shear_modulus, 1e-12);
  }
}

TEST(ElasticSkins, NeitherEnergyNorTensionAtTheReference)
{
  const double c = std::cos(0.6), s = std::sin(0.6);
  for (const Case &skin : cases())
    for (const Matrix2 &F : {identity, Matrix2{c, -s, s, c}})
    {
      EXPECT_NEAR(skin.patch.energy(F), 0., 1e-14);
      for (const double tension : skin.patch.tension(F))
        EXPECT_NEAR(tension, 0., 1e-14);
      EXPECT_NEAR(skin.patch.curvature(F, {F[1], -F[0], F[3], -F[2]}), 0., 1e-13) << "a small turn";
    }
}

// Rotations after the deformation leave the energy alone, rotations of the material before it as well (isotropy); the
// tension is symmetric and turns with the surface.
TEST(ElasticSkins, EnergyIsInvariantUnderRotationAndTensionTurnsWithTheSurface)
{
  const double c = std::cos(0.6), s = std::sin(0.6);
  const Matrix2 F{1.4, 0.2, -0.1, 0.9},
      turned{c * F[0] - s * F[2], c * F[1] - s * F[3], s * F[0] + c * F[2], s * F[1] + c * F[3]},
      turned_before{c * F[0] + s * F[1], c * F[1] - s * F[0], c * F[2] + s * F[3], c * F[3] - s * F[2]};
  for (const Case &skin : cases())
  {
    const Matrix2 before = skin.patch.tension(F), after = skin.patch.tension(turned);
    EXPECT_NEAR(skin.patch.energy(turned), skin.patch.energy(F), 1e-13);
    EXPECT_NEAR(skin.patch.energy(turned_before), skin.patch.energy(F), 1e-13);
    EXPECT_NEAR(before[1], before[2], 1e-13);
    EXPECT_NEAR(after[0], c * c * before[0] - 2. * c * s * before[1] + s * s * before[3], 1e-13);
    EXPECT_NEAR(after[1], c * s * (before[0] - before[3]) + (c * c - s * s) * before[1], 1e-13);
  }
}

// (55) and (60) of Sauer 2014, Skalak's tensions, and Hooke's law on Green's strain.
TEST(ElasticSkins, PrincipalTensions)
{
  for (const auto &[l1, l2] : {std::pair(1.3, 0.8), std::pair(0.9, 1.6), std::pair(1.2, 1.1)})
  {
    const Matrix2 F{l1, 0., 0., l2};
    const double J = l1 * l2, a = l1 * l1, b = l2 * l2, JJ = J * J, tolerance = 1e-13;
    const Matrix2 neo_hookean = Patch(NeoHookeanSkin{mu}).tension(F),
                  rubber = Patch(IncompressibleRubberSkin{mu}).tension(F), skalak = Patch(SkalakSkin{G, C}).tension(F),
                  hooke = Patch(TuOuYangSkin{Y, nu}).tension(F);
    EXPECT_NEAR(neo_hookean[0], mu / J * (a - 1.), tolerance);
    EXPECT_NEAR(neo_hookean[3], mu / J * (b - 1.), tolerance);
    EXPECT_NEAR(rubber[0], mu / J * (a - 1. / JJ), tolerance);
    EXPECT_NEAR(rubber[3], mu / J * (b - 1. / JJ), tolerance);
    EXPECT_NEAR(skalak[0], G / J * (a * (a - 1.) + C * JJ * (JJ - 1.)), 10. * tolerance);
    EXPECT_NEAR(skalak[3], G / J * (b * (b - 1.) + C * JJ * (JJ - 1.)), 10. * tolerance);
    const double E1 = (a - 1.) / 2., E2 = (b - 1.) / 2.;
    EXPECT_NEAR(hooke[0], a / J * Y / (1. - nu * nu) * (E1 + nu * E2), tolerance);
    EXPECT_NEAR(hooke[3], b / J * Y / (1. - nu * nu) * (E2 + nu * E1), tolerance);
    for (const Matrix2 &tension : {neo_hookean, rubber, skalak, hooke})
      EXPECT_NEAR(tension[1], 0., tolerance);
  }
}

// W = Y/(1 - nu) (d/R)^2 of a sphere blown up by d; the rest is of third order.
TEST(ElasticSkins, TuOuYangSphereOfSmallStrain)
{
  const double d = 1e-4;
  EXPECT_NEAR(Patch(TuOuYangSkin{Y, nu}).energy({1. + d, 0., 0., 1. + d}) / (d * d), Y / (1. - nu),
              2. * d * Y / (1. - nu));
}

template <typename Law>
void expect_scaled_contribution(const std::string &modulus)
{
  SkinEffect<Law> effect;
  ParameterSection section(section_name(effect.name()));
  effect.bind(section);
  for (const ParameterSection::Entry &entry : section.entries())
  {
    const bool is_modulus = entry.name == modulus;
    EXPECT_EQ(std::string(entry.dimension.text()), is_modulus ? "energy/length^2" : "1") << entry.name;
    **std::get_if<double *>(&entry.target) = is_modulus ? 6. : 0.25;
  }
  EXPECT_DOUBLE_EQ(effect.typical_energy(3.).value(), 54.);

  // Without a reference (a scene that is only checked) the term is there, with its field.
  PotentialSet set;
  effect.contribute(Scales{3., 27.}, SceneTargets{}, set);
  ASSERT_EQ(set.energies.size(), 1u);
  EXPECT_EQ(set.energies[0]->name(), effect.name());
  ASSERT_EQ(set.energies[0]->fields().size(), 1u);
  EXPECT_EQ(set.energies[0]->fields()[0].name, "position");
  EXPECT_FALSE(set.energies[0]->reparametrisation_invariant());
  const auto *potential = dynamic_cast<const DensityPotential<ElasticSkin<Law>> *>(set.energies[0].get());
  ASSERT_NE(potential, nullptr);
  EXPECT_DOUBLE_EQ(potential->density().law.modulus(), 2.); // 6 / (27/3^2)
  EXPECT_EQ(potential->density().reference, nullptr);
}

TEST(ElasticSkins, EffectsScaleTheirModuliAndNeedNoReferenceToBeListed)
{
  expect_scaled_contribution<NeoHookeanSkin>("Shear modulus");
  expect_scaled_contribution<IncompressibleRubberSkin>("Shear modulus");
  expect_scaled_contribution<SkalakSkin>("Shear modulus");
  expect_scaled_contribution<TuOuYangSkin>("Young modulus");
}

TEST(ElasticSkins, RangesExcludeUnstableModuli)
{
  SkalakSkin skalak;
  TuOuYangSkin tu_ou_yang;
  ParameterSection skalak_section("Skalak skin"), tu_ou_yang_section("Tu-ou-yang skin");
  skalak.bind(skalak_section);
  tu_ou_yang.bind(tu_ou_yang_section);
  EXPECT_FALSE(skalak_section.entries()[1].range.contains(-0.5)); // area modulus G (1 + 2 C) = 0
  EXPECT_TRUE(skalak_section.entries()[1].range.contains(1e3));
  EXPECT_FALSE(tu_ou_yang_section.entries()[1].range.contains(1.)); // area modulus infinite
  EXPECT_FALSE(tu_ou_yang_section.entries()[1].range.contains(-1.));
  EXPECT_TRUE(tu_ou_yang_section.entries()[1].range.contains(0.5));
}
} // namespace

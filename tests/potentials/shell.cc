// SPDX-License-Identifier: LGPL-2.1-or-later
// The Cosserat shell at a point: strains, energies, their derivatives and limits.
#include <pellicle/kinematics/automatic_differentiation.h>
#include <pellicle/potentials/potential_library.h>
#include <pellicle/potentials/shell/cosserat_shell.h>
#include <pellicle/potentials/shell/shell_loads.h>

#include "../expect_user_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

namespace
{
using namespace pellicle;
using Vector = Vector3<double>;

/** A random reference, skew and curved, with the director along the normal. */
ShellReference skew_reference(std::mt19937 &random)
{
  std::uniform_real_distribution<double> uniform(-0.3, 0.3);
  const Vector D1(1. + uniform(random), uniform(random), uniform(random)),
      D2(uniform(random), 1. + uniform(random), uniform(random));
  const Vector normal = cross(D1, D2) / norm(cross(D1, D2));
  // D_3,a is tangential and D_3,1 . D_2 = D_3,2 . D_1
  const double a = uniform(random), b = uniform(random), c = uniform(random);
  const Vector dual_1 = cross(D2, normal) / norm(cross(D1, D2)), dual_2 = cross(normal, D1) / norm(cross(D1, D2));
  return {{{D1, D2, normal}}, {{a * dual_1 + b * dual_2, b * dual_1 + c * dual_2}}, Vector(0.3, -0.2, 0.1)};
}

std::shared_ptr<const std::vector<ShellReference>> one(const ShellReference &reference)
{
  return std::make_shared<const std::vector<ShellReference>>(1, reference);
}

ShellMaterial material(const char *correction = "none")
{
  ShellMaterial m;
  m.young            = 2.3;
  m.poisson          = 0.27;
  m.thickness        = 0.4;
  m.shear_correction = correction;
  return m;
}

ShellStrainEnergy strain_energy(const ShellReference &reference, const ShellMaterial &m,
                                const double squared_node_distance = 0.9)
{
  return {m, one(reference), std::make_shared<const std::vector<double>>(1, squared_node_distance)};
}

/** Position, director and stresses at a point, the reference plus random changes of the given size. */
template <unsigned int n>
PointInputs<double, n> near(const ShellReference &D, const double size, std::mt19937 &random)
{
  std::uniform_real_distribution<double> uniform(-size, size);
  PointInputs<double, n> inputs;
  inputs[0].slots[1] = D.base[0];
  inputs[0].slots[2] = D.base[1];
  inputs[1].slots[0] = D.base[2];
  inputs[1].slots[1] = D.director_d[0];
  inputs[1].slots[2] = D.director_d[1];
  for (auto &field : inputs)
    for (unsigned int s = 0; s < 3; ++s)
      for (unsigned int c = 0; c < 3; ++c)
        field.slots[s][c] += uniform(random);
  return inputs;
}

template <typename Density, std::size_t n>
void compare_derivatives(const Density &density, const std::array<FieldAtPoint<double>, n> &at)
{
  const DensityPotential<Density> potential("test", density);
  std::vector<unsigned int> offsets;
  std::vector<double> inputs;
  unsigned int field = 0;
  for (const FieldUse &use : potential.fields())
  {
    offsets.push_back(static_cast<unsigned int>(inputs.size()));
    for (unsigned int s = 0; s < n_slots(use.derivatives); ++s)
      for (unsigned int c = 0; c < 3; ++c)
        inputs.push_back(at[field].slots[s][c]);
    ++field;
  }
  const auto n_inputs = static_cast<unsigned int>(inputs.size());
  PointSums hand, automatic;
  hand.reset(1, n_inputs, Order::hessian);
  automatic.reset(1, n_inputs, Order::hessian);
  potential.add({0, 1, n_inputs, inputs.data()}, offsets.data(), -1.7, Order::hessian, hand);
  automatic.value[0] = potential.add_automatic(inputs.data(), offsets.data(), {0}, -1.7, Order::hessian, n_inputs,
                                               automatic.gradient.data(), automatic.hessian.data());
  EXPECT_NEAR(hand.value[0], automatic.value[0], 1e-13);
  for (unsigned int i = 0; i < n_inputs; ++i)
    EXPECT_NEAR(hand.gradient[i], automatic.gradient[i], 1e-12) << i;
  for (unsigned int i = 0; i < n_inputs * n_inputs; ++i)
    EXPECT_NEAR(hand.hessian[i], automatic.hessian[i], 1e-12) << i / n_inputs << "," << i % n_inputs;
}

TEST(ShellDensities, DerivativesAreTheAutomaticOnes)
{
  std::mt19937 random(5);
  for (const char *correction : {"none", "5/6"})
    for (int trial = 0; trial < 4; ++trial)
    {
      const ShellReference D = skew_reference(random);
      compare_derivatives(strain_energy(D, material(correction)), near<4>(D, 0.3, random));
      compare_derivatives(ShellBendingEnergy{material(correction), one(D)}, near<2>(D, 0.3, random));
    }
}

// x -> Q x + c, d_3 -> Q d_3; the stress belongs to the reference and does not turn.
TEST(ShellDensities, AreZeroAtTheReferenceAndInvariantUnderRigidMotions)
{
  std::mt19937 random(6);
  const double a = 0.3, b = 0.5, c = 0.1, d = std::sqrt(1. - a * a - b * b - c * c);
  const Matrix3 Q{{a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c), 2 * (b * c + a * d),
                   a * a - b * b + c * c - d * d, 2 * (c * d - a * b), 2 * (b * d - a * c), 2 * (c * d + a * b),
                   a * a - b * b - c * c + d * d}};
  const ShellReference D         = skew_reference(random);
  const ShellStrainEnergy strain = strain_energy(D, material("5/6"));
  const ShellBendingEnergy bending{material(), one(D)};
  for (const double size : {0., 0.3})
  {
    PointInputs<double, 4> here   = near<4>(D, size, random);
    PointInputs<double, 4> turned = here;
    for (unsigned int f = 0; f < 2; ++f)
      for (unsigned int s = 0; s < 3; ++s)
        turned[f].slots[s] = Q * here[f].slots[s];
    const PointInputs<double, 2> here_2{{here[0], here[1]}}, turned_2{{turned[0], turned[1]}};
    const double before = strain.density(here, {}), before_2 = bending.density(here_2, {});
    EXPECT_NEAR(strain.density(turned, {}), before, 1e-14);
    EXPECT_NEAR(bending.density(turned_2, {}), before_2, 1e-14);
    if (size == 0.)
    {
      EXPECT_NEAR(before, 0., 1e-15);
      EXPECT_NEAR(before_2, 0., 1e-15);
    }
    else
      EXPECT_GT(before_2, 1e-4);
  }
}

// Rubin's linear strains (paper 003): E = sym(delta_i (x) D^i), beta_a = delta_3,a - (D^i . D_3,a) delta_i.
TEST(ShellStrains, LinearPartIsThatOfThePaper)
{
  std::mt19937 random(7);
  const ShellReference D = skew_reference(random);
  const auto H           = D.first_moments(0.4);
  const auto zero = near<2>(D, 0., random), away = near<2>(D, 1., random);
  std::array<Vector, 5> delta;
  const auto slot = [](const PointInputs<double, 2> &at, const unsigned int k)
  { return k < 2 ? at[0].slots[1 + k] : at[1].slots[k - 2]; };
  for (unsigned int k = 0; k < 5; ++k)
    delta[k] = slot(away, k) - slot(zero, k);

  std::array<Vector, 2> beta{{delta[3], delta[4]}};
  for (unsigned int alpha = 0; alpha < 2; ++alpha)
    for (unsigned int i = 0; i < 3; ++i)
      beta[alpha] -= dot(D.dual[i], D.director_d[alpha]) * delta[i];
  Matrix3 gradient;
  for (unsigned int i = 0; i < 3; ++i)
    gradient = gradient + outer(delta[i], D.dual[i]);
  for (unsigned int alpha = 0; alpha < 2; ++alpha)
    gradient = gradient + outer(beta[alpha], H[alpha]);

  for (const double size : {1e-3, 1e-4})
  {
    PointInputs<double, 2> at = zero;
    for (unsigned int s = 1; s < 3; ++s)
      at[0].slots[s] += size * delta[s - 1];
    for (unsigned int s = 0; s < 3; ++s)
      at[1].slots[s] += size * delta[s + 2];
    const ShellStrains<double> strains(at[0], at[1], D, H);
    for (unsigned int s = 0; s < 6; ++s)
    {
      const auto [p, q]   = symmetric_index[s];
      const double linear = p == q ? gradient(p, p) : gradient(p, q) + gradient(q, p);
      EXPECT_NEAR(strains.strain[s] / size, linear, 20. * size);
    }
    for (unsigned int alpha = 0; alpha < 2; ++alpha)
      for (unsigned int c = 0; c < 3; ++c)
        EXPECT_NEAR(strains.couple[alpha][c] / size, beta[alpha][c], 20. * size);
  }
}

// m/rho_0 and H^a are integrals over the thickness of sqrt(G) and xi sqrt(G) G^a, here by Gauss quadrature of the three
// base vectors G_a = D_a + xi D_3,a, G_3 = D_3.
TEST(ShellReference, VolumeAndMomentsAreIntegralsOverTheThickness)
{
  std::mt19937 random(8);
  const ShellReference D = skew_reference(random);
  const double h         = 0.4;
  double volume          = 0.;
  std::array<Vector, 2> moment{};
  for (const auto &[point, weight] :
       {std::pair<double, double>{-std::sqrt(0.6), 5. / 9.}, {0., 8. / 9.}, {std::sqrt(0.6), 5. / 9.}})
  {
    const double xi = 0.5 * h * point, dxi = 0.5 * h * weight;
    const Vector G1 = D.base[0] + xi * D.director_d[0], G2 = D.base[1] + xi * D.director_d[1], G3 = D.base[2];
    const double root = dot(G1, cross(G2, G3));
    volume += root * dxi;
    moment[0] += (xi * root * dxi) * (cross(G2, G3) / root);
    moment[1] += (xi * root * dxi) * (cross(G3, G1) / root);
  }
  EXPECT_NEAR(D.volume(h), volume, 1e-15);
  const auto H = D.first_moments(h);
  for (unsigned int alpha = 0; alpha < 2; ++alpha)
    for (unsigned int c = 0; c < 3; ++c)
      EXPECT_NEAR(H[alpha][c], moment[alpha][c] / volume, 1e-15);

  // A sphere: D_3,a = D_a/R.
  const double R = 2.5;
  const ShellReference sphere(D.base, {{D.base[0] / R, D.base[1] / R}}, {});
  const auto on_sphere = sphere.first_moments(h);
  for (unsigned int c = 0; c < 3; ++c)
    EXPECT_NEAR(on_sphere[0][c], h * h / (12. * R) / (1. + h * h / (12. * R * R)) * sphere.dual[0][c], 1e-15);
  const ShellReference flat(D.base, {}, {});
  EXPECT_EQ(norm(flat.first_moments(h)[0]), 0.);
}

TEST(ShellMaterial, ComplementaryEnergyIsTheDualOfTheStrainEnergy)
{
  const Vector N(0.6, 0., 0.8);
  const Symmetric6<double> S{{0.3, -0.7, 0.2, 0.5, -0.4, 0.6}};
  for (const char *correction : {"none", "5/6"})
  {
    const ShellMaterial m = material(correction);
    const auto stress     = seed<FirstOrder<6>>(S);
    const FirstOrder<6> W = m.plain_complementary_energy(stress, N) + m.shear_complementary_energy(stress, N);
    Symmetric6<double> E;
    double product = 0.;
    for (unsigned int s = 0; s < 6; ++s)
    {
      E[s] = W.dx(static_cast<int>(s));
      product += S[s] * E[s];
    }
    EXPECT_NEAR(product - m.strain_energy(E, N), W.val(), 1e-14) << correction;
    const auto back = m.strain_energy(seed<FirstOrder<6>>(E), N);
    for (unsigned int s = 0; s < 6; ++s)
      EXPECT_NEAR(back.dx(static_cast<int>(s)), S[s], 1e-14) << correction;
  }
}

// Pure transverse shear 2 E_13 = g costs kappa_s mu g^2/2, in-plane shear mu g^2/2.
TEST(ShellMaterial, ShearCorrectionActsOnTransverseShearAlone)
{
  const Vector e3(0., 0., 1.);
  const ShellMaterial plain = material(), corrected = material("5/6");
  const Symmetric6<double> transverse{{0., 0., 0., 0., 0.1, 0.}}, in_plane{{0., 0., 0., 0., 0., 0.1}};
  EXPECT_NEAR(plain.strain_energy(transverse, e3), 0.005 * plain.shear_modulus(), 1e-16);
  EXPECT_NEAR(corrected.strain_energy(transverse, e3), 5. / 6. * 0.005 * plain.shear_modulus(), 1e-16);
  EXPECT_NEAR(corrected.strain_energy(in_plane, e3), 0.005 * plain.shear_modulus(), 1e-16);
}

// K^ab as the theory prints it, summed over its indices; and the plate's stiffness for one curvature, for two, and for
// twist.
TEST(ShellMaterial, BendingTensorsAreThoseOfAPlate)
{
  std::mt19937 random(9);
  const ShellReference D = skew_reference(random);
  const ShellMaterial m  = material();
  const std::array<Vector, 2> beta{{{0.3, -0.4, 0.2}, {0.1, 0.5, -0.6}}};
  const double nu = m.poisson;
  double sum      = 0.;
  for (unsigned int a = 0; a < 2; ++a)
    for (unsigned int b = 0; b < 2; ++b)
    {
      sum += 2. * nu / (1. - nu) * dot(beta[a], D.dual[a]) * dot(D.dual[b], beta[b]) +
             dot(beta[a], D.dual[b]) * dot(D.dual[a], beta[b]);
      for (unsigned int c = 0; c < 2; ++c)
        sum += dot(D.dual[a], D.dual[b]) * dot(beta[a], D.base[c]) * dot(D.dual[c], beta[b]);
    }
  EXPECT_NEAR(m.bending_energy(beta, D), m.shear_modulus() * m.thickness * m.thickness / 24. * sum, 1e-15);

  const ShellReference flat({{{1., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}}}, {}, {});
  const double h = m.thickness, stiffness = m.bending_stiffness();
  const auto energy = [&](const Vector &b1, const Vector &b2) {
    return h * m.bending_energy<double>({{b1, b2}}, flat);
  };
  EXPECT_NEAR(energy({0.1, 0., 0.}, {}), 0.005 * stiffness, 1e-15);
  EXPECT_NEAR(energy({0.1, 0., 0.}, {0., 0.1, 0.}), 0.01 * (1. + nu) * stiffness, 1e-15);
  EXPECT_NEAR(energy({0., 0.1, 0.}, {0.1, 0., 0.}), 0.01 * (1. - nu) * stiffness, 1e-15);
}

// The largest value over the stress is the energy itself, whatever share is kept: in the thickness direction too.
TEST(ShellStrainEnergy, MixedFormIsExactAtEveryPoint)
{
  std::mt19937 random(10);
  const ShellReference D = skew_reference(random);
  const ShellMaterial m  = material("5/6");
  const auto at          = near<4>(D, 0.2, random);
  const ShellStrains<double> strains(at[0], at[1], D, D.first_moments(m.thickness));
  const double exact        = D.volume(m.thickness) * m.strain_energy(strains.strain, D.normal);
  const auto seeded         = seed<FirstOrder<6>>(strains.strain);
  const FirstOrder<6> plain = m.plain_energy(seeded, D.normal), shear = m.shear_energy(seeded, D.normal);
  for (const double squared_node_distance : {0.01, 0.9, 1e4})
  {
    const ShellStrainEnergy density = strain_energy(D, m, squared_node_distance);
    const auto kept                 = density.kept({});
    EXPECT_GT(kept.plain, 0.);
    EXPECT_LE(kept.shear, 0.5);
    PointInputs<double, 4> best = at;
    for (int c = 0; c < 6; ++c)
      best[2 + c / 3].slots[0][c % 3] = plain.dx(c) + shear.dx(c);
    EXPECT_NEAR(density.density(best, {}), exact, 1e-14);
    best[2].slots[0][1] += 0.1;
    EXPECT_LT(density.density(best, {}), exact - 1e-4);
  }
}

// Work of loads: -p f . (x - X) sqrt(D) and -f . (x - X).
TEST(ShellLoads, AreWorkOnDisplacements)
{
  std::mt19937 random(11);
  const ShellReference D = skew_reference(random);
  PointInputs<double, 1> at;
  at[0].slots[0] = D.place + Vector(0.1, 0.2, -0.3);
  const DeadLoad dead{{1., -2., 3.}, nullptr, one(D)};
  EXPECT_NEAR(dead.density(at, {}), -D.area * (0.1 - 0.4 - 0.9), 1e-15);
  const PointLoad point{{1., -2., 3.}, D.place};
  EXPECT_NEAR(point.density(at, {}), 1.2, 1e-15);
}

TEST(ShellEffects, NeedAShellAndThreeComponents)
{
  PotentialSet set;
  test::expect_user_error([&] { CosseratShellEffect().contribute({}, SceneTargets{}, set); }, {"section Shell"});
  DeadLoadEffect load;
  load.parameters.force = {1., 2.};
  test::expect_user_error([&] { load.check(); }, {"Force", "2 numbers", "three"});
}
} // namespace

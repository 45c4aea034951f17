// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies and skins whose reference is a field: derivatives, Eshelby's force, invariance.
#include <pellicle/potentials/energies/neo_hookean_skin.h>
#include <pellicle/potentials/energies/skalak_skin.h>
#include <pellicle/potentials/moving_skin.h>
#include <pellicle/potentials/solids/body_pressure.h>
#include <pellicle/potentials/solids/elastic_body.h>
#include <pellicle/potentials/solids/moving_reference.h>
#include <pellicle/potentials/solids/neo_hookean_solid.h>
#include <pellicle/potentials/solids/volume_laws.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace pellicle;

const NeoHookeanSolid logarithmic{0.7, 1.3, VolumetricLaw::logarithmic}, quadratic{0.7, 1.3, VolumetricLaw::quadratic};
const Matrix3 bases{{{1.1, 0.2, -0.1, 0.1, 0.9, 0.3, -0.2, 0.15, 1.3}}}; ///< X,a in its rows
const Matrix3 F0{{{1.2, 0.3, -0.2, 0.1, 0.8, 0.25, -0.15, 0.05, 1.1}}};
const double turn = 0.7;
const Matrix3 rotation{{{std::cos(turn), -std::sin(turn), 0., std::sin(turn), std::cos(turn), 0., 0., 0., 1.}}};

Vector3<double> row(const Matrix3 &m, const unsigned int i)
{
  return {m(i, 0), m(i, 1), m(i, 2)};
}

/** x = x0 + F X,a xi^a, X = X0 + X,a xi^a: place and bases of both, then further inputs. */
std::vector<double> inputs(const Matrix3 &F, const Matrix3 &X_a, const std::vector<double> &further = {})
{
  std::vector<double> result{0.4, -0.6, 0.9};
  for (unsigned int a = 0; a < 3; ++a)
    for (unsigned int c = 0; c < 3; ++c)
      result.push_back((F * row(X_a, a))[c]);
  result.insert(result.end(), {0.3, 0.2, -0.5});
  result.insert(result.end(), X_a.entries.begin(), X_a.entries.end());
  result.insert(result.end(), further.begin(), further.end());
  return result;
}

constexpr unsigned int offsets[3] = {0, 12, 24};

template <typename Density>
PointSums derivatives(const Density &density, const std::vector<double> &x, const Order order = Order::hessian)
{
  const DensityPotential<Density> potential("test", density);
  const unsigned int n = static_cast<unsigned int>(x.size());
  PointSums sums;
  sums.reset(1, n, order);
  potential.add({0, 1, n, x.data()}, offsets, 1., order, sums);
  return sums;
}

template <typename BodyDensity>
OnMovingReference<BodyDensity> moving(const BodyDensity &density)
{
  return {density};
}

template <typename Law>
auto solid(const Law &law)
{
  return moving(ElasticEnergy<Law>{law});
}

template <typename BodyDensity>
void compare_with_automatic(const BodyDensity &density, const std::vector<double> &further = {})
{
  const std::vector<double> x = inputs(F0, bases, further);
  const unsigned int n        = static_cast<unsigned int>(x.size());
  const PointSums hand        = derivatives(moving(density), x);
  PointSums automatic;
  automatic.reset(1, n, Order::hessian);
  automatic.value[0] = DensityPotential<OnMovingReference<BodyDensity>>("test", moving(density))
                           .add_automatic(x.data(), offsets, {}, 1., Order::hessian, n, automatic.gradient.data(),
                                          automatic.hessian.data());
  EXPECT_NEAR(hand.value[0], automatic.value[0], 1e-13);
  for (unsigned int i = 0; i < n; ++i)
    EXPECT_NEAR(hand.gradient[i], automatic.gradient[i], 1e-13) << i;
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
    {
      EXPECT_NEAR(hand.hessian[i * n + j], automatic.hessian[i * n + j], 1e-13) << i << "," << j;
      EXPECT_NEAR(hand.hessian[i * n + j], hand.hessian[j * n + i], 1e-14) << i << "," << j;
    }
}

TEST(MovingReference, HandWrittenDerivativesAreTheAutomaticOnes)
{
  compare_with_automatic(ElasticEnergy<NeoHookeanSolid>{logarithmic});
  compare_with_automatic(ElasticEnergy<NeoHookeanSolid>{quadratic});
  compare_with_automatic(BodyPressure<LinearVolumeLaw>{{0.}}, {0.8, 0., 0.});
  compare_with_automatic(BodyPressure<LinearVolumeLaw>{{0.4}}, {0.8, 0., 0.});
  compare_with_automatic(BodyPressure<LogarithmicVolumeLaw>{{0.4}}, {0.8, 0., 0.});
  compare_with_automatic(BodyPressure<QuadraticVolumeLaw>{{0.4}}, {0.8, 0., 0.});
}

// With X as it is given, energy and derivatives by x are those of the body on a given reference.
TEST(MovingReference, AtRestItIsTheBodyOnItsGivenReference)
{
  const std::vector<double> x = inputs(F0, bases);
  const auto given            = std::make_shared<const std::vector<ReferenceBasis>>(
      1, ReferenceBasis(row(bases, 0), row(bases, 1), row(bases, 2)));
  const PointSums moved = derivatives(solid(logarithmic), x),
                  fixed = derivatives(ElasticBody<NeoHookeanSolid>{logarithmic, given}, {x.begin(), x.begin() + 12});
  EXPECT_DOUBLE_EQ(moved.value[0], fixed.value[0]);
  for (unsigned int i = 0; i < 12; ++i)
  {
    EXPECT_EQ(moved.gradient[i], fixed.gradient[i]);
    for (unsigned int j = 0; j < 12; ++j)
      EXPECT_EQ(moved.hessian[24 * i + j], fixed.hessian[12 * i + j]);
  }
}

// dE/dX,a . L X,a = J_ref (W 1 - F^T P) : L for a homogeneous motion dX = L X of the material, with W and P of the
// logarithmic law.
TEST(MovingReference, EshelbysForceOfAHomogeneousDeformation)
{
  const double mu = logarithmic.mu, lambda = logarithmic.lambda;
  const Vector3<double> f[3] = {row(F0, 0), row(F0, 1), row(F0, 2)};
  const double J             = dot(f[0], cross(f[1], f[2]));
  Matrix3 cofactor; // J F^-T
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int c = 0; c < 3; ++c)
      cofactor(i, c) = cross(f[(i + 1) % 3], f[(i + 2) % 3])[c];
  const Matrix3 P      = mu * F0 + ((lambda * std::log(J) - mu) / J) * cofactor;
  const double I1      = dot(f[0], f[0]) + dot(f[1], f[1]) + dot(f[2], f[2]),
               W       = 0.5 * mu * (I1 - 3. - 2. * std::log(J)) + 0.5 * lambda * std::log(J) * std::log(J);
  const Matrix3 stress = identity3(W) - transposed(F0) * P;
  const Matrix3 L{{{0.3, -0.2, 0.5, 0.7, -0.4, 0.1, 0.2, 0.6, -0.3}}};
  double expected = 0.;
  for (unsigned int k = 0; k < 9; ++k)
    expected += stress.entries[k] * L.entries[k];
  expected *= ReferenceBasis(row(bases, 0), row(bases, 1), row(bases, 2)).volume;

  const PointSums sums = derivatives(solid(logarithmic), inputs(F0, bases));
  double power         = 0.;
  for (unsigned int a = 0; a < 3; ++a)
    power += dot(L * row(bases, a), {sums.gradient[15 + 3 * a], sums.gradient[16 + 3 * a], sums.gradient[17 + 3 * a]});
  EXPECT_NEAR(power, expected, 1e-13);
  EXPECT_GT(std::abs(expected), 0.1);
}

// Rigid motions of either configuration, and a uniform shift of the mesh, which are translations of x and X.
TEST(MovingReference, RigidMotionsOfBothConfigurations)
{
  const double before       = derivatives(solid(quadratic), inputs(F0, bases), Order::value).value[0];
  const Matrix3 turned_rows = bases * transposed(rotation); // X,a -> R X,a
  EXPECT_NEAR(derivatives(solid(quadratic), inputs(rotation * F0, bases), Order::value).value[0], before, 1e-14);
  EXPECT_NEAR(derivatives(solid(quadratic), inputs(F0 * transposed(rotation), turned_rows), Order::value).value[0],
              before,
              1e-14); // the same place, another material frame: isotropy
  const PointSums sums = derivatives(solid(quadratic), inputs(F0, bases), Order::gradient);
  for (unsigned int c = 0; c < 3; ++c)
  {
    EXPECT_EQ(sums.gradient[c], 0.);
    EXPECT_EQ(sums.gradient[12 + c], 0.);
  }
}

// x and X parametrised anew by one change of the parameters: the density is one per parametric volume.
TEST(MovingReference, MotionOfTheMeshAlone)
{
  const Matrix3 B{{{1.2, 0.1, -0.2, 0.3, 0.9, 0.1, 0., -0.2, 1.1}}};
  const double det    = dot(row(B, 0), cross(row(B, 1), row(B, 2)));
  const double before = derivatives(solid(logarithmic), inputs(F0, bases), Order::value).value[0],
               after  = derivatives(solid(logarithmic), inputs(F0, B * bases), Order::value).value[0];
  EXPECT_NEAR(after, det * before, 1e-13);
}

TEST(MovingReference, NoEnergyOfInvertedBodiesOrReferences)
{
  const Matrix3 mirror{{{1., 0., 0., 0., 1., 0., 0., 0., -1.}}};
  for (const auto &x : {inputs(mirror * F0, bases), inputs(F0 * mirror, mirror * bases), inputs(F0, mirror * bases)})
  {
    EXPECT_FALSE(std::isfinite(derivatives(solid(logarithmic), x, Order::value).value[0]));
    EXPECT_FALSE(std::isfinite(derivatives(solid(quadratic), x, Order::value).value[0]));
  }
  const std::vector<double> both = inputs(F0, mirror * bases, {0.8, 0., 0.});
  EXPECT_FALSE(std::isfinite(derivatives(moving(BodyPressure<LinearVolumeLaw>{{0.}}), both, Order::value).value[0]));
}

/** Place and base vectors of x and X of a surface: x,a = F X,a. */
std::vector<double> surface_inputs(const Matrix3 &F, const Matrix3 &X_a)
{
  std::vector<double> result = inputs(F, X_a);
  result.erase(result.begin() + 21, result.end()); // X,3
  result.erase(result.begin() + 9, result.begin() + 12);
  return result;
}

constexpr unsigned int surface_offsets[2] = {0, 9};

template <typename Law>
PointSums skin_derivatives(const Law &law, const std::vector<double> &x)
{
  PointSums sums;
  sums.reset(1, 18, Order::hessian);
  DensityPotential<MovingSkin<Law>>("test", {law}).add({0, 1, 18, x.data()}, surface_offsets, 1., Order::hessian, sums);
  return sums;
}

template <typename Law>
void compare_skin_with_automatic(const Law &law)
{
  const std::vector<double> x = surface_inputs(F0, bases);
  const PointSums hand        = skin_derivatives(law, x);
  PointSums automatic;
  automatic.reset(1, 18, Order::hessian);
  automatic.value[0] = DensityPotential<MovingSkin<Law>>("test", {law})
                           .add_automatic(x.data(), surface_offsets, {}, 1., Order::hessian, 18,
                                          automatic.gradient.data(), automatic.hessian.data());
  EXPECT_NEAR(hand.value[0], automatic.value[0], 1e-13);
  for (unsigned int i = 0; i < 18; ++i)
    EXPECT_NEAR(hand.gradient[i], automatic.gradient[i], 1e-13) << i;
  for (unsigned int i = 0; i < 18 * 18; ++i)
    EXPECT_NEAR(hand.hessian[i], automatic.hessian[i], 1e-12) << i / 18 << "," << i % 18;
}

TEST(MovingSkin, HandWrittenDerivativesAreTheAutomaticOnes)
{
  compare_skin_with_automatic(NeoHookeanSkin{0.8});
  compare_skin_with_automatic(SkalakSkin{0.8, 0.4});
}

TEST(MovingSkin, WithXGivenItIsTheElasticSkin)
{
  const std::vector<double> x = surface_inputs(F0, bases);
  const Vector3<double> X1 = row(bases, 0), X2 = row(bases, 1);
  const ElasticSkin<NeoHookeanSkin> given{
      {0.8},
      std::make_shared<const std::vector<ReferenceMetric>>(1, ReferenceMetric{dot(X1, X1), dot(X1, X2), dot(X2, X2)})};
  const unsigned int offset = 0;
  PointSums fixed;
  fixed.reset(1, 9, Order::hessian);
  DensityPotential<ElasticSkin<NeoHookeanSkin>>("test", given)
      .add({0, 1, 9, x.data()}, &offset, 1., Order::hessian, fixed);
  const PointSums moved = skin_derivatives(NeoHookeanSkin{0.8}, x);
  EXPECT_EQ(moved.value[0], fixed.value[0]);
  for (unsigned int i = 0; i < 9; ++i)
  {
    EXPECT_EQ(moved.gradient[i], fixed.gradient[i]);
    for (unsigned int j = 0; j < 9; ++j)
      EXPECT_EQ(moved.hessian[18 * i + j], fixed.hessian[9 * i + j]);
  }
}

// Equal stretch l of a plane: W - l P = -2 mu ln l, so that dE = -2 mu ln l times the change of the reference's area.
TEST(MovingSkin, EshelbysForceOfAnEqualStretch)
{
  const double mu = 0.8, l = 1.3;
  const PointSums sums = skin_derivatives(NeoHookeanSkin{mu}, surface_inputs(l * rotation, bases));
  const AreaDerivatives area(row(bases, 0), row(bases, 1));
  for (unsigned int a = 0; a < 2; ++a)
    for (unsigned int c = 0; c < 3; ++c)
      EXPECT_NEAR(sums.gradient[12 + 3 * a + c], -2. * mu * std::log(l) * area.dJ[a][c], 1e-14);
}
} // namespace

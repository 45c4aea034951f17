// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids and liquids in three dimensions at one point with a skew reference: derivatives, stresses, tangents.
#include <pellicle/potentials/solids/body_force.h>
#include <pellicle/potentials/solids/compressible_liquid.h>
#include <pellicle/potentials/solids/incompressible_liquid.h>
#include <pellicle/potentials/solids/neo_hookean_solid.h>
#include <pellicle/potentials/solids/shear_drag.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace pellicle;

constexpr double mu = 0.7, lambda = 1.3, K = 2.1;
const Vector3<double> X[3] = {{1.1, 0.2, -0.1}, {0.1, 0.9, 0.3}, {-0.2, 0.15, 1.3}};
const Matrix3 F0{{{1.2, 0.3, -0.2, 0.1, 0.8, 0.25, -0.15, 0.05, 1.1}}};
const Matrix3 dF{{{0.3, -0.2, 0.5, 0.7, -0.4, 0.1, 0.2, 0.6, -0.3}}};
const Matrix3 DF{{{-0.1, 0.4, 0.3, -0.6, 0.2, 0.5, 0.8, -0.3, 0.7}}};

std::shared_ptr<const std::vector<ReferenceBasis>> skew_reference()
{
  return std::make_shared<const std::vector<ReferenceBasis>>(1, ReferenceBasis(X[0], X[1], X[2]));
}
const double J_ref = ReferenceBasis(X[0], X[1], X[2]).volume;

Matrix3 product(const Matrix3 &a, const Matrix3 &b)
{
  Matrix3 c;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      for (unsigned int k = 0; k < 3; ++k)
        c(i, j) += a(i, k) * b(k, j);
  return c;
}
Matrix3 transpose(const Matrix3 &a)
{
  Matrix3 t;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      t(i, j) = a(j, i);
  return t;
}
double trace(const Matrix3 &a)
{
  return a(0, 0) + a(1, 1) + a(2, 2);
}
double determinant(const Matrix3 &a)
{
  return dot(a * Vector3<double>(1., 0., 0.), cross(a * Vector3<double>(0., 1., 0.), a * Vector3<double>(0., 0., 1.)));
}
Matrix3 inverse(const Matrix3 &a)
{
  Matrix3 result;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      result(j, i) = (a((i + 1) % 3, (j + 1) % 3) * a((i + 2) % 3, (j + 2) % 3) -
                      a((i + 1) % 3, (j + 2) % 3) * a((i + 2) % 3, (j + 1) % 3)) /
                     determinant(a);
  return result;
}

/** A place, x,a = F X,a in slots 1 to 3, then further inputs. */
std::vector<double> inputs(const Matrix3 &F, const std::vector<double> &further = {})
{
  std::vector<double> result{0.4, -0.6, 0.9};
  for (const Vector3<double> &base : X)
    for (unsigned int c = 0; c < 3; ++c)
      result.push_back((F * base)[c]);
  result.insert(result.end(), further.begin(), further.end());
  return result;
}

template <typename Density>
PointSums derivatives(const Density &density, const std::vector<double> &x)
{
  const DensityPotential<Density> potential("test", density);
  const unsigned int n = static_cast<unsigned int>(x.size()), offsets[2] = {0, 12};
  PointSums sums;
  sums.reset(1, n, Order::hessian);
  potential.add({0, 1, n, x.data()}, offsets, 1., Order::hessian, sums);
  return sums;
}

/** P = (1/J_ref) (d density/dx,a) (x) X,a. */
template <typename Law>
Matrix3 stress(const Law &law, const Matrix3 &F)
{
  const PointSums sums = derivatives(ElasticBody<Law>{law, skew_reference()}, inputs(F));
  Matrix3 P;
  for (unsigned int a = 0; a < 3; ++a)
    P = P + (1. / J_ref) * outer({sums.gradient[3 + 3 * a], sums.gradient[4 + 3 * a], sums.gradient[5 + 3 * a]}, X[a]);
  return P;
}

/** Second derivative of an energy per reference volume along two changes of F. */
template <typename Density>
double second_variation(const Density &density, const Matrix3 &F, const Matrix3 &first, const Matrix3 &second,
                        const std::vector<double> &further = {})
{
  const std::vector<double> zeros(further.size(), 0.);
  std::vector<double> a = inputs(first, zeros), b = inputs(second, zeros);
  std::fill_n(a.begin(), 3, 0.); // the place stays
  std::fill_n(b.begin(), 3, 0.);
  const PointSums sums = derivatives(density, inputs(F, further));
  double result        = 0.;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      result += a[i] * sums.hessian[i * a.size() + j] * b[j];
  return result / J_ref;
}

template <typename Density>
void compare_with_automatic(const Density &density, const std::vector<double> &further = {})
{
  const std::vector<double> x = inputs(F0, further);
  const unsigned int n = static_cast<unsigned int>(x.size()), offsets[2] = {0, 12};
  const PointSums hand = derivatives(density, x);
  PointSums automatic;
  automatic.reset(1, n, Order::hessian);
  automatic.value[0] = DensityPotential<Density>("test", density)
                           .add_automatic(x.data(), offsets, {}, 1., Order::hessian, n, automatic.gradient.data(),
                                          automatic.hessian.data());
  EXPECT_NEAR(hand.value[0], automatic.value[0], 1e-13);
  for (unsigned int i = 0; i < n; ++i)
    EXPECT_NEAR(hand.gradient[i], automatic.gradient[i], 1e-13) << i;
  for (unsigned int i = 0; i < n * n; ++i)
    EXPECT_NEAR(hand.hessian[i], automatic.hessian[i], 1e-13) << i / n << "," << i % n;
}

const NeoHookeanSolid logarithmic{mu, lambda, VolumetricLaw::logarithmic},
    quadratic{mu, lambda, VolumetricLaw::quadratic};

TEST(Bodies, HandWrittenDerivativesAreTheAutomaticOnes)
{
  compare_with_automatic(ElasticBody<NeoHookeanSolid>{logarithmic, skew_reference()});
  compare_with_automatic(ElasticBody<NeoHookeanSolid>{quadratic, skew_reference()});
  compare_with_automatic(ElasticBody<CompressibleLiquid>{{K}, skew_reference()});
  compare_with_automatic(IncompressibleLiquid{{}, skew_reference()}, {0.8, 0., 0.});
  compare_with_automatic(IncompressibleLiquid{{1. / K}, skew_reference()}, {0.8, 0., 0.});
  compare_with_automatic(BodyForce{{0.3, -0.5, 0.7}});
}

void expect_equal(const Matrix3 &a, const Matrix3 &b)
{
  for (unsigned int k = 0; k < 9; ++k)
    EXPECT_NEAR(a.entries[k], b.entries[k], 1e-13) << k;
}

TEST(Bodies, StressesOfTheirLaws)
{
  const Matrix3 F_inverse_transposed = transpose(inverse(F0));
  const double J                     = determinant(F0);
  const Matrix3 shear                = mu * (F0 - F_inverse_transposed);
  expect_equal(stress(logarithmic, F0), shear + (lambda * std::log(J)) * F_inverse_transposed);
  expect_equal(stress(quadratic, F0), shear + (0.5 * lambda * (J * J - 1.)) * F_inverse_transposed);
  const double p = K * (1. - J); // P = -p J F^-T
  expect_equal(stress(CompressibleLiquid{K}, F0), (-p * J) * F_inverse_transposed);
}

TEST(Bodies, SimpleShearDilatationAndUniaxialStretch)
{
  // Cauchy stress of a simple shear: mu gamma, normal stress difference mu gamma^2.
  const double gamma = 0.6;
  const Matrix3 sheared{{{1., gamma, 0., 0., 1., 0., 0., 0., 1.}}};
  const Matrix3 sigma = product(stress(logarithmic, sheared), transpose(sheared));
  EXPECT_NEAR(sigma(0, 1), mu * gamma, 1e-14);
  EXPECT_NEAR(sigma(1, 0), mu * gamma, 1e-14);
  EXPECT_NEAR(sigma(0, 0) - sigma(1, 1), mu * gamma * gamma, 1e-14);
  EXPECT_NEAR(sigma(2, 2), 0., 1e-14);

  const double l = 1.25;
  EXPECT_NEAR(stress(logarithmic, identity3(l))(1, 1), mu * (l - 1. / l) + lambda * 3. * std::log(l) / l, 1e-13);
  EXPECT_NEAR(stress(quadratic, identity3(l))(1, 1), mu * (l - 1. / l) + 0.5 * lambda * (std::pow(l, 6) - 1.) / l,
              1e-13);

  // Stretch l with free sides: mu (b^2 - 1) + (lambda/2) (J^2 - 1) = 0 with J = l b^2 yields b, then P_11 = mu (l -
  // b^2/l).
  const double A = 0.5 * lambda * l * l, b2 = (-mu + std::sqrt(mu * mu + 4. * A * (mu + 0.5 * lambda))) / (2. * A);
  const double b  = std::sqrt(b2);
  const Matrix3 P = stress(quadratic, Matrix3{{{l, 0., 0., 0., b, 0., 0., 0., b}}});
  EXPECT_NEAR(P(0, 0), mu * (l - b2 / l), 1e-13);
  EXPECT_NEAR(P(1, 1), 0., 1e-14);
}

// Geometric part plus the push-forward of 2 dS/dC: c_ijkl = (lambda/J) d_ij d_kl + (mu - lambda ln J)/J (d_ik d_jl +
// d_il d_jk) per present volume.
TEST(Bodies, NeoHookeanTangentIsGeometricPlusSpatial)
{
  const double J  = determinant(F0);
  const Matrix3 f = product(dF, inverse(F0)), g = product(DF, inverse(F0)); // grad dx, grad Dx
  const Matrix3 sum = (1. / J) * (mu * (product(F0, transpose(F0)) - identity3(1.)) + identity3(lambda * std::log(J)));
  const double spatial = lambda / J * trace(f) * trace(g) +
                         (mu - lambda * std::log(J)) / J * (trace(product(f, transpose(g))) + trace(product(f, g)));
  const double geometric = trace(product(product(f, sum), transpose(g)));
  EXPECT_NEAR(second_variation(ElasticBody<NeoHookeanSolid>{logarithmic, skew_reference()}, F0, dF, DF),
              J * (geometric + spatial), 1e-13);
}

TEST(Bodies, TangentsOfLiquids)
{
  const double J  = determinant(F0);
  const Matrix3 f = product(dF, inverse(F0)), g = product(DF, inverse(F0));
  const double divs = trace(f) * trace(g), of_volume = divs - trace(product(f, g));
  const double p_given = 0.8, p = K * (1. - J);
  EXPECT_NEAR(second_variation(IncompressibleLiquid{{}, skew_reference()}, F0, dF, DF, {p_given, 0., 0.}),
              -p_given * J * of_volume, 1e-14);
  EXPECT_NEAR(second_variation(ElasticBody<CompressibleLiquid>{{K}, skew_reference()}, F0, dF, DF),
              J * (K * J * divs - p * of_volume), 1e-14);
}

// At its stationary pressure the compliant liquid is the compressible one: p = K (1 - J), energy (K/2)(1 - J)^2.
TEST(Bodies, CompliantLiquidIsTheCompressibleOne)
{
  const double J = determinant(F0), p = K * (1. - J);
  const PointSums compliant    = derivatives(IncompressibleLiquid{{1. / K}, skew_reference()}, inputs(F0, {p, 0., 0.})),
                  compressible = derivatives(ElasticBody<CompressibleLiquid>{{K}, skew_reference()}, inputs(F0));
  EXPECT_NEAR(compliant.gradient[12], 0., 1e-15);
  EXPECT_NEAR(compliant.value[0], compressible.value[0], 1e-14);
  for (unsigned int i = 0; i < 12; ++i)
    EXPECT_NEAR(compliant.gradient[i], compressible.gradient[i], 1e-14) << i;
}

// The tangent of a neo-Hookean solid whose reference is the present configuration, and nothing else.
TEST(Bodies, ShearDragIsATangentAlone)
{
  const PointSums drag = derivatives(ShearDrag{mu}, inputs(F0));
  EXPECT_EQ(drag.value[0], 0.);
  for (const double g : drag.gradient)
    EXPECT_EQ(g, 0.);
  const auto here =
      std::make_shared<const std::vector<ReferenceBasis>>(1, ReferenceBasis(F0 * X[0], F0 * X[1], F0 * X[2]));
  const PointSums solid = derivatives(ElasticBody<NeoHookeanSolid>{{mu, 0.}, here}, inputs(F0));
  for (std::size_t i = 0; i < drag.hessian.size(); ++i)
    EXPECT_NEAR(drag.hessian[i], solid.hessian[i], 1e-14) << i / 12 << "," << i % 12;
}

TEST(Bodies, NoEnergyOfAnInvertedBody)
{
  const Matrix3 inverted{{{1., 0., 0., 0., 1., 0., 0., 0., -0.4}}}, flat{{{1., 0., 0., 0., 1., 0., 0., 0., 0.}}};
  for (const Matrix3 &F : {inverted, flat})
  {
    EXPECT_FALSE(
        std::isfinite(derivatives(ElasticBody<NeoHookeanSolid>{logarithmic, skew_reference()}, inputs(F)).value[0]));
    EXPECT_FALSE(
        std::isfinite(derivatives(ElasticBody<CompressibleLiquid>{{K}, skew_reference()}, inputs(F)).value[0]));
  }
}
} // namespace

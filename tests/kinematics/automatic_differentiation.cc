// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/kinematics/automatic_differentiation.h>
#include <pellicle/kinematics/vector3.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace pellicle;

namespace
{
/** x^2 y + sin(z)/x with its derivatives by hand. */
struct Example
{
  template <typename Number>
  static Number f(const std::array<Number, 3> &x)
  {
    using std::sin;
    return x[0] * x[0] * x[1] + sin(x[2]) / x[0];
  }
  static std::array<double, 3> gradient(const double x, const double y, const double z)
  {
    return {{2. * x * y - std::sin(z) / (x * x), x * x, std::cos(z) / x}};
  }
  static std::array<double, 9> hessian(const double x, const double y, const double z)
  {
    const double xx = 2. * y + 2. * std::sin(z) / (x * x * x), xz = -std::cos(z) / (x * x);
    return {{xx, 2. * x, xz, 2. * x, 0., 0., xz, 0., -std::sin(z) / x}};
  }
};
const std::array<double, 3> x{{1.3, -0.4, 0.8}};
} // namespace

TEST(AutomaticDifferentiation, FirstOrderGivesValueAndGradient)
{
  const FirstOrder<3> f = Example::f(seed<FirstOrder<3>>(x));
  EXPECT_DOUBLE_EQ(value_of(f), Example::f(x));
  const auto expected = Example::gradient(x[0], x[1], x[2]);
  for (unsigned int i = 0; i < 3; ++i)
    EXPECT_NEAR(gradient_of(f)[i], expected[i], 1e-15) << i;
}

TEST(AutomaticDifferentiation, SecondOrderGivesValueGradientAndSymmetricHessian)
{
  const SecondOrder<3> f = Example::f(seed<SecondOrder<3>>(x));
  EXPECT_DOUBLE_EQ(value_of(f), Example::f(x));
  const auto gradient = Example::gradient(x[0], x[1], x[2]);
  const auto expected = Example::hessian(x[0], x[1], x[2]);
  const auto hessian  = hessian_of(f);
  for (unsigned int i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(gradient_of(f)[i], gradient[i], 1e-15) << i;
    for (unsigned int j = 0; j < 3; ++j)
    {
      EXPECT_NEAR(hessian[3 * i + j], expected[3 * i + j], 2e-15) << i << " " << j;
      EXPECT_EQ(hessian[3 * i + j], hessian[3 * j + i]);
    }
  }
}

TEST(AutomaticDifferentiation, ConstantsHaveNoDerivatives)
{
  const SecondOrder<2> f(3.5);
  EXPECT_EQ(value_of(f), 3.5);
  EXPECT_EQ(value_of(2.5), 2.5);
  for (const double entry : gradient_of(f))
    EXPECT_EQ(entry, 0.);
  for (const double entry : hessian_of(f))
    EXPECT_EQ(entry, 0.);
}

TEST(AutomaticDifferentiation, PassesThroughVectorAlgebra)
{
  // The Hessian of the norm of v is (I - v v/v^2)/norm(v).
  const auto inputs = seed<SecondOrder<3>>(x);
  const auto length = norm(Vector3<SecondOrder<3>>(inputs[0], inputs[1], inputs[2]));
  const Vector3<double> v(x[0], x[1], x[2]);
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      EXPECT_NEAR(hessian_of(length)[3 * i + j], ((i == j) - v[i] * v[j] / dot(v, v)) / norm(v), 1e-15);
}

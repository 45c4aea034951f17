// SPDX-License-Identifier: LGPL-2.1-or-later
#include "expect_user_error.h"

#include <pellicle/base/constants.h>
#include <pellicle/base/expression.h>
#include <pellicle/base/expression_of_place.h>

#include <array>
#include <cmath>
#include <utility>

using namespace pellicle;

namespace
{
/** Derivatives against central differences of those of one order less. */
void check_derivatives(const FunctionOfPlace &f, const double x, const double y)
{
  SCOPED_TRACE(f.text());
  const double h         = 1e-5;
  const PlaceSample at   = f.at(x, y);
  const PlaceSample east = f.at(x + h, y), west = f.at(x - h, y), north = f.at(x, y + h), south = f.at(x, y - h);
  const auto expect = [h](const double derivative, const double plus, const double minus)
  { EXPECT_NEAR(derivative, (plus - minus) / (2. * h), 1e-7 * (1. + std::abs(derivative))); };
  expect(at.dx, east.value, west.value);
  expect(at.dy, north.value, south.value);
  expect(at.dxx, east.dx, west.dx);
  expect(at.dxy, north.dx, south.dx);
  expect(at.dxy, east.dy, west.dy);
  expect(at.dyy, north.dy, south.dy);
  expect(at.dxxx, east.dxx, west.dxx);
  expect(at.dxxy, north.dxx, south.dxx);
  expect(at.dxyy, north.dxy, south.dxy);
  expect(at.dyyy, north.dyy, south.dyy);
}

TEST(ExpressionOfPlace, ClosedForm)
{
  const ExpressionOfPlace f("0.1*sin(2*pi*x)*cos(y)");
  const double x = 0.3, y = -0.8, k = 2. * pi, s = std::sin(k * x), c = std::cos(k * x);
  const PlaceSample at = f.at(x, y);
  EXPECT_NEAR(at.value, 0.1 * s * std::cos(y), 1e-15);
  EXPECT_NEAR(at.dx, 0.1 * k * c * std::cos(y), 1e-15);
  EXPECT_NEAR(at.dy, -0.1 * s * std::sin(y), 1e-15);
  EXPECT_NEAR(at.dxx, -0.1 * k * k * s * std::cos(y), 1e-14);
  EXPECT_NEAR(at.dxy, -0.1 * k * c * std::sin(y), 1e-15);
  EXPECT_NEAR(at.dyy, -0.1 * s * std::cos(y), 1e-15);
  EXPECT_EQ(f.text(), "0.1*sin(2*pi*x)*cos(y)");
}

TEST(ExpressionOfPlace, EveryFunctionIsDifferentiated)
{
  for (const char *text : {"sqrt(x+y)",
                           "exp(-x^2/0.3)*y",
                           "ln(x*y)",
                           "log(x+y^2)",
                           "log10(x)*y",
                           "log2(x+y)",
                           "sin(x*y)",
                           "cos(x-y)",
                           "tan(x*y)",
                           "asin(x*y)",
                           "acos(x*y)",
                           "atan(x/y)",
                           "atan2(y,x)",
                           "sinh(x*y)",
                           "cosh(x+y)",
                           "tanh(3*x-y)",
                           "asinh(x*y)",
                           "acosh(2+x*y)",
                           "atanh(x*y)",
                           "abs(x-y)*abs(y)",
                           "abs(sqrt(x)-2)^3",
                           "x^y",
                           "x^0.5*y^-2",
                           "2^(x*y)",
                           "(x^2+y^2)^1.5",
                           "1e-3*x^3*y - .5*x + 4.E+0*y^2",
                           "3"})
    check_derivatives(ExpressionOfPlace(text), 0.6, 0.45);
}

// Values follow evaluate_number(), which has another parser.
TEST(ExpressionOfPlace, PrecedenceIsThatOfNumbers)
{
  for (const char *text : {"2^3^2", "-3^2", "2^-2", "2*-3-4", "6/2/3", "7-2-3", "2-3*4+5", "2^-1^2", "-2^-2*3",
                           "8/-2*4", "(1+2)*3", "1.5e1*2", "6/2*3", "2^2*3", "pi/3"})
    EXPECT_DOUBLE_EQ(ExpressionOfPlace(text).at(0., 0.).value, evaluate_number(text)) << text;
}

TEST(ExpressionOfPlace, ConstantsKeepTheirDigits)
{
  EXPECT_EQ(ExpressionOfPlace("0.1234567890123456*x").at(1., 0.).value, 0.1234567890123456);
  EXPECT_EQ(ExpressionOfPlace("x/3").at(1., 0.).value, 1. / 3.);
  EXPECT_EQ(ExpressionOfPlace("1e-30*x").at(1., 0.).dx, 1e-30);
  EXPECT_EQ(ExpressionOfPlace("pi").at(1., 0.).value, pi);
}

TEST(ExpressionOfPlace, UnitsScaleValueAndDerivatives)
{
  const double L = 2.5;
  const ExpressionOfPlace user("x^2*y + 0.3*y"), height("x^2*y + 0.3*y", L, L), angle("x^2*y + 0.3*y", L, 1.);
  const double x = 0.4, y = 0.7;
  const PlaceSample F = user.at(L * x, L * y), h = height.at(x, y), a = angle.at(x, y);
  EXPECT_DOUBLE_EQ(h.value, F.value / L);
  EXPECT_DOUBLE_EQ(h.dx, F.dx);
  EXPECT_DOUBLE_EQ(h.dxy, F.dxy * L);
  EXPECT_DOUBLE_EQ(a.value, F.value);
  EXPECT_DOUBLE_EQ(a.dy, F.dy * L);
  EXPECT_DOUBLE_EQ(a.dxx, F.dxx * L * L);
  check_derivatives(height, x, y);
}

TEST(ExpressionOfPlace, VariablesHaveAnyName)
{
  const ExpressionOfPlace f("r^2 + 3*angle", 1., 1., {"r", "angle"});
  EXPECT_DOUBLE_EQ(f.at(2., 1.).value, 7.);
  EXPECT_DOUBLE_EQ(f.at(2., 1.).dy, 3.);
}

TEST(ExpressionOfPlace, DerivativesOfAbsDoNotExistAtZero)
{
  const ExpressionOfPlace f("abs(x)");
  EXPECT_EQ(f.at(0., 1.).value, 0.);
  EXPECT_TRUE(std::isnan(f.at(0., 1.).dx));
  EXPECT_EQ(f.at(-1e-9, 1.).dx, -1.);
  EXPECT_EQ(f.at(1e-9, 1.).dxx, 0.);
}

TEST(ExpressionOfPlace, OutsideItsDomainItIsNotANumber)
{
  EXPECT_TRUE(std::isnan(ExpressionOfPlace("sqrt(x)").at(-1., 0.).value));
}

TEST(ExpressionOfPlace, MistakesAreNamed)
{
  const std::vector<std::pair<const char *, const char *>> mistakes = {
      {"0.1*foo(x)", "'foo' is not understood"},
      {"z+1", "'z' is not understood"},
      {"sin", "'sin' is a function and needs a '('"},
      {"sin(x", "a ')' is missing"},
      {"x+", "incomplete"},
      {"", "incomplete"},
      {"2x", "'x' is not understood where it stands"},
      {"x**2", "'*2' is not understood where it stands"},
      {"x<y", "'<y' is not understood"},
      {"0,5*x", "with a point"},
      {"atan2(x)", "1 arguments instead of 2"},
      {"sin(x,y)", "2 arguments instead of 1"},
      {"1e400*x", "double precision"},
      {"min(x,y)", "'min' has no derivatives"},
      {"floor(x)", "only abs is accepted"},
      {"0^x", "0 as base"},
      {"(-2)^y", "-2 as base"}};
  for (const auto &[text, reason] : mistakes)
    test::expect_user_error([text = text] { ExpressionOfPlace f(text); },
                            {"'" + std::string(text) + "' is not a function of x and y", reason, "sqrt", "pi, x, y"});
  EXPECT_USER_ERROR(ExpressionOfPlace f("x/0"), "'x/0'", "division by 0");
  EXPECT_USER_ERROR(ExpressionOfPlace f("sqrt(-1)*x"), "'sqrt(-1)*x'", "not real");
  EXPECT_USER_ERROR(ExpressionOfPlace f("u+x", 1., 1., {"u", "v"}), "function of u and v", "'x' is not understood");
}

// Texts whose derivatives would need more time or memory than there is.
TEST(ExpressionOfPlace, WhatGrowsWithoutBoundIsRefused)
{
  const auto repeated = [](const std::string &text, const unsigned int n)
  {
    std::string all;
    for (unsigned int i = 0; i < n; ++i)
      all += text;
    return all;
  };
  EXPECT_USER_ERROR(ExpressionOfPlace f("9^9^9^9"), "'9^9^9^9'", "no finite real value");
  EXPECT_USER_ERROR(ExpressionOfPlace f("(9*x)^999999999"), "'(9*x)^999999999'");
  EXPECT_USER_ERROR(ExpressionOfPlace f(repeated("(", 200) + "x" + repeated(")", 200)), "nested more than 100 deep");
  EXPECT_USER_ERROR(ExpressionOfPlace f(repeated("-", 200) + "x"), "nested more than 100 deep");
  EXPECT_USER_ERROR(ExpressionOfPlace f(repeated("x+", 3000) + "y"), "6001 characters", "5000");
  EXPECT_USER_ERROR(ExpressionOfPlace f(repeated("sin(", 60) + "x" + repeated(")", 60)), "third order", "too long");
  std::string product = "x";
  for (unsigned int i = 1; i < 60; ++i)
    product += "*sin(" + std::to_string(i) + "*y)";
  EXPECT_USER_ERROR(ExpressionOfPlace f(product), "third order", "too long");
}
} // namespace

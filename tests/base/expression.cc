// SPDX-License-Identifier: LGPL-2.1-or-later
#include "expect_user_error.h"

#include <pellicle/base/expression.h>

#include <cmath>
#include <limits>

using namespace pellicle;
using pellicle::test::expect_user_error;

namespace
{
const double pi = 3.14159265358979323846;
}

TEST(Expression, PlainNumbers)
{
  EXPECT_EQ(evaluate_number("0.65"), 0.65);
  EXPECT_EQ(evaluate_number(" -3 "), -3.);
  EXPECT_EQ(evaluate_number("+2.5"), 2.5);
  EXPECT_EQ(evaluate_number("1e-3"), 1e-3);
  EXPECT_EQ(evaluate_number("4.E+2"), 400.);
  EXPECT_EQ(evaluate_number(".5"), 0.5);
  EXPECT_EQ(evaluate_number("0.3333333333333333"), 1. / 3.);
  EXPECT_EQ(evaluate_number("-1.7976931348623157e308"), -1.7976931348623157e308);
}

TEST(Expression, Expressions)
{
  EXPECT_DOUBLE_EQ(evaluate_number("4*pi"), 4. * pi);
  EXPECT_DOUBLE_EQ(evaluate_number("2*pi/3"), 2. * pi / 3.);
  EXPECT_DOUBLE_EQ(evaluate_number("sqrt(2)"), std::sqrt(2.));
  EXPECT_DOUBLE_EQ(evaluate_number("2^3 - (1 + 0.5)"), 6.5);
  EXPECT_DOUBLE_EQ(evaluate_number("-pi"), -pi);
  EXPECT_DOUBLE_EQ(evaluate_number("max(1, 2) * 1.5e1"), 30.);
  EXPECT_DOUBLE_EQ(evaluate_number("ln(exp(2))"), 2.);
}

TEST(Expression, Infinity)
{
  EXPECT_EQ(evaluate_number("inf"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(evaluate_number("-inf"), -std::numeric_limits<double>::infinity());
}

TEST(Expression, NanIsRejected)
{
  for (const char *text : {"nan", "NaN", "-nan", "sqrt(-1)", "0/0"})
    expect_user_error([&] { evaluate_number(text); }, {"'" + std::string(text) + "' is not a number"});
}

TEST(Expression, ExpressionsMustBeFinite)
{
  expect_user_error([] { evaluate_number("1/0"); }, {"'1/0'", "no finite value"});
  expect_user_error([] { evaluate_number("1e400"); }, {"'1e400'", "double precision"});
  expect_user_error([] { evaluate_number("10^400"); }, {"'10^400'", "no finite value"});
}

TEST(Expression, MalformedTextsAreNamed)
{
  expect_user_error([] { evaluate_number(""); }, {"missing"});
  expect_user_error([] { evaluate_number("4*pie"); }, {"'4*pie' is not a number", "'pie' is not understood", "pi"});
  expect_user_error([] { evaluate_number("4*"); }, {"'4*' is not a number", "incomplete"});
  expect_user_error([] { evaluate_number("(1+2"); }, {"'(1+2' is not a number"});
  expect_user_error([] { evaluate_number("0,65"); }, {"'0,65'", "with a point"});
  for (const char *text : {"4 pi", "abc", "1 nm", "1.2.3", "a=3", "3;", "\"x\"", "()", "--", "+-1", "1e", "0.5 0.6"})
    expect_user_error([&] { evaluate_number(text); }, {"'" + std::string(text) + "' is not a number"});
}

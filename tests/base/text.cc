// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exact_text.h>
#include <pellicle/base/text.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

using namespace pellicle;

namespace
{
using Parts = std::vector<std::string>;
}

TEST(Text, CommaSeparatedRespectsParentheses)
{
  EXPECT_EQ(comma_separated(" a, b c ,d"), (Parts{"a", "b c", "d"}));
  EXPECT_EQ(comma_separated("max(1, 2), 3"), (Parts{"max(1, 2)", "3"}));
  EXPECT_EQ(comma_separated("a,,b,"), (Parts{"a", "", "b", ""}));
  EXPECT_EQ(comma_separated("  "), Parts{});
}

TEST(Text, ExactTextReadsBackExactly)
{
  for (const double value : {0.1, 1. / 3., 4. * std::atan(1.), 1e-300, 5e-324, 1.7976931348623157e308, -2.5, 123456789.,
                             1e21, std::nextafter(1., 2.), 0.65})
    EXPECT_EQ(std::strtod(exact_text(value).c_str(), nullptr), value) << exact_text(value);
}

TEST(Text, ExactTextIsShort)
{
  EXPECT_EQ(exact_text(0.1), "0.1");
  EXPECT_EQ(exact_text(0.65), "0.65");
  EXPECT_EQ(exact_text(100000.), "100000");
  EXPECT_EQ(exact_text(-3.), "-3");
  EXPECT_EQ(exact_text(std::numeric_limits<double>::infinity()), "inf");
  EXPECT_EQ(exact_text(1. / 3.), "0.3333333333333333");
}

TEST(Text, ExcerptsAreShortAndPlain)
{
  EXPECT_EQ(excerpt("4*pi"), "4*pi");
  EXPECT_EQ(excerpt("a\tb\x1b\x7f"), "a?b??");
  EXPECT_EQ(excerpt("\xc3\xa4"), "\xc3\xa4");
  EXPECT_EQ(excerpt(std::string(200, 'a')), std::string(200, 'a'));
  EXPECT_EQ(excerpt(std::string(201, 'a')), std::string(197, 'a') + "...");
}

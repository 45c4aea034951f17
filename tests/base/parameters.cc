// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/parameters.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace pellicle;

namespace
{
const double inf = std::numeric_limits<double>::infinity();

struct Drop
{
  double volume = 8., tension = 12., angle = 90.;
  int degree               = 3;
  bool heavy               = true;
  std::string shape        = "cap";
  std::vector<double> axes = {2., 4.};

  void bind(ParameterSection &section)
  {
    section.number("Volume", volume, Range::positive(), dimensions::volume, "V");
    section.number("Tension", tension, Range::any(), dimensions::tension, "gamma");
    section.number("Angle", angle, Range::between(0., 180.), dimensions::none, "theta, degrees");
    section.integer("Degree", degree, 2, 5, "k");
    section.flag("Heavy", heavy, "with gravity");
    section.choice("Shape", shape, {"cap", "sphere"}, "start shape");
    section.numbers("Axes", axes, Range::positive(), dimensions::length, "semi axes");
  }
};
} // namespace

TEST(Range, Contains)
{
  EXPECT_TRUE(Range::any().contains(-1e300));
  EXPECT_FALSE(Range::positive().contains(0.));
  EXPECT_TRUE(Range::positive().contains(5e-324));
  EXPECT_TRUE(Range::non_negative().contains(0.));
  EXPECT_FALSE(Range::non_negative().contains(-5e-324));
  EXPECT_TRUE(Range::between(0., 1.).contains(1.));
  EXPECT_FALSE(Range::between(0., 1.).contains(1.0000000001));
  const Range half_open{0., 1., true, false, false}, upper_open{0., 1., false, true, false};
  EXPECT_FALSE(half_open.contains(0.));
  EXPECT_TRUE(half_open.contains(1.));
  EXPECT_FALSE(upper_open.contains(1.));
}

TEST(Range, InfinityOnlyWhereAllowedAndNeverNan)
{
  const Range open = Range::positive(), with_inf = open.or_infinite();
  EXPECT_FALSE(open.contains(inf));
  EXPECT_FALSE(Range::any().contains(-inf));
  EXPECT_TRUE(with_inf.contains(inf));
  EXPECT_TRUE(with_inf.contains(2.));
  EXPECT_FALSE(with_inf.contains(-inf));
  EXPECT_FALSE(with_inf.contains(0.));
  EXPECT_TRUE(Range::between(0., 1.).or_infinite().contains(inf));
  EXPECT_FALSE(with_inf.contains(std::nan("")));
  EXPECT_FALSE(Range::any().contains(std::nan("")));
}

TEST(Range, Text)
{
  EXPECT_EQ(Range::any().text(), "a number");
  EXPECT_EQ(Range::positive().text(), "a number > 0");
  EXPECT_EQ(Range::non_negative().or_infinite().text(), "a number >= 0 or inf");
  EXPECT_EQ(Range::between(0., 1.).text(), "a number in [0, 1]");
  EXPECT_EQ((Range{0., 180., true, false, false}.text()), "a number in (0, 180]");
  EXPECT_EQ((Range{-inf, 0.5, false, true, false}.text()), "a number < 0.5");
}

TEST(ParameterSection, BindsMembersInOrder)
{
  Drop drop;
  ParameterSection section("Droplet");
  drop.bind(section);
  ASSERT_EQ(section.entries().size(), 7u);
  EXPECT_EQ(section.name(), "Droplet");
  EXPECT_EQ(section.entries()[3].name, "Degree");
  EXPECT_EQ(section.entries()[3].range.text(), "a number in [2, 5]");
  EXPECT_EQ(std::get<double *>(section.entries()[1].target), &drop.tension);
  EXPECT_EQ(section.entries()[5].choices, (std::vector<std::string>{"cap", "sphere"}));
}

TEST(ParameterSection, ScaledDividesByTheUnitOfEachDimension)
{
  const Drop drop;
  const Scales scales{2., 3.}; // length, energy
  const Drop internal = scaled(drop, scales);
  EXPECT_DOUBLE_EQ(internal.volume, 1.);   // 8 / 2^3
  EXPECT_DOUBLE_EQ(internal.tension, 16.); // 12 / (3 / 2^2)
  EXPECT_EQ(internal.angle, 90.);
  EXPECT_EQ(internal.degree, 3);
  EXPECT_EQ(internal.axes, (std::vector<double>{1., 2.}));
  EXPECT_EQ(drop.volume, 8.);
}

TEST(ParameterSection, InfinityStaysInfiniteWhenScaled)
{
  Drop drop;
  drop.tension = inf;
  EXPECT_EQ(scaled(drop, {1e-9, 4e-21}).tension, inf);
}

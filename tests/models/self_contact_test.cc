// SPDX-License-Identifier: LGPL-2.1-or-later
// Poles that come together are reported once when they are near, and once when they have passed each other.
#include <pellicle/base/constants.h>
#include <pellicle/models/self_contact.h>

#include <gtest/gtest.h>

#include <string>

namespace
{
using namespace pellicle;

constexpr double area = 16. * pi; // of a sphere of radius 2

TEST(SelfContact, IsReportedWhenItGetsWorse)
{
  SelfContactWatch watch;
  const auto look = [&](const double thickness) {
    return watch.look({{"area", area}, {"axis_thickness", thickness}}, "Vesicle/Reduced volume = 0.5");
  };
  EXPECT_FALSE(look(0.11)); // .055 of the radius
  const auto near = look(0.09);
  ASSERT_TRUE(near);
  for (const char *words : {"At Vesicle/Reduced volume = 0.5", "poles nearly touch", "0.09", "0.045"})
    EXPECT_NE(near->find(words), std::string::npos) << *near;
  EXPECT_FALSE(look(0.05));
  const auto through = look(-0.01);
  ASSERT_TRUE(through);
  EXPECT_NE(through->find("has gone through itself: axis_thickness is -0.01"), std::string::npos) << *through;
  EXPECT_FALSE(look(-0.02));
}

TEST(SelfContact, IsNoMatterOfToriAndDrops)
{
  SelfContactWatch watch;
  EXPECT_FALSE(watch.look({{"area", area}, {"axis_thickness", 0.}}, ""));
  EXPECT_FALSE(watch.look({{"area", area}}, ""));
  EXPECT_FALSE(watch.look({{"area", area}, {"liquid_gas_area", area}, {"axis_thickness", 0.01}}, ""));
}
} // namespace

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/timing.h>

#include <gtest/gtest.h>

#include <thread>

using namespace pellicle;

namespace
{
void wait_milliseconds(const int n)
{
  std::this_thread::sleep_for(std::chrono::milliseconds(n));
}
} // namespace

TEST(Timing, AddsUpVisitsAndNothingElse)
{
  Timing timing;
  for (int visit = 0; visit < 2; ++visit)
  {
    const Timing::Scope scope(timing, "assembly");
    wait_milliseconds(10);
  }
  const double assembly = timing.seconds("assembly");
  EXPECT_GE(assembly, 0.02);
  wait_milliseconds(10);
  EXPECT_EQ(timing.seconds("assembly"), assembly);
  EXPECT_GE(timing.total(), assembly + 0.01);
  EXPECT_EQ(timing.seconds("output"), 0.);
}

TEST(Timing, NestedVisitsOfOneSectionCountOnce)
{
  Timing timing;
  {
    const Timing::Scope outer(timing, "assembly");
    const Timing::Scope inner(timing, "assembly");
    wait_milliseconds(10);
  }
  EXPECT_GE(timing.seconds("assembly"), 0.01);
  EXPECT_LE(timing.seconds("assembly"), timing.total());
}

TEST(Timing, SectionsInsideEachOtherBothCount)
{
  Timing timing;
  {
    const Timing::Scope outer(timing, "total step");
    const Timing::Scope inner(timing, "linear_solve");
    wait_milliseconds(10);
  }
  EXPECT_GE(timing.seconds("linear_solve"), 0.01);
  EXPECT_GE(timing.seconds("total step"), timing.seconds("linear_solve"));
}

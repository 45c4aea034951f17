// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/solvers/load_stepping.h>

#include <gtest/gtest.h>

#include <vector>

namespace
{
using namespace pellicle;

struct Walk
{
  double reached;
  std::vector<double> tried, succeeded;
};

Walk walk(const int steps, const double smallest, const std::function<bool(double from, double to)> &possible)
{
  LoadParameters parameters;
  parameters.steps         = steps;
  parameters.smallest_step = smallest;
  Walk result;
  double at      = 0.;
  result.reached = walk_load(parameters,
                             [&](const double t)
                             {
                               result.tried.push_back(t);
                               if (!possible(at, t))
                                 return false;
                               result.succeeded.push_back(t);
                               at = t;
                               return true;
                             });
  return result;
}

TEST(LoadStepping, StartsAtZeroGrowsAndEndsAtOneExactly)
{
  for (const int steps : {1, 3, 7, 10, 100})
  {
    const Walk w = walk(steps, 1e-3, [](double, double) { return true; });
    EXPECT_EQ(w.reached, 1.);
    EXPECT_EQ(w.tried.front(), 0.);
    EXPECT_EQ(w.tried.back(), 1.);
    EXPECT_NEAR(w.tried[1], 1. / steps, 1e-15);
    for (std::size_t i = 2; i < w.tried.size(); ++i)
    {
      const double step = w.tried[i] - w.tried[i - 1], before = w.tried[i - 1] - w.tried[i - 2];
      EXPECT_GT(step, 0.);
      EXPECT_LE(step, 1.52 * before + 1e-14);
      EXPECT_LE(step, 4.02 / steps);
    }
  }
  const Walk w = walk(100, 1e-3, [](double, double) { return true; });
  EXPECT_NEAR(w.tried[2] - w.tried[1], 0.015, 1e-14);
  EXPECT_NEAR(w.tried[3] - w.tried[2], 0.0225, 1e-14);
  EXPECT_NEAR(w.tried[7] - w.tried[6], 0.04, 1e-14);
}

TEST(LoadStepping, HalvesStepsThatFail)
{
  const Walk w = walk(2, 1e-3, [](const double from, const double to) { return to - from < 0.2; });
  EXPECT_EQ(w.reached, 1.);
  ASSERT_GE(w.tried.size(), 4u);
  EXPECT_EQ(w.tried[1], 0.5);
  EXPECT_EQ(w.tried[2], 0.25);
  EXPECT_EQ(w.tried[3], 0.125);
  EXPECT_EQ(w.succeeded[1], 0.125);
  EXPECT_EQ(w.succeeded.back(), 1.);
  for (std::size_t i = 1; i < w.succeeded.size(); ++i)
    EXPECT_LT(w.succeeded[i] - w.succeeded[i - 1], 0.2);
}

TEST(LoadStepping, GivesUpBelowTheSmallestStep)
{
  const Walk w = walk(10, 1e-2, [](double, const double to) { return to < 0.45; });
  EXPECT_LT(w.reached, 0.45);
  EXPECT_GT(w.reached, 0.4);
  EXPECT_EQ(w.reached, w.succeeded.back());
  for (std::size_t i = 1; i < w.tried.size(); ++i)
    EXPECT_TRUE(w.tried[i] <= w.reached || w.tried[i] - w.reached >= 1e-2) << w.tried[i];
}

TEST(LoadStepping, FailsAtOnceWithoutAStart)
{
  const Walk w = walk(10, 1e-2, [](double, double) { return false; });
  EXPECT_LT(w.reached, 0.);
  EXPECT_EQ(w.tried, std::vector<double>{0.});
}

TEST(LoadStepping, GoesOnFromWhereItWas)
{
  LoadParameters parameters;
  parameters.steps    = 5;
  const auto possible = [](const double t) { return t < 0.45 || t > 0.55; };
  std::vector<double> tried;
  std::vector<LoadPosition> positions;
  std::vector<std::size_t> n_tried;
  const auto attempt = [&](const double t)
  {
    tried.push_back(t);
    return possible(t);
  };
  const double end = walk_load(parameters, attempt, {},
                               [&](const LoadPosition &position)
                               {
                                 positions.push_back(position);
                                 n_tried.push_back(tried.size());
                               });
  EXPECT_EQ(positions.front().t, 0.);
  EXPECT_EQ(positions.back().t, end);
  const std::vector<double> whole = tried;
  ASSERT_GT(whole.size(), positions.size()); // some failed
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    tried.clear();
    EXPECT_EQ(walk_load(parameters, attempt, positions[i]), end);
    EXPECT_EQ(tried, std::vector<double>(whole.begin() + static_cast<std::ptrdiff_t>(n_tried[i]), whole.end()));
  }
}
} // namespace

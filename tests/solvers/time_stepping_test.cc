// SPDX-License-Identifier: LGPL-2.1-or-later
// Steps in time and the books of energy.
#include "expect_user_error.h"

#include <pellicle/solvers/energy_balance.h>
#include <pellicle/solvers/time_stepping.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace
{
using namespace pellicle;

TEST(TimeStepping, IntervalsEndAtTheEndTime)
{
  TimeParameters time;
  EXPECT_EQ(time.n_intervals(), 0);
  time.end_time = 0.3;
  EXPECT_EQ(time.n_intervals(), 100);
  time.step = 0.1; // 0.3/0.1 is a little less than 3
  EXPECT_EQ(time.n_intervals(), 3);
  EXPECT_EQ(time.time_after(3), 0.3);
  time.step = 0.08;
  EXPECT_EQ(time.n_intervals(), 4);
  EXPECT_EQ(time.time_after(3), 3 * 0.08);
  EXPECT_EQ(time.time_after(4), 0.3);
}

TEST(TimeStepping, ChecksItsNumbers)
{
  TimeParameters time;
  time.step = 1.;
  EXPECT_USER_ERROR(time.check(), "Time/Step = 1", "Time/End time is 0");
  time.end_time = 0.5;
  EXPECT_USER_ERROR(time.check(), "Time/Step = 1", "longer", "0.5");
  time.step = 1e-8;
  EXPECT_USER_ERROR(time.check(), "Time/Step", "million");
  time.step = 0.1;
  time.check();
}

TEST(TimeStepping, HalvesStepsThatFailAndArrives)
{
  std::vector<double> done, tried;
  const auto at_most_3 = [&](const double length)
  {
    tried.push_back(length);
    if (length > 0.3)
      return false;
    done.push_back(length);
    return true;
  };
  EXPECT_TRUE(walk_time(1., 2., 1e-3, at_most_3));
  EXPECT_NEAR(std::accumulate(done.begin(), done.end(), 0.), 1., 1e-14);
  EXPECT_EQ(tried[0], 1.);
  EXPECT_EQ(tried[1], 0.5);
  EXPECT_EQ(done[0], 0.25);
  EXPECT_GT(*std::min_element(done.begin(), done.end()), 1e-3);

  tried.clear();
  EXPECT_FALSE(walk_time(0., 1., 0.1,
                         [&](const double length)
                         {
                           tried.push_back(length);
                           return false;
                         }));
  EXPECT_EQ(tried, (std::vector<double>{1., 0.5, 0.25, 0.125}));
}

// E = y^2/2, D = y'^2/2: y' = y/(1 + dt), and E' + dt D = E/(1 + dt) < E.
TEST(EnergyBalance, MinimisingStepsAreOfFirstOrder)
{
  double last = 0.;
  for (const int n : {10, 20, 40})
  {
    const double dt = 1. / n;
    double y        = 1.;
    EnergyBalance balance(0.5);
    for (int i = 0; i < n; ++i)
    {
      const double next = y / (1. + dt), v = (next - y) / dt;
      y = next;
      balance.add_minimising_step(0.5 * y * y, dt * 0.5 * v * v);
    }
    // E' - E = -v dt (y + y')/2 and 2 dt D = -v dt y': each step loses dt^2 v^2/2 more than it dissipates.
    EXPECT_NEAR(balance.relative_error(), -0.5 * dt, 1e-12);
    if (last != 0.)
    {
      EXPECT_NEAR(balance.relative_error() / last, 0.5, 1e-10);
    }
    last = balance.relative_error();
  }
}

TEST(EnergyBalance, RefusesAStepThatGainsEnergy)
{
  EnergyBalance balance(1.);
  EXPECT_EQ(balance.relative_error(), 0.);
  balance.add_minimising_step(0.8, 0.2 + 1e-13);
  try
  {
    balance.add_minimising_step(0.79, 0.02);
    FAIL();
  }
  catch (const SolveError &error)
  {
    const std::string message = error.what();
    for (const char *part : {"energy law", "0.79", "0.02", "0.8", "Time/Step"})
      EXPECT_NE(message.find(part), std::string::npos) << message;
  }
  EXPECT_THROW(balance.add_minimising_step(std::nan(""), 0.), SolveError);
  balance.set(0.5, 0.49);
  EXPECT_NEAR(balance.relative_error(), -0.01 / 0.49, 1e-14);
}
} // namespace

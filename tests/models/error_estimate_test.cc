// SPDX-License-Identifier: LGPL-2.1-or-later
// Estimates from made-up sequences of which the errors are known.
#include <pellicle/models/accuracy.h>
#include <pellicle/models/error_estimate.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace pellicle;

/** Values 1 + c r^i. */
std::vector<double> geometric(const double c, const double r, const int n)
{
  std::vector<double> values;
  for (int i = 0; i < n; ++i)
    values.push_back(1. + c * std::pow(r, i));
  return values;
}

TEST(ErrorEstimate, GeometricSequencesAreEstimatedExactly)
{
  for (const double r : {0.5, 0.25, 0.01, -0.3})
  {
    const std::vector<double> values = geometric(0.1, r, 6), estimates = estimates_of_sequence(values);
    ASSERT_EQ(estimates.size(), 5u);
    for (std::size_t i = 1; i < estimates.size(); ++i)
    {
      const double error = std::abs(values[i] - 1.);
      EXPECT_NEAR(estimates[i] / error, r > 0. ? 1. : (1. - r) / (1. + r), 1e-6) << r;
      EXPECT_GT(5. * estimates[i], error);
      EXPECT_LT(estimates[i], 5. * error);
    }
    EXPECT_NEAR(expected_error(estimates) / estimates.back(), std::min(1., std::abs(r)), 1e-6);
  }
}

// The third difference is small by accident: the errors are those of the second level still.
TEST(ErrorEstimate, EqualNeighboursProveNothing)
{
  const std::vector<double> estimates = estimates_of_sequence({1.08, 1.04, 1.02, 1.0200001});
  EXPECT_GT(5. * estimates[2], 0.005);
}

TEST(ErrorEstimate, RicherSpaces)
{
  // What the richer space leaves is as much as the ratio so far: half as a first guess, 0.8 at most.
  EXPECT_NEAR(estimate_from({{1e-3, 0.}}), 2e-3, 1e-12);
  EXPECT_NEAR(estimate_from({{1e-3, 0.}, {5e-4, 0.}}), 5e-4 / 0.75, 1e-12);
  EXPECT_NEAR(estimate_from({{1e-3, 0.}, {4e-3, 0.}}), 2e-2, 1e-12);
  EXPECT_NEAR(estimate_from({{0.1, -0.101}, {1e-3, -1.01e-3}}), 1e-5 / (1. - 1e-5 / 2e-3), 1e-9);
}

TEST(ErrorEstimate, WhatLooksPerfectIsAnAccident)
{
  EXPECT_NEAR(estimate_from({{1e-3, -1e-3}}), 2. * 5e-7, 1e-12);
  EXPECT_NEAR(estimate_from({{0., 1e-3}, {0., 1e-9}}), 2e-3 / 400., 1e-7);
}

TEST(ErrorEstimate, NothingIsKnownOfOneLevel)
{
  EXPECT_TRUE(std::isinf(expected_error({})));
  EXPECT_EQ(expected_error({1e-3}), 1e-3);
}

LevelRecord level(const unsigned int degree, const unsigned int refinements, const double error)
{
  return {{degree, refinements}, 24, 1000, 1., error};
}

TEST(NextLevel, SmoothSolutionsGetADegreeAndOthersMoreCells)
{
  const LevelRange range;
  const std::optional<LevelMesh> first = next_level({level(2, 1, 1e-2)}, range);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->degree, 3u);
  EXPECT_EQ(first->refinements, 1u);
  const std::optional<LevelMesh> smooth = next_level({level(2, 1, 1e-2), level(3, 1, 2e-4)}, range);
  EXPECT_EQ(smooth->degree, 4u);
  const std::optional<LevelMesh> rough = next_level({level(2, 1, 1e-2), level(3, 1, 8e-3)}, range);
  EXPECT_EQ(rough->degree, 3u);
  EXPECT_EQ(rough->refinements, 2u);
  EXPECT_EQ(next_level({level(5, 1, 1e-6)}, range)->refinements, 2u);
}

TEST(NextLevel, Ends)
{
  LevelRange range;
  range.highest_degree   = 2;
  range.most_refinements = 1;
  EXPECT_FALSE(next_level({level(2, 1, 1e-2)}, range));
}

TEST(NextLevel, UnknownsGrowWithTheNodes)
{
  LevelRange range;
  EXPECT_NEAR(expected_unknowns(level(2, 1, 0.), {4, 2}, range), 16000., 1e-9);
  range.dimension = 1;
  EXPECT_NEAR(expected_unknowns(level(3, 1, 0.), {3, 3}, range), 4000., 1e-9);
}
} // namespace

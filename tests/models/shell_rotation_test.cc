// SPDX-License-Identifier: LGPL-2.1-or-later
// Large rotations of the pinched hemisphere against Sze, Liu & Lo, Finite Elem. Anal. Des. 40, 1551 (2004).
#include "shell_runs.h"

#include <gtest/gtest.h>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

TEST(PinchedHemisphere, LargeRotationsAreThoseOfTheLiterature)
{
  struct Row
  {
    double force, outward, inward;
  };
  double before    = 0.;
  ShellScene scene = pinched_hemisphere(0., 3, 2);
  Solved run(scene);
  for (const Row &row : {Row{20., 0.855, 0.955},
                         {40., 1.499, 1.840},
                         {80., 2.321, 3.261},
                         {120., 2.819, 4.339},
                         {160., 3.158, 5.196},
                         {200., 3.406, 5.902},
                         {240., 3.598, 6.497},
                         {280., 3.750, 7.006},
                         {320., 3.871, 7.448},
                         {360., 3.970, 7.835},
                         {400., 4.067, 8.178}})
  {
    const double reached = walk(run, 1,
                                [&](const double t)
                                {
                                  effect<PointLoadsEffect>(scene).parameters.force = before + t * (row.force - before);
                                  return std::cref(scene);
                                });
    ASSERT_EQ(reached, 1.) << row.force;
    EXPECT_NEAR(run.quantity("displacement_at_load_point_a"), row.outward, 0.01 * row.outward) << row.force;
    EXPECT_NEAR(run.quantity("displacement_at_load_point_b"), row.inward, 0.01 * row.inward) << row.force;
    before = row.force;
  }
}
} // namespace

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "gap_checks.h"

#include <pellicle/kinematics/rigid_bodies.h>

namespace
{
using namespace pellicle;

TEST(RigidBodies, Plane)
{
  const HalfSpace plane({0., 0., 0.5}, {0., 3., 4.});
  expect_close(plane.gap({7., 0., 1.}).gap, 0.4);
  expect_close(plane.gap({7., 0., 0.}).gap, -0.4);
  check_gap(plane, {0.3, -0.2, 1.1});
}

TEST(RigidBodies, BallFromOutsideAndInside)
{
  const Ball ball({0., 0., -2.}, 1.5), cavity({0., 0., -2.}, 1.5, true);
  expect_close(ball.gap({0., 0., 1.}).gap, 1.5);
  expect_close(ball.gap({0., 0., -1.}).gap, -0.5);
  expect_close(cavity.gap({0., 0., -1.}).gap, 0.5);
  for (const Vector3<double> &x : {Vector3<double>(1., 0.5, 0.3), Vector3<double>(0.4, -0.3, -1.2)})
  {
    check_gap(ball, x);
    check_gap(cavity, x);
  }
  expect_no_gap(ball, {0., 0., -2.}, {"centre", "sphere"});
}

TEST(RigidBodies, TheNearestOfSeveralCounts)
{
  const NearestBody gap_between({std::make_shared<HalfSpace>(Vector3<double>{0., 0., 0.}, Vector3<double>{0., 0., 1.}),
                                 std::make_shared<Ball>(Vector3<double>{0., 0., 3.}, 1.)});
  EXPECT_EQ(gap_between.name(), "plane and sphere");
  expect_close(gap_between.gap({0., 0., 0.5}).gap, 0.5);
  expect_close(gap_between.gap({0., 0., 1.8}).gap, 0.2);
  expect_close(gap_between.gap({0., 0., 1.8}).normal, {0., 0., -1.});
  check_gap(gap_between, {0.2, 0.1, 1.8});
}
} // namespace

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "gap_checks.h"

#include <pellicle/kinematics/box.h>

#include <random>

namespace
{
using namespace pellicle;

const Box &upright()
{
  static const Box box({1., 0., 0.}, {1., 2., 0.5}); // 0 < x < 2, -2 < y < 2, -0.5 < z < 0.5
  return box;
}

TEST(Box, Faces)
{
  const GapSample above = upright().gap({0.5, 1., 0.8});
  expect_close(above.gap, 0.3);
  expect_close(above.normal, {0., 0., 1.});
  const GapSample pressed = upright().gap({0.5, 1., -0.4});
  expect_close(pressed.gap, -0.1);
  expect_close(pressed.normal, {0., 0., -1.});
  const GapSample on_the_face = upright().gap({0.5, 1., 0.5});
  EXPECT_EQ(on_the_face.gap, 0.);
  expect_close(on_the_face.normal, {0., 0., 1.});
  for (const double entry : above.hessian.entries)
    EXPECT_EQ(entry, 0.);
}

TEST(Box, EdgeAndVertex)
{
  const GapSample edge = upright().gap({2.3, 1., 0.9}); // 0.3 and 0.4 beyond the edge along y
  expect_close(edge.gap, 0.5);
  expect_close(edge.normal, {0.6, 0., 0.8});
  expect_close(edge.foot, {2., 1., 0.5});
  expect_close(edge.hessian(0, 0), (1. - 0.36) / 0.5);
  expect_close(edge.hessian(0, 2), -0.48 / 0.5);
  expect_close(edge.hessian(1, 1), 0.);
  const GapSample vertex = upright().gap({2.2, -2.1, -0.7});
  expect_close(vertex.gap, 0.3);
  expect_close(vertex.foot, {2., -2., -0.5});
  expect_close(vertex.hessian(1, 1), (1. - 1. / 9.) / 0.3);
}

TEST(Box, Derivatives)
{
  for (const Vector3<double> &x : {Vector3<double>(0.5, 1., 0.8), Vector3<double>(0.3, 1.2, -0.4),
                                   Vector3<double>(2.3, 1., 0.9), Vector3<double>(2.2, -2.1, -0.7)})
    check_gap(upright(), x, 1e-8);
  const double c = std::cos(0.4), s = std::sin(0.4);
  const Box inclined({0.1, 0.2, -0.3}, {0.6, 0.5, 0.4}, {{{c, 0., -s}, {0., 1., 0.}, {s, 0., c}}});
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1.5, 1.5);
  for (int trial = 0; trial < 40; ++trial)
    check_gap(inclined, {uniform(random), uniform(random), uniform(random)}, 1e-7);
}

// Outside, gap and normal change continuously from face to edge to vertex.
TEST(Box, NormalIsContinuousOutside)
{
  const double d = 1e-9;
  for (const double y : {1., 2. - d, 2.3})
  {
    expect_close(upright().gap({2. - d, y, 0.8}).gap, upright().gap({2. + d, y, 0.8}).gap, 1., 1e-8);
    for (unsigned int i = 0; i < 3; ++i)
      EXPECT_NEAR(upright().gap({2. - d, y, 0.8}).normal[i], upright().gap({2. + d, y, 0.8}).normal[i], 1e-7);
  }
}

TEST(Box, TwoNearestFacesAreRefused)
{
  expect_no_gap(upright(), {1., 0.3, 0.}, {"(1, 0.3, 0)", "box", "two of its faces"}); // between top and bottom
  expect_no_gap(upright(), {1.75, 0., 0.25}, {"two of its faces"});                    // between top and side
  expect_no_gap(upright(), {2., 1., 0.5}, {"two of its faces", "no normal"});          // on an edge
  expect_no_gap(upright(), {2., 2., 0.5}, {"two of its faces"});                       // on a vertex
}
} // namespace

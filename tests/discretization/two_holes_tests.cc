// SPDX-License-Identifier: LGPL-2.1-or-later
// The disc with two holes: sizes, rims, symmetry, cells at the holes, refusals.
#include "expect_user_error.h"

#include <pellicle/base/constants.h>
#include <pellicle/discretization/builders.h>
#include <pellicle/discretization/edge_loops.h>
#include <pellicle/discretization/surface_quality.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
using namespace pellicle;

TEST(DiscWithTwoHoles, AreaAndRims)
{
  for (const double distance : {4.2, 6., 20.})
  {
    const DiscWithTwoHoles disc{2., distance, 15., 0.3};
    double coarse = 0.;
    for (const unsigned int r : {0u, 1u})
    {
      const SurfaceDiscretization d = disc_with_two_holes(disc, 3, r);
      EXPECT_EQ(d.n_cells, 192u << (2 * r));
      const SurfaceQuality quality = surface_quality(d, d.positions);
      EXPECT_GT(quality.min_cell_quality, 0.) << distance;
      const double error = std::abs(quality.area / (pi * (225. - 8.)) - 1.);
      EXPECT_LT(error, r == 0 ? 1e-2 : coarse / 40.) << distance;
      coarse = error;

      ASSERT_EQ(d.edges.size(), 3u);
      const struct
      {
        const char *name;
        double x, radius;
      } rims[] = {{"right hole", 0.5 * distance, 2.}, {"left hole", -0.5 * distance, 2.}, {"ring", 0., 15.}};
      for (std::size_t i = 0; i < 3; ++i)
      {
        const EdgeLoop &loop = d.edges[i];
        EXPECT_EQ(loop.name, rims[i].name);
        EXPECT_TRUE(loop.is_rim);
        EXPECT_EQ(loop.n_cells, 16u << r);
        for (const std::size_t I : loop.cell_nodes)
        {
          EXPECT_NEAR(std::hypot(d.positions[3 * I] - rims[i].x, d.positions[3 * I + 1]), rims[i].radius, 1e-13);
          EXPECT_EQ(d.positions[3 * I + 2], 0.);
        }
        EXPECT_NEAR(loop_length(loop, d.positions), 2. * pi * rims[i].radius, 1e-3 * rims[i].radius);
        // The surface is on the left: counterclockwise around the whole, clockwise around holes.
        const Vector3<double> nu = conormals(d, loop, d.positions)[0];
        const double *first      = &d.positions[3 * loop.cell_nodes[0]];
        EXPECT_GT((i == 2 ? 1. : -1.) * ((first[0] - rims[i].x) * nu[0] + first[1] * nu[1]), 0.);
      }
    }
  }
}

TEST(DiscWithTwoHoles, CellsAtTheHoles)
{
  // The first node away from the first hole, along the ray away from the second one: cells are nearly as small as
  // asked.
  const SurfaceDiscretization d = disc_with_two_holes({1., 4., 20., 0.1}, 2, 1);
  double nearest                = 1.;
  for (std::size_t I = 0; I < d.n_nodes; ++I)
    if (std::abs(d.positions[3 * I + 1]) < 1e-12 && d.positions[3 * I] > 3. + 1e-9)
      nearest = std::min(nearest, d.positions[3 * I] - 3.);
  EXPECT_LT(nearest, 0.05);
  EXPECT_GT(nearest, 0.03);
}

TEST(DiscWithTwoHoles, MistakesAreRefused)
{
  EXPECT_USER_ERROR(disc_with_two_holes({1., 2., 20., 0.}, 3, 0), "distance 2", "larger than 2");
  EXPECT_USER_ERROR(disc_with_two_holes({1., 6., 4., 0.}, 3, 0), "disc of radius 4", "larger than 4");
  EXPECT_USER_ERROR(disc_with_two_holes({0., 6., 20., 0.}, 3, 0), "holes of radius 0");
}
} // namespace

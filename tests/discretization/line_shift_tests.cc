// SPDX-License-Identifier: LGPL-2.1-or-later
// How the mesh of a soft substrate follows the contact line over the material.
#include "ridge_checks.h"

#include <pellicle/discretization/bodies.h>
#include <pellicle/discretization/line_shift.h>

#include <gtest/gtest.h>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

std::vector<SurfaceDiscretization> ridges(const double half_width = 2., const double thickness = 1.)
{
  RidgeShape shape;
  shape.cap_volume = 2.;
  shape.cell_size  = .025;
  shape.half_width = half_width;
  shape.thickness  = thickness;
  std::vector<SurfaceDiscretization> list{axial_ridge(shape)};
  for (const auto outline : {RidgePlanShape::Outline::block, RidgePlanShape::Outline::cylinder})
    for (const bool half : {false, true})
    {
      RidgePlanShape plan;
      plan.outline = outline;
      plan.half    = half;
      list.push_back(ridge_in_space(shape, plan));
    }
  return list;
}

NodalVectors shifted(const SurfaceDiscretization &ridge, const LineShift &shift, const double s)
{
  NodalVectors x = ridge.positions;
  for (std::size_t I = 0; I < ridge.n_nodes; ++I)
    for (unsigned int c = 0; c < 3; ++c)
      x[3 * I + c] += s * shift.weight[I] * shift.direction[3 * I + c];
  return x;
}

TEST(LineShift, CutoffIsSmooth)
{
  for (const double reach : {.95, .7, .3, 3.})
  {
    EXPECT_EQ(shift_cutoff(0., reach, 1.), 1.);
    EXPECT_EQ(shift_cutoff(reach, reach, 1.), 0.);
    EXPECT_GT(shift_cutoff(.999 * reach, reach, 1.), 0.);
    // The second difference quotient is continuous: third differences are small as h^3.
    const double h = 1e-3 * reach;
    for (double d = 2. * h; d < 1.1 * reach; d += h)
    {
      const auto w = [&](const double x) { return shift_cutoff(x, reach, 1.); };
      EXPECT_LT(std::abs(w(d + h) - 3. * w(d) + 3. * w(d - h) - w(d - 2. * h)), 1e3 * std::pow(h / reach, 3));
      EXPECT_LE(w(d + h), w(d));
    }
  }
  EXPECT_EQ(shift_cutoff(.35, .95, 1.), 1.);
  EXPECT_LT(shift_cutoff(.36, .95, 1.), 1.);
}

TEST(LineShift, IsRigidNearTheLineAndZeroAtTheBoundary)
{
  for (const SurfaceDiscretization &ridge : ridges())
  {
    const LineShift shift = line_shift(ridge);
    const BulkPart &body  = ridge.bulks.front();
    const double rigid    = .16;
    for (const std::size_t I : body.cell_nodes)
    {
      const double r = distance_from_axis(ridge, I), depth = -ridge.positions[3 * I + 2];
      if (std::abs(r - 1.) < rigid && depth < .35)
      {
        EXPECT_EQ(shift.weight[I], 1.);
      }
      if (r < .05)
      {
        EXPECT_EQ(shift.weight[I], 0.);
      }
    }
    for (const char *face : {"side", "bottom"})
      for (const std::size_t I : body.faces.at(face))
        EXPECT_EQ(shift.weight[I], 0.);
  }
}

TEST(LineShift, LeavesTheCellsAtTheOuterEdgeWhereTheyAre)
{
  for (const double half_width : {1.2, 2., 5.})
    for (const SurfaceDiscretization &ridge : ridges(half_width))
    {
      const LineShift shift = line_shift(ridge);
      const BulkPart &body  = ridge.bulks.front();
      const std::set<std::size_t> side(body.faces.at("side").begin(), body.faces.at("side").end()),
          top(body.faces.at("top").begin(), body.faces.at("top").end());
      const std::size_t n        = body.tables.n_nodes;
      std::size_t n_cells_inside = 0;
      for (std::size_t cell = 0; cell < body.n_cells; ++cell)
      {
        const std::vector<std::size_t> nodes(body.cell_nodes.begin() + static_cast<std::ptrdiff_t>(cell * n),
                                             body.cell_nodes.begin() + static_cast<std::ptrdiff_t>((cell + 1) * n));
        const bool at_edge = std::any_of(nodes.begin(), nodes.end(),
                                         [&](const std::size_t I) { return side.count(I) + top.count(I) == 2; });
        for (const std::size_t I : nodes)
          if (at_edge)
          {
            EXPECT_EQ(shift.weight[I], 0.);
          }
          else if (shift.weight[I] > 0. && distance_from_axis(ridge, I) > 1.)
            ++n_cells_inside;
      }
      EXPECT_GT(n_cells_inside, 100u);
    }
}

TEST(LineShift, NodesFollowTheNodeOfTheLineOnTheirMeridianPlane)
{
  for (const SurfaceDiscretization &ridge : ridges())
  {
    const LineShift shift = line_shift(ridge);
    const auto &line      = ridge.edges.front().cell_nodes;
    const std::set<std::size_t> ring(line.begin(), line.end());
    const std::set<std::size_t> in_body(ridge.bulks.front().cell_nodes.begin(), ridge.bulks.front().cell_nodes.end());
    std::size_t n_followers = 0;
    for (std::size_t I = 0; I < ridge.n_nodes; ++I)
    {
      const std::size_t leader = shift.leader[I];
      const Vector3<double> nu(shift.direction[3 * I], shift.direction[3 * I + 1], shift.direction[3 * I + 2]);
      if (shift.weight[I] == 0.)
      {
        EXPECT_EQ(leader, I);
        EXPECT_EQ(norm(nu), 0.);
        continue;
      }
      EXPECT_EQ(in_body.count(I), 1u);
      EXPECT_EQ(ring.count(leader), 1u);
      EXPECT_NEAR(norm(nu), 1., 1e-14);
      EXPECT_NEAR(norm(cross(nu, place(ridge, leader))), 0., 1e-14);
      EXPECT_GT(dot(nu, place(ridge, leader)), 0.);
      EXPECT_NEAR(cross(nu, place(ridge, I))[2], 0., 1e-13); // in the plane
      n_followers += leader == I ? 0 : 1;
    }
    for (const std::size_t node : ring)
    {
      EXPECT_EQ(shift.leader[node], node);
      EXPECT_EQ(shift.weight[node], 1.);
    }
    EXPECT_GT(n_followers, 50 * ring.size());
  }
}

TEST(LineShift, JacobiansStayPositive)
{
  for (const SurfaceDiscretization &ridge : ridges())
  {
    const LineShift shift = line_shift(ridge);
    const double volume   = body_measures(ridge.bulks.front(), ridge.positions).volume;
    for (const double s : {-.25, -.15, .15, .3})
    {
      const BodyMeasures moved = body_measures(ridge.bulks.front(), shifted(ridge, shift, s));
      EXPECT_GT(moved.worst_jacobian, 0.) << s;
      EXPECT_NEAR(moved.volume, volume, 1e-11); // the boundary stays where it is
    }
  }
}

TEST(LineShift, IsTheSameWithPressuresInTheBody)
{
  for (SurfaceDiscretization &ridge : ridges())
  {
    const LineShift before = line_shift(ridge);
    add_pressure_nodes(ridge, 0);
    const LineShift after = line_shift(ridge);
    ASSERT_EQ(after.weight.size(), ridge.n_nodes);
    for (std::size_t I = 0; I < ridge.n_nodes; ++I)
    {
      EXPECT_EQ(after.weight[I], I < before.weight.size() ? before.weight[I] : 0.);
      EXPECT_EQ(after.leader[I], I < before.leader.size() ? before.leader[I] : I);
    }
  }
}

TEST(LineShift, ShrinksWithTheRoom)
{
  for (const SurfaceDiscretization &ridge : ridges(1.2, .3))
  {
    const LineShift shift = line_shift(ridge);
    for (const char *face : {"side", "bottom"})
      for (const std::size_t I : ridge.bulks.front().faces.at(face))
        EXPECT_EQ(shift.weight[I], 0.);
    for (const double s : {-.04, .04})
      EXPECT_GT(body_measures(ridge.bulks.front(), shifted(ridge, shift, s)).worst_jacobian, 0.) << s;
  }
}
} // namespace

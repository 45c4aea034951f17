// SPDX-License-Identifier: LGPL-2.1-or-later
// A region around the north pole of a closed shape: its area, the line around it, sizes of cells.
#include "curvature_error.h"
#include "expect_user_error.h"

#include <pellicle/base/constants.h>
#include <pellicle/discretization/builders.h>
#include <pellicle/discretization/start_shapes.h>
#include <pellicle/discretization/surface_quality.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace
{
using namespace pellicle;

StartShape start(const std::string &name, const unsigned int degree, const unsigned int refinements, const bool axial,
                 const double fraction)
{
  StartShape shape;
  shape.name            = name;
  shape.degree          = degree;
  shape.refinements     = refinements;
  shape.axial           = axial;
  shape.reduced_volume  = name == "stomatocyte" ? .62 : .8;
  shape.region_fraction = fraction;
  return shape;
}

/** Area of the cells in region "domain" and of all others. */
std::array<double, 2> areas(const SurfaceDiscretization &d)
{
  std::array<double, 2> sum{{0., 0.}};
  std::vector<double> in(d.tables.n_points * 18);
  for (std::size_t cell = 0; cell < d.n_cells; ++cell)
  {
    evaluate_field(d.tables, &d.cell_nodes[cell * d.n_local()], d.positions, 3, in.data());
    for (unsigned int q = 0; q < d.tables.n_points; ++q)
    {
      const double *v = &in[q * 18];
      sum[d.region_names[d.cell_region[cell]] == "domain" ? 0 : 1] +=
          d.tables.weights[q] * norm(cross(Vector3<double>(v[3], v[4], v[5]), Vector3<double>(v[6], v[7], v[8])));
    }
  }
  return sum;
}

TEST(Region, HasItsShareOfTheArea)
{
  for (const std::string name : {"ellipsoid", "prolate", "oblate", "biconcave", "stomatocyte"})
    for (const double fraction : {.1, .56, .9})
    {
      SCOPED_TRACE(name + " " + std::to_string(fraction));
      const auto axial = areas(make_start_shape(start(name, 5, 5, true, fraction)));
      EXPECT_NEAR(axial[0] / (4. * pi), fraction, name == "stomatocyte" ? 1e-7 : 2e-12);
      const auto surface = areas(make_start_shape(start(name, 3, 2, false, fraction)));
      EXPECT_NEAR(surface[0] / (4. * pi), fraction, name == "stomatocyte" ? 2e-3 : 2e-5);
      EXPECT_NEAR(surface[1] / (4. * pi), 1. - fraction, name == "stomatocyte" ? 2e-3 : 2e-5);
    }
}

TEST(Region, OfAnEllipsoidWithThreeAxes)
{
  StartShape shape = start("ellipsoid", 5, 2, false, .3);
  shape.semi_axes  = {{1., .6, 1.4}};
  EXPECT_NEAR(areas(make_start_shape(shape))[0] / (4. * pi), .3, 1e-8);
}

TEST(Region, OfASphereEndsAtTheKnownAngle)
{
  // 2 pi (1 - cos psi) = 4 pi f; sin psi = 0.8 at f = 0.2.
  for (const bool axial : {false, true})
  {
    const SurfaceDiscretization d = make_start_shape(start("ellipsoid", 3, 2, axial, .2));
    ASSERT_EQ(d.edges.size(), 1u);
    const EdgeLoop &line = d.edges[0];
    EXPECT_EQ(line.name, "domain boundary");
    EXPECT_FALSE(line.is_rim);
    EXPECT_TRUE(d.is_closed());
    EXPECT_EQ(d.region_names, (std::vector<std::string>{"membrane", "domain"}));
    EXPECT_EQ(d.cell_region.size(), d.n_cells);
    EXPECT_EQ(line.n_cells, axial ? 1u : 32u);
    for (const std::size_t n : line.cell_nodes)
    {
      EXPECT_NEAR(std::hypot(d.positions[3 * n], d.positions[3 * n + 1]), .8, 1e-12);
      EXPECT_NEAR(d.positions[3 * n + 2], .6, 1e-12);
    }
    EXPECT_NEAR(loop_length(line, d.positions), 1.6 * pi, axial ? 1e-11 : 1e-7);
    std::vector<double> in(line.tables.n_points * 18);
    const auto nu = conormals(d, line, d.positions);
    for (std::size_t c = 0; c < line.n_cells; ++c)
    {
      EXPECT_EQ(d.cell_region[line.sides[c].cell], 1u);
      evaluate_field(line.tables, &line.cell_nodes[c * line.tables.n_nodes], d.positions, 2, in.data());
      for (unsigned int q = 0; q < line.tables.n_points; ++q)
      {
        const double *v = &in[q * 18];
        const double r  = std::hypot(v[0], v[1]);
        EXPECT_NEAR((v[0] * v[4] - v[1] * v[3]) / (r * norm(Vector3<double>(v[3], v[4], v[5]))), 1., 1e-5); // e_phi
        const Vector3<double> out(.6 * v[0] / r, .6 * v[1] / r, -.8); // southwards
        EXPECT_LT(norm(nu[c * line.tables.n_points + q] - out), 3e-3);
      }
    }
  }
}

TEST(Region, MeshIsClosedAndSpreadsItsNodes)
{
  for (const std::string name : {"ellipsoid", "prolate", "oblate", "stomatocyte"})
    for (const double fraction : {.02, .3, .5, .8})
      for (const unsigned int degree : {2u, 3u})
      {
        SCOPED_TRACE(name + " " + std::to_string(fraction));
        const SurfaceDiscretization d = make_start_shape(start(name, degree, 1, false, fraction));
        EXPECT_EQ(euler_characteristic(d), 2);
        EXPECT_EQ(d.n_nodes, d.n_cells * degree * degree + 2); // every edge shared by two cells
        EXPECT_EQ(d.n_cells % 4, 0u);
        EXPECT_EQ(d.rigid_motions.size(), 6u);
        const std::size_t n_domain = std::count(d.cell_region.begin(), d.cell_region.end(), 1u);
        EXPECT_GE(n_domain, 12u * 4u);
        std::set<std::array<double, 3>> places;
        for (std::size_t n = 0; n < d.n_nodes; ++n)
          places.insert({{std::round(1e9 * d.positions[3 * n]) + 0., std::round(1e9 * d.positions[3 * n + 1]) + 0.,
                          std::round(1e9 * d.positions[3 * n + 2]) + 0.}});
        EXPECT_EQ(places.size(), d.n_nodes);
        const SurfaceQuality q = surface_quality(d, d.positions);
        EXPECT_GT(q.volume, 0.);
        EXPECT_GT(q.min_cell_quality, name == "stomatocyte" ? .5 : .55);
        EXPECT_LT(q.largest_aspect, name == "stomatocyte" ? 8. : 3.5);
      }
}

TEST(Region, CurvatureOfTheSphereConvergesAtTheDegree)
{
  for (const unsigned int k : {2u, 3u, 4u})
  {
    const double coarse = curvature_error(make_start_shape(start("ellipsoid", k, 1, false, .2)), 1., {}),
                 fine   = curvature_error(make_start_shape(start("ellipsoid", k, 2, false, .2)), 1., {});
    EXPECT_GT(std::log2(coarse / fine), k - .2) << k << ": " << coarse << " " << fine;
  }
}

TEST(Region, MeridianHasANodeOnTheLineAndComparableCells)
{
  for (const std::string name : {"ellipsoid", "prolate", "oblate", "biconcave", "stomatocyte"})
    for (unsigned int r = 0; r <= 3; ++r)
      for (const double fraction : {.03, .2, .5, .85})
      {
        SCOPED_TRACE(name + " " + std::to_string(fraction));
        const SurfaceDiscretization d = make_start_shape(start(name, 3, r, true, fraction));
        ASSERT_EQ(d.n_cells, 4u << r);
        const std::size_t within = std::count(d.cell_region.begin(), d.cell_region.end(), 1u);
        EXPECT_GE(within, 1u << r);
        EXPECT_LE(within, 3u << r);
        for (std::size_t cell = 0; cell < d.n_cells; ++cell)
          EXPECT_EQ(d.cell_region[cell], cell < within ? 1u : 0u);
        EXPECT_EQ(d.edges.at(0).cell_nodes, (std::vector<std::size_t>{3 * within}));
        EXPECT_EQ(d.edges[0].tables.tables[1][0], 1.);
        EXPECT_EQ(d.admissible.front().count, 1u);
        EXPECT_EQ(d.admissible.back().count, 1u);
        EXPECT_EQ(d.rigid_motions.size(), 1u);
        EXPECT_EQ(euler_characteristic(d), 2);

        const auto length = [&](const std::size_t cell)
        {
          const double *a = &d.mesh_reference[9 * cell], *b = a + 9;
          return std::hypot(b[0] - a[0], b[2] - a[2]);
        };
        if (name == "ellipsoid" && r > 0)
          for (std::size_t cell = 1; cell < d.n_cells; ++cell)
          {
            EXPECT_LT(length(cell) / length(cell - 1), 2.) << cell;
            EXPECT_GT(length(cell) / length(cell - 1), .5) << cell;
          }
      }
}

TEST(Region, MistakesAreRefused)
{
  for (const double fraction : {-.1, 1., 1.5, std::nan("")})
    for (const bool axial : {false, true})
      EXPECT_USER_ERROR(make_start_shape(start("prolate", 3, 1, axial, fraction)),
                        "Region fraction = ", "strictly between 0 and 1");
  EXPECT_USER_ERROR(make_start_shape(start("torus", 3, 1, false, .2)), "Region fraction = 0.2", "no north pole");
  StartShape mirrored = start("prolate", 3, 1, true, .2);
  mirrored.mirror     = true;
  EXPECT_USER_ERROR(make_start_shape(mirrored), "Region fraction = 0.2", "mirror image", "whole meridian");
}
} // namespace

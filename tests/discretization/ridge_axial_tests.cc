// SPDX-License-Identifier: LGPL-2.1-or-later
// The meridian of a drop on a soft substrate.
#include "expect_user_error.h"
#include "ridge_checks.h"

#include <pellicle/base/constants.h>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

RidgeShape paper_shape(const double cell_size = .025, const unsigned int degree = 2)
{
  RidgeShape shape;
  shape.cap_volume = 2.;
  shape.cell_size  = cell_size;
  shape.degree     = degree;
  return shape;
}

TEST(RidgeCap, HasTheAngleOfItsVolume)
{
  EXPECT_NEAR(cap_angle(2. * pi / 3., 1.), .5 * pi, 1e-14); // a hemisphere
  EXPECT_NEAR(cap_angle(4. * pi / 3. * 1e6, 1e-3), pi, 1e-4);
  // V = 2 on a circle of radius 1: height and radius by an independent solution of the cubic.
  const double angle = cap_angle(2., 1.);
  EXPECT_NEAR(std::tan(.5 * angle), .9694924837, 1e-10);
  EXPECT_NEAR(1. / std::sin(angle), 1.0004799978, 1e-10);
}

TEST(AxialRidge, AreasAndVolumesOfItsParts)
{
  for (const unsigned int degree : {1u, 2u, 3u, 4u, 5u})
  {
    SCOPED_TRACE(degree);
    const RidgeShape shape            = paper_shape(.025, degree);
    const SurfaceDiscretization ridge = axial_ridge(shape);
    // Straight parts are exact; the cap is a polynomial of degree k through points of a circle.
    const double tolerance   = std::array<double, 5>{{4e-3, 4e-6, 2e-8, 1e-10, 1e-10}}[degree - 1];
    const RegionMeasures cap = region_measures(ridge, cap_region), wetted = region_measures(ridge, wetted_region),
                         dry = region_measures(ridge, dry_region);
    EXPECT_NEAR(cap.area, cap_area(shape), tolerance * cap_area(shape));
    EXPECT_NEAR(cap.projected, pi, 1e-12);
    EXPECT_NEAR(wetted.area, pi, 1e-12);
    EXPECT_NEAR(wetted.projected, -pi, 1e-12); // n points out of the liquid
    EXPECT_NEAR(dry.area, 3. * pi, 1e-11);
    EXPECT_NEAR(dry.projected, 3. * pi, 1e-11);
    EXPECT_NEAR(cap.volume + wetted.volume, 2., tolerance * 2.);

    const BodyMeasures body = body_measures(ridge.bulks.front(), ridge.positions);
    EXPECT_NEAR(body.volume, 4. * pi, 1e-11);
    EXPECT_GT(body.worst_jacobian, 0.);
  }
}

TEST(AxialRidge, PartsShareTheirNodes)
{
  const SurfaceDiscretization ridge = axial_ridge(paper_shape(.05, 3));
  EXPECT_EQ(ridge.kind, SurfaceDiscretization::Kind::meridian);
  EXPECT_EQ(ridge.region_names, (std::vector<std::string>{"liquid gas", "solid liquid", "solid gas"}));
  ASSERT_EQ(ridge.bulks.size(), 1u);
  const BulkPart &body = ridge.bulks.front();
  EXPECT_EQ(body.name, "substrate");

  ASSERT_EQ(ridge.edges.size(), 1u);
  const EdgeLoop &line = ridge.edges.front();
  EXPECT_EQ(line.name, "contact line");
  EXPECT_FALSE(line.is_rim);
  EXPECT_TRUE(line.is_junction);
  ASSERT_EQ(line.cell_nodes.size(), 1u);
  const std::size_t ring = line.cell_nodes.front();
  EXPECT_EQ(place(ridge, ring)[0], 1.);
  EXPECT_EQ(place(ridge, ring)[2], 0.);
  EXPECT_EQ(ridge.cell_region[line.sides.front().cell], cap_region);

  const std::vector<std::size_t> &top = body.faces.at("top");
  EXPECT_EQ(region_nodes(ridge, {wetted_region, dry_region}), std::set<std::size_t>(top.begin(), top.end()));
  const std::set<std::size_t> cap = region_nodes(ridge, {cap_region}), wetted = region_nodes(ridge, {wetted_region}),
                              dry = region_nodes(ridge, {dry_region});
  std::set<std::size_t> common;
  std::set_intersection(cap.begin(), cap.end(), wetted.begin(), wetted.end(), std::inserter(common, common.end()));
  EXPECT_EQ(common, std::set<std::size_t>{ring});
  EXPECT_EQ(dry.count(ring), 1u);
  const std::set<std::size_t> in_body(body.cell_nodes.begin(), body.cell_nodes.end());
  EXPECT_EQ(in_body.size() + cap.size() - 1, ridge.n_nodes);
  for (std::size_t I = 0; I < ridge.n_nodes; ++I)
    EXPECT_EQ(ridge.admissible[I].count, place(ridge, I)[0] == 0. ? 1u : 2u);
}

TEST(AxialRidge, RunsFromThePoleToTheRingToTheAxisAndOutwards)
{
  const SurfaceDiscretization ridge = axial_ridge(paper_shape());
  for (std::size_t cell = 0; cell < ridge.n_cells; ++cell)
  {
    const std::size_t *const nodes = &ridge.cell_nodes[cell * ridge.n_local()];
    for (unsigned int i = 0; i < ridge.degree; ++i)
    {
      const double step = place(ridge, nodes[i + 1])[0] - place(ridge, nodes[i])[0];
      EXPECT_GT(ridge.cell_region[cell] == wetted_region ? -step : step, 0.);
    }
    if (cell > 0 && ridge.cell_region[cell] != dry_region)
    {
      EXPECT_EQ(nodes[0], nodes[-1]); // the line goes on
    }
  }
}

TEST(AxialRidge, CellsGrowAwayFromTheLineDownToAThousandthOfTheRadius)
{
  for (const double size : {.1, .02, 1e-3, 1e-5})
    for (const double growth : {1.3, 1.5, 2.})
    {
      RidgeShape shape                  = paper_shape(size);
      shape.growth                      = growth;
      const SurfaceDiscretization ridge = axial_ridge(shape);
      EXPECT_GT(body_measures(ridge.bulks.front(), ridge.positions).worst_jacobian, 0.);
      EXPECT_LT(ridge.n_nodes, 15000u);
      std::set<double> radii, heights;
      for (const std::size_t node : ridge.bulks.front().cell_nodes)
      {
        radii.insert(place(ridge, node)[0]);
        if (place(ridge, node)[0] == 1.)
          heights.insert(place(ridge, node)[2]);
      }
      const std::vector<double> r(radii.begin(), radii.end()), z(heights.begin(), heights.end());
      const auto at = static_cast<std::size_t>(std::find(r.begin(), r.end(), 1.) - r.begin());
      ASSERT_LT(at, r.size());
      const double beside = r[at + 2] - r[at], within = r[at] - r[at - 2], below = z[z.size() - 1] - z[z.size() - 3];
      for (const double first : {beside, within, below})
      {
        EXPECT_LE(first, size * (1. + 1e-9));
        EXPECT_GT(first, .75 * size);
      }
      const auto check_row = [&](const std::vector<double> &ends)
      {
        for (std::size_t i = 4; i < ends.size(); i += 2)
        {
          const double ratio = (ends[i] - ends[i - 2]) / (ends[i - 2] - ends[i - 4]);
          EXPECT_LT(std::max(ratio, 1. / ratio), growth * (1. + 1e-6));
          EXPECT_LT(ends[i] - ends[i - 2], .3);
        }
      };
      check_row(r);
      check_row(z);
    }
}

// Thin cells at the outer edge, on which the skin pulls, would fold.
TEST(AxialRidge, CellsAreCoarseAtTheAxisAndAtTheOuterEdge)
{
  for (const double size : {.1, .02, 1e-3, 1e-5})
    for (const unsigned int degree : {1u, 2u, 3u})
    {
      const SurfaceDiscretization ridge = axial_ridge(paper_shape(size, degree));
      const BulkPart &body              = ridge.bulks.front();
      EXPECT_GT(body_measures(body, ridge.positions).worst_jacobian, .02);
      for (const double r : {0., 2.})
      {
        std::vector<double> z;
        for (const std::size_t node : std::set<std::size_t>(body.cell_nodes.begin(), body.cell_nodes.end()))
          if (place(ridge, node)[0] == r)
            z.push_back(place(ridge, node)[2]);
        std::sort(z.begin(), z.end());
        EXPECT_EQ(z.front(), -1.);
        EXPECT_EQ(z.back(), 0.);
        EXPECT_GT(-z[z.size() - 1 - degree], .2);
        EXPECT_LT(-z[z.size() - 1 - degree], .3);
        for (std::size_t i = degree; i + degree < z.size(); i += degree) // no smaller than a third of the one above
          EXPECT_GT(3.01 * (z[i] - z[i - degree]), z[i + degree] - z[i]);
      }
    }
}

TEST(AxialRidge, RefusesWhatHasNoMesh)
{
  RidgeShape shape = paper_shape();
  shape.half_width = 1.;
  EXPECT_USER_ERROR(axial_ridge(shape),
                    "The ring of radius 1 touches the lateral faces of a substrate of half width 1:", "wider");
  shape.half_width = .5;
  EXPECT_USER_ERROR(axial_ridge(shape), "The ring of radius 1 reaches beyond the lateral faces");
  EXPECT_USER_ERROR(axial_ridge(paper_shape(.4)), "Cell size = 0.4", "between 1e-06 and 0.25");
  EXPECT_USER_ERROR(axial_ridge(paper_shape(1e-7)), "Cell size = 1e-07");
  EXPECT_USER_ERROR(axial_ridge(paper_shape(.025, 6)), "Degree = 6", "from 1 to 5");
  EXPECT_USER_ERROR(axial_ridge(paper_shape(.025, 0)), "Degree = 0");
  shape            = paper_shape();
  shape.cap_volume = 0.;
  EXPECT_USER_ERROR(axial_ridge(shape), "Volume of the drop = 0");
  shape.cap_volume = 2e12;
  EXPECT_USER_ERROR(axial_ridge(shape), "Volume of the drop = 2000000000000", "at most 1000000000000");
  shape        = paper_shape();
  shape.growth = 1.;
  EXPECT_USER_ERROR(axial_ridge(shape), "Growth of cells = 1", "1.01 and 3");
}
} // namespace

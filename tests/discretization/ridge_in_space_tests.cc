// SPDX-License-Identifier: LGPL-2.1-or-later
// A drop on a soft block or cylinder in space.
#include "expect_user_error.h"
#include "ridge_checks.h"

#include <pellicle/base/constants.h>
#include <pellicle/discretization/edge_loops.h>

#include <map>

namespace
{
using namespace pellicle;
using namespace pellicle::test;
using Outline = RidgePlanShape::Outline;

RidgeShape paper_shape(const double cell_size = .025, const unsigned int degree = 2)
{
  RidgeShape shape;
  shape.cap_volume = 2.;
  shape.cell_size  = cell_size;
  shape.degree     = degree;
  return shape;
}

RidgePlanShape plan(const Outline outline, const bool half, const unsigned int n_around = 16)
{
  RidgePlanShape result;
  result.outline  = outline;
  result.half     = half;
  result.n_around = n_around;
  return result;
}

std::size_t n_free(const SurfaceDiscretization &ridge)
{
  std::size_t n = ridge.admissible.empty() ? 3 * ridge.n_nodes : 0;
  for (const AdmissibleDirections &directions : ridge.admissible)
    n += directions.count;
  return n;
}

TEST(RidgeInSpace, AreasAndVolumesOfItsParts)
{
  for (const unsigned int degree : {1u, 2u, 3u})
    for (const bool half : {false, true})
    {
      SCOPED_TRACE(std::to_string(degree) + (half ? " half" : " whole"));
      const RidgeShape shape            = paper_shape(.1, degree);
      const SurfaceDiscretization block = ridge_in_space(shape, plan(Outline::block, half)),
                                  tube  = ridge_in_space(shape, plan(Outline::cylinder, half));
      // Of polynomials of degree k through points of a circle, an eighth of a quarter each, and of a sphere.
      const double circle = std::array<double, 3>{{.03, 6e-5, 6e-7}}[degree - 1],
                   sphere = std::array<double, 3>{{.04, 2e-4, 2e-5}}[degree - 1];
      for (const SurfaceDiscretization *ridge : {&block, &tube})
      {
        const RegionMeasures cap = region_measures(*ridge, cap_region), wetted = region_measures(*ridge, wetted_region);
        EXPECT_NEAR(cap.area, cap_area(shape), sphere * cap_area(shape));
        EXPECT_NEAR(wetted.area, pi, circle * pi);
        EXPECT_NEAR(wetted.projected, -wetted.area, 1e-12);
        EXPECT_NEAR(cap.projected, wetted.area, 1e-12); // they meet without a gap
        EXPECT_NEAR(cap.volume + wetted.volume, 2., sphere * 2.);
        EXPECT_GT(body_measures(ridge->bulks.front(), ridge->positions).worst_jacobian, .1);
      }
      EXPECT_NEAR(body_measures(block.bulks.front(), block.positions).volume, 16., 1e-11);
      const RegionMeasures dry = region_measures(block, dry_region);
      EXPECT_NEAR(dry.projected + region_measures(block, wetted_region).area, 16., 1e-11);
      EXPECT_NEAR(dry.area, dry.projected, 1e-11);
      EXPECT_NEAR(body_measures(tube.bulks.front(), tube.positions).volume, 4. * pi, circle * 4. * pi);
    }
}

TEST(RidgeInSpace, GeometryConvergesWithCellsAround)
{
  // Area within polygons of degree k: order k + 1 for odd and k + 2 for even k.
  for (const unsigned int degree : {1u, 2u, 3u})
  {
    const auto error = [&](const unsigned int n_around)
    {
      const SurfaceDiscretization ridge =
          ridge_in_space(paper_shape(.1, degree), plan(Outline::cylinder, true, n_around));
      return std::abs(region_measures(ridge, wetted_region).area - pi);
    };
    const std::array<double, 3> order{{1.95, 3.95, 5.9}};
    EXPECT_GT(std::log2(error(16) / error(32)), order[degree - 1]) << degree;
  }
}

TEST(RidgeInSpace, HalfIsHalfOfTheWhole)
{
  for (const Outline outline : {Outline::block, Outline::cylinder})
  {
    const SurfaceDiscretization whole = ridge_in_space(paper_shape(.05), plan(outline, false)),
                                half  = ridge_in_space(paper_shape(.05), plan(outline, true));
    EXPECT_EQ(whole.n_cells, 2 * half.n_cells);
    EXPECT_EQ(whole.bulks[0].n_cells, 2 * half.bulks[0].n_cells);
    for (const unsigned int region : {cap_region, wetted_region, dry_region})
    {
      const RegionMeasures a = region_measures(whole, region), b = region_measures(half, region);
      EXPECT_NEAR(a.area, b.area, 1e-12);
      EXPECT_NEAR(a.volume, b.volume, 1e-12);
    }
    EXPECT_NEAR(loop_length(whole.edges[0], whole.positions), loop_length(half.edges[0], half.positions), 1e-12);
    EXPECT_NEAR(loop_length(whole.edges[0], whole.positions), 2. * pi, 2e-4);
    for (std::size_t I = 0; I < half.n_nodes; ++I)
    {
      EXPECT_GE(half.positions[3 * I + 1], 0.);
      EXPECT_EQ(half.admissible[I].count, half.positions[3 * I + 1] < 1e-9 ? 2u : 3u);
    }
    EXPECT_EQ(half.bulks[0].faces.count("front"), 0u);
    EXPECT_EQ(whole.bulks[0].faces.count("front"), outline == Outline::block ? 1u : 0u);
  }
}

/** All nodes of the six faces of every hexahedron, sorted, with the number of cells that have them. */
std::map<std::vector<std::size_t>, unsigned int> faces_of_cells(const BulkPart &body, const std::size_t degree)
{
  std::map<std::vector<std::size_t>, unsigned int> faces;
  const std::size_t n = degree + 1;
  for (std::size_t cell = 0; cell < body.n_cells; ++cell)
    for (unsigned int face = 0; face < 6; ++face)
    {
      std::vector<std::size_t> nodes;
      for (std::size_t i = 0; i < n * n * n; ++i)
        if (std::array<std::size_t, 3>{{i % n, i / n % n, i / (n * n)}}[face / 2] == (face % 2 == 0 ? 0 : degree))
          nodes.push_back(body.cell_nodes[cell * n * n * n + i]);
      std::sort(nodes.begin(), nodes.end());
      ++faces[nodes];
    }
  return faces;
}

TEST(RidgeInSpace, CellsShareTheirFacesButOnTheBoundary)
{
  for (const Outline outline : {Outline::block, Outline::cylinder})
    for (const bool half : {false, true})
    {
      const SurfaceDiscretization ridge = ridge_in_space(paper_shape(.1), plan(outline, half));
      const BulkPart &body              = ridge.bulks.front();
      std::vector<std::set<std::size_t>> boundary;
      for (const char *name : {"side", "bottom", "top"})
        boundary.emplace_back(body.faces.at(name).begin(), body.faces.at(name).end());
      boundary.emplace_back();
      for (std::size_t I = 0; half && I < ridge.n_nodes; ++I)
        if (ridge.positions[3 * I + 1] == 0.)
          boundary.back().insert(I);
      for (const auto &[nodes, n_cells] : faces_of_cells(body, ridge.degree))
      {
        const bool outside = std::any_of(boundary.begin(), boundary.end(),
                                         [&, &on_face = nodes](const std::set<std::size_t> &side) {
                                           return std::all_of(on_face.begin(), on_face.end(),
                                                              [&](const std::size_t I) { return side.count(I) > 0; });
                                         });
        EXPECT_EQ(n_cells, outside ? 1u : 2u);
      }
      const auto top = region_nodes(ridge, {wetted_region, dry_region});
      EXPECT_EQ(top, boundary[2]);
      if (outline == Outline::block)
        for (const auto &[name, component, value] :
             {std::tuple<const char *, unsigned int, double>{"left", 0, -2.}, {"right", 0, 2.}, {"back", 1, 2.}})
          for (const std::size_t I : body.faces.at(name))
          {
            EXPECT_NEAR(ridge.positions[3 * I + component], value, 1e-14);
            EXPECT_EQ(boundary[0].count(I), 1u);
          }
    }
}

TEST(RidgeInSpace, NodesOfTheLineAreSharedAndOnTheCircle)
{
  for (const bool half : {false, true})
  {
    const SurfaceDiscretization ridge = ridge_in_space(paper_shape(.05, 3), plan(Outline::block, half));
    ASSERT_EQ(ridge.edges.size(), 1u);
    const EdgeLoop &line = ridge.edges.front();
    EXPECT_EQ(line.name, "contact line");
    EXPECT_FALSE(line.is_rim);
    EXPECT_TRUE(line.is_junction);
    EXPECT_EQ(line.n_cells, half ? 8u : 16u);
    const std::set<std::size_t> ring(line.cell_nodes.begin(), line.cell_nodes.end()),
        cap = region_nodes(ridge, {cap_region}), wetted = region_nodes(ridge, {wetted_region}),
        dry = region_nodes(ridge, {dry_region});
    EXPECT_EQ(ring.size(), half ? 25u : 48u);
    for (const std::size_t node : ring)
    {
      EXPECT_NEAR(distance_from_axis(ridge, node), 1., 4e-16);
      EXPECT_EQ(place(ridge, node)[2], 0.);
      EXPECT_EQ(wetted.count(node) + dry.count(node) + cap.count(node), 3u);
    }
    std::set<std::size_t> common;
    std::set_intersection(cap.begin(), cap.end(), wetted.begin(), wetted.end(), std::inserter(common, common.end()));
    EXPECT_EQ(common, ring);
    const auto &body = ridge.bulks.front().cell_nodes;
    EXPECT_EQ(std::set<std::size_t>(body.begin(), body.end()).size() + cap.size() - ring.size(), ridge.n_nodes);

    // Counterclockwise, from x > 0; open where the mirror plane cuts it.
    for (std::size_t i = 0; i + 1 < line.cell_nodes.size(); ++i)
      if (line.cell_nodes[i] != line.cell_nodes[i + 1])
      {
        EXPECT_GT(cross(place(ridge, line.cell_nodes[i]), place(ridge, line.cell_nodes[i + 1]))[2], 0.);
      }
    EXPECT_EQ(line.cell_nodes.front() == line.cell_nodes.back(), !half);
    if (half)
    {
      EXPECT_EQ(place(ridge, line.cell_nodes.front())[0], 1.);
      EXPECT_EQ(place(ridge, line.cell_nodes.back())[0], -1.);
    }
    for (const CellSide &side : line.sides)
      EXPECT_EQ(ridge.cell_region[side.cell], cap_region);
    // Conormals of the cap at its rim point down along the sphere: (cos, -sin) of the polar angle.
    const double angle = cap_angle(2., 1.);
    for (const Vector3<double> &nu : conormals(ridge, line, ridge.positions))
      EXPECT_NEAR(nu[2], -std::sin(angle), 5e-3);
  }
}

TEST(RidgeInSpace, NodesOfTheCapAreOnTheSphere)
{
  for (const double volume : {.05, 2., 40.})
  {
    RidgeShape shape                  = paper_shape(.05);
    shape.cap_volume                  = volume;
    const SurfaceDiscretization ridge = ridge_in_space(shape, plan(Outline::block, true));
    const double angle = cap_angle(volume, 1.), radius = 1. / std::sin(angle);
    for (const std::size_t node : region_nodes(ridge, {cap_region}))
      EXPECT_NEAR(norm(place(ridge, node) + Vector3<double>(0., 0., radius * std::cos(angle))), radius, 1e-14 * radius);
    const RegionMeasures cap = region_measures(ridge, cap_region), wetted = region_measures(ridge, wetted_region);
    EXPECT_NEAR(cap.volume + wetted.volume, volume, 5e-4 * volume);
  }
}

TEST(RidgeInSpace, UnknownsAndSmallestCells)
{
  const SurfaceDiscretization paper = ridge_in_space(paper_shape(), plan(Outline::block, true));
  EXPECT_LT(n_free(paper), 40000u);
  EXPECT_GT(n_free(paper), 20000u);
  for (const double size : {.025, 1e-3})
    for (const double half_width : {1.1, 2., 6.})
    {
      RidgeShape shape                  = paper_shape(size);
      shape.half_width                  = half_width;
      const SurfaceDiscretization ridge = ridge_in_space(shape, plan(Outline::block, true));
      EXPECT_GT(body_measures(ridge.bulks.front(), ridge.positions).worst_jacobian, .1);
      // Nodes next to the line on the plane y = 0, and below it.
      std::set<double> x, z;
      for (const std::size_t I : ridge.bulks.front().faces.at("top"))
        if (ridge.positions[3 * I + 1] == 0.)
          x.insert(ridge.positions[3 * I]);
      for (const std::size_t I : ridge.bulks.front().cell_nodes)
        if (place(ridge, I)[0] == 1. && ridge.positions[3 * I + 1] == 0.)
          z.insert(ridge.positions[3 * I + 2]);
      const auto at    = x.find(1.);
      const auto steps = {*std::next(at, 2) - 1., 1. - *std::prev(at, 2), -*std::next(z.rbegin(), 2)};
      for (const double step : steps)
      {
        EXPECT_LE(step, size * (1. + 1e-9));
        EXPECT_GT(step, .7 * size);
      }
    }
}

TEST(RidgeInSpace, RefusesWhatHasNoMesh)
{
  RidgeShape shape = paper_shape();
  shape.half_width = 1.;
  EXPECT_USER_ERROR(ridge_in_space(shape, plan(Outline::block, false)),
                    "The ring of radius 1 touches the lateral faces of a substrate of half width 1:");
  EXPECT_USER_ERROR(ridge_in_space(paper_shape(.025, 4), plan(Outline::block, false)), "Degree = 4", "from 1 to 3");
  EXPECT_USER_ERROR(ridge_in_space(paper_shape(), plan(Outline::block, false, 12)),
                    "Cells around the contact line = 12", "multiple of 8");
  EXPECT_USER_ERROR(ridge_in_space(paper_shape(.3), plan(Outline::block, false)), "Cell size = 0.3");
}
} // namespace

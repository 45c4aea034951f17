// SPDX-License-Identifier: LGPL-2.1-or-later
// Meshes whose cells differ in size: no cracks, no gaps in lines, and integrals of the order of uniform meshes.
#include "local_refinement.h"

#include <pellicle/base/constants.h>
#include <pellicle/discretization/builders.h>
#include <pellicle/discretization/split_line.h>
#include <pellicle/discretization/surface_quality.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

using Builder = std::function<SurfaceDiscretization(const Refinement &)>;

/** Cut three times around (1, 0, .3), each time the cells within a smaller distance. */
SurfaceDiscretization refined_at_a_point(const Builder &build)
{
  const Vector3<double> centre(1., 0., 0.3);
  Refinement refinement(1);
  for (const double radius : {0.8, 0.5, 0.3})
  {
    const SurfaceDiscretization mesh = build(refinement);
    const auto near = cells_where(mesh, [&](const Vector3<double> &x) { return norm(x - centre) < radius; });
    refinement.cut.insert(refinement.cut.end(), near.begin(), near.end());
  }
  return build(refinement);
}

struct Example
{
  std::string name;
  Builder build;
  int euler;
  std::size_t n_edges;
};

std::vector<Example> examples(const unsigned int degree)
{
  const SmoothShape prolate = scaled_to_area(prolate_spheroid(0.9), 4. * pi);
  return {{"sphere", [=](const Refinement &r) { return on_cube_sphere(prolate, degree, r); }, 2, 0},
          {"torus", [=](const Refinement &r) { return torus(std::sqrt(2.), 20., degree, r); }, 0, 0},
          {"cap", [=](const Refinement &r) { return cap(1.6, 2. * pi, degree, r, false); }, 1, 1},
          {"tube", [=](const Refinement &r) { return tube(2., 4. * pi, degree, r, false); }, 0, 2},
          {"annulus",
           [=](const Refinement &r) {
             return annulus({0.3, 1.5, 0., 0., 4, 8}, degree, r, false);
           },
           0, 2},
          {"two holes",
           [=](const Refinement &r) {
             return disc_with_two_holes({0.3, 1.5, 3., 0.}, degree, r);
           },
           -1, 3},
          {"region", [=](const Refinement &r) { return with_polar_region(prolate, 0.4, degree, r, false); }, 2, 1}};
}

TEST(Refinement, PlacesAreNested)
{
  EXPECT_TRUE(is_part_of({2, 0.25, 0.5, 0.25}, {2, 0., 0.5, 0.5}));
  EXPECT_TRUE(is_part_of({2, 0.25, 0.5, 0.25}, {2, 0.25, 0.5, 0.25}));
  EXPECT_FALSE(is_part_of({2, 0., 0.5, 0.5}, {2, 0.25, 0.5, 0.25}));
  EXPECT_FALSE(is_part_of({1, 0.25, 0.5, 0.25}, {2, 0., 0.5, 0.5}));
  EXPECT_FALSE(is_part_of({2, 0.5, 0.5, 0.25}, {2, 0., 0.5, 0.5}));
}

TEST(Refinement, MeshesHaveNoCracks)
{
  for (const unsigned int degree : {2u, 3u})
    for (const Example &example : examples(degree))
    {
      SCOPED_TRACE(example.name + ", degree " + std::to_string(degree));
      const SurfaceDiscretization uniform = example.build(1), mesh = refined_at_a_point(example.build);
      EXPECT_GT(mesh.n_cells, uniform.n_cells + 12);
      EXPECT_FALSE(mesh.hanging.empty());
      EXPECT_TRUE(is_nested(uniform, mesh));
      EXPECT_LT(largest_crack(mesh, mesh.positions), 1e-14);
      if (!mesh.mesh_reference.empty())
      {
        EXPECT_LT(largest_crack(mesh, mesh.mesh_reference), 1e-14);
      }
      EXPECT_EQ(euler_characteristic(mesh), example.euler);
      const std::vector<bool> hangs = hanging_flags(mesh);
      for (const HangingNode &hanging : mesh.hanging)
      {
        double sum = 0.;
        for (const auto &[node, share] : hanging.shares)
        {
          EXPECT_FALSE(hangs[node]) << "a node hangs on a hanging one";
          sum += share;
        }
        EXPECT_NEAR(sum, 1., 1e-14);
      }
      ASSERT_EQ(mesh.edges.size(), example.n_edges);
      for (const EdgeLoop &loop : mesh.edges)
      {
        EXPECT_EQ(loop.cell_nodes.front(), loop.cell_nodes.back()) << loop.name;
        EXPECT_TRUE(std::none_of(loop.cell_nodes.begin(), loop.cell_nodes.end(),
                                 [&](const std::size_t node) { return hangs[node]; }))
            << "a node hangs on the line " << loop.name;
      }
    }
}

// Integral of n dA over a closed surface, and so the dependence of the volume on the place: zero for any positions.
TEST(Refinement, ClosedSurfacesAreClosed)
{
  SurfaceDiscretization mesh = refined_at_a_point(examples(3)[0].build);
  const double volume        = surface_quality(mesh, mesh.positions).volume;
  NodalVectors moved         = mesh.positions;
  for (std::size_t i = 0; i < moved.size(); ++i)
    moved[i] += i % 3 == 0 ? 10. : -7.;
  EXPECT_NEAR(surface_quality(mesh, moved).volume, volume, 1e-12 * volume);
}

// All cells cut again. Area and volume of a uniform mesh converge at order 2k; nodes that hang on larger cells are off
// the shape by h^(k + 1) along a strip of width h, which makes min(2k, k + 2) for shapes that are no solutions.
TEST(Refinement, IntegralsKeepTheirOrder)
{
  const SmoothShape prolate = scaled_to_area(prolate_spheroid(0.9), 4. * pi);
  for (const unsigned int degree : {2u, 3u})
  {
    const Builder build               = [&](const Refinement &r) { return on_cube_sphere(prolate, degree, r); };
    const SurfaceDiscretization first = refined_at_a_point(build), second = build({1, first.cell_places});
    EXPECT_EQ(second.n_cells, 4 * first.n_cells);
    const auto errors = [&](const SurfaceDiscretization &mesh)
    {
      const SurfaceQuality q = surface_quality(mesh, mesh.positions);
      return std::array<double, 2>{{std::abs(q.area / prolate.area - 1.), std::abs(q.volume / prolate.volume - 1.)}};
    };
    const auto coarse = errors(first), fine = errors(second);
    for (unsigned int i = 0; i < 2; ++i)
      EXPECT_GT(std::log2(coarse[i] / fine[i]), std::min(2. * degree, degree + 2.) - 0.5)
          << (i == 0 ? "area" : "volume") << ", degree " << degree << ": " << coarse[i] << ", then " << fine[i];
  }
}

TEST(Refinement, MeridiansAreCutInPlaces)
{
  const SmoothShape prolate           = scaled_to_area(prolate_spheroid(0.9), 4. * pi);
  const auto build                    = [&](const Refinement &r) { return on_meridian(prolate, 3, r, false); };
  const SurfaceDiscretization uniform = build(1);
  ASSERT_EQ(uniform.n_cells, 8u);
  // Neighbours of a cell that is cut three times are cut as well.
  const double size = uniform.cell_places[2].size, u0 = uniform.cell_places[2].u0;
  const SurfaceDiscretization mesh = build({1, {{0, u0, 0., 0.25 * size}}});
  EXPECT_TRUE(is_nested(uniform, mesh));
  std::vector<double> sizes;
  double end = 0.;
  for (const CellPlace &place : mesh.cell_places)
  {
    EXPECT_DOUBLE_EQ(place.u0, end);
    end = place.u0 + place.size;
    sizes.push_back(place.size / size);
  }
  EXPECT_DOUBLE_EQ(end, 1.);
  EXPECT_EQ(sizes, (std::vector<double>{1., 0.5, 0.25, 0.25, 0.125, 0.125, 0.25, 0.5, 1., 1., 1., 1., 1.}));
  EXPECT_TRUE(mesh.hanging.empty());
  // Nodes that both have are where they were.
  EXPECT_EQ(mesh.positions[3 * 3 * mesh.n_cells + 2], uniform.positions[3 * 3 * 8 + 2]);

  const SurfaceDiscretization domain = with_polar_region(prolate, 0.4, 3, {1, {mesh.cell_places[0]}}, true);
  const std::size_t n_within =
      static_cast<std::size_t>(std::count(domain.cell_region.begin(), domain.cell_region.end(), 1u));
  EXPECT_EQ(domain.edges[0].cell_nodes[0], 3 * n_within);
  EXPECT_EQ(domain.n_cells, 9u);
}

// Lines between regions have cells of one size on both sides, so that they can be split.
TEST(Refinement, SplitLinesKeepHangingNodesOnTheirSide)
{
  const SurfaceDiscretization mesh  = refined_at_a_point(examples(3)[6].build);
  const SurfaceDiscretization split = split_along(mesh, "domain boundary");
  EXPECT_LT(largest_crack(split, split.positions), 1e-14);
  EXPECT_GT(split.n_nodes, mesh.n_nodes);
}
} // namespace

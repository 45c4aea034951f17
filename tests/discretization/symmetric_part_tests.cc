// SPDX-License-Identifier: LGPL-2.1-or-later
// Parts of surfaces between planes of symmetry: what they keep of the whole, and that their images make it again.
#include "expect_user_error.h"

#include <pellicle/base/constants.h>
#include <pellicle/discretization/builders.h>
#include <pellicle/discretization/edge_loops.h>
#include <pellicle/discretization/start_shapes.h>
#include <pellicle/discretization/surface_quality.h>
#include <pellicle/discretization/symmetric_part.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
using namespace pellicle;

const MirrorPlanes half{{false, true, false}}, quarter{{true, true, false}}, octant{{true, true, true}};

SurfaceDiscretization vesicle(const std::string &name, const unsigned int refinements)
{
  StartShape shape;
  shape.name           = name;
  shape.refinements    = refinements;
  shape.reduced_volume = name == "stomatocyte" ? 0.62 : 0.8;
  shape.semi_axes      = {{0.7, 1., 1.2}};
  return make_start_shape(shape);
}

std::vector<std::array<double, 3>> sorted_places(const NodalVectors &positions)
{
  std::vector<std::array<double, 3>> places;
  for (std::size_t i = 0; i < positions.size(); i += 3)
    places.push_back({{1e-9 * std::round(1e9 * positions[i]), 1e-9 * std::round(1e9 * positions[i + 1]),
                       1e-9 * std::round(1e9 * positions[i + 2])}});
  for (auto &place : places)
    for (double &x : place)
      x += 0.; // no -0
  std::sort(places.begin(), places.end());
  return places;
}

TEST(SymmetricPart, HasTheIntegralsOfTheWhole)
{
  const SurfaceDiscretization whole = vesicle("ellipsoid", 1);
  const SurfaceQuality expected     = surface_quality(whole, whole.positions);
  for (const MirrorPlanes &planes : {half, quarter, octant})
  {
    const SurfaceDiscretization part = symmetric_part(whole, planes);
    EXPECT_EQ(part.n_cells * planes.n_images(), whole.n_cells);
    EXPECT_EQ(part.cell_places.size(), part.n_cells);
    const SurfaceQuality here = surface_quality(part, part.positions);
    EXPECT_NEAR(here.area, expected.area, 1e-12);
    EXPECT_NEAR(here.volume, expected.volume, 1e-12);
  }
}

TEST(SymmetricPart, NodesStayOnPlanesAndMotionsToo)
{
  const SurfaceDiscretization part = symmetric_part(vesicle("prolate", 1), octant);
  ASSERT_EQ(part.admissible.size(), part.n_nodes);
  for (std::size_t I = 0; I < part.n_nodes; ++I)
  {
    const double *const x = &part.positions[3 * I];
    EXPECT_EQ(part.admissible[I].count, 3 - std::count(x, x + 3, 0.)) << x[0] << " " << x[1] << " " << x[2];
    for (unsigned int j = 0; j < part.admissible[I].count; ++j)
      for (unsigned int c = 0; c < 3; ++c)
        EXPECT_TRUE(x[c] != 0. || part.admissible[I].columns[j][c] == 0.);
  }
  EXPECT_TRUE(part.rigid_motions.empty());
  EXPECT_EQ(symmetric_part(vesicle("prolate", 1), quarter).rigid_motions.size(), 1u);
  EXPECT_EQ(symmetric_part(vesicle("prolate", 1), half).rigid_motions.size(), 3u);
  EXPECT_TRUE(keeps_in_place({{{0., 0., 2.}}, {}}, quarter));
  EXPECT_FALSE(keeps_in_place({{}, {{0., 0., 1.}}}, half));
  EXPECT_TRUE(keeps_in_place({{}, {{0., 1., 0.}}}, half));
}

TEST(SymmetricPart, ImagesMakeTheWholeAgain)
{
  for (const auto &[name, planes] : {std::pair("prolate", octant), std::pair("stomatocyte", quarter)})
  {
    const SurfaceDiscretization whole = vesicle(name, 2), part = symmetric_part(whole, planes);
    const UnfoldedSurface unfolded(part, planes);
    const SurfaceDiscretization &again = unfolded.surface();
    EXPECT_EQ(again.n_cells, whole.n_cells);
    EXPECT_EQ(again.n_nodes, whole.n_nodes);
    EXPECT_EQ(euler_characteristic(again), 2); // nodes on the planes are common to the images
    EXPECT_NEAR(surface_quality(again, again.positions).volume, surface_quality(whole, whole.positions).volume, 1e-12);
    EXPECT_EQ(sorted_places(again.positions), sorted_places(whole.positions));
    const std::vector<double> scalars = unfolded.values(std::vector<double>(part.n_nodes, 2.), 1);
    EXPECT_EQ(scalars, std::vector<double>(whole.n_nodes, 2.));
  }
}

TEST(SymmetricPart, LinesBeginAndEndOnThePlanes)
{
  const SurfaceDiscretization whole = cap(1.2, 2., 3, 1, false), part = symmetric_part(whole, quarter);
  ASSERT_EQ(part.edges.size(), 1u);
  const EdgeLoop &rim = part.edges[0];
  EXPECT_EQ(4 * rim.n_cells, whole.edges[0].n_cells);
  EXPECT_NEAR(loop_length(rim, part.positions), loop_length(whole.edges[0], whole.positions), 1e-12);
  EXPECT_EQ(part.positions[3 * rim.cell_nodes.front() + 1], 0.);
  EXPECT_EQ(part.positions[3 * rim.cell_nodes.back()], 0.);
  for (std::size_t c = 1; c < rim.n_cells; ++c)
    EXPECT_EQ(rim.cell_nodes[c * rim.tables.n_nodes], rim.cell_nodes[c * rim.tables.n_nodes - 1]);
  for (const CellSide &side : rim.sides)
    EXPECT_LT(side.cell, part.n_cells);
}

TEST(SymmetricPart, RefusesWhatPlanesDoNotDivide)
{
  EXPECT_USER_ERROR(symmetric_part(vesicle("prolate", 0), octant), "cuts through cells", "Mesh/Refinements to 1");
  EXPECT_USER_ERROR(symmetric_part(vesicle("stomatocyte", 2), octant), "z = 0");
}
} // namespace

// SPDX-License-Identifier: LGPL-2.1-or-later
// Every start shape, discretized: orientation, convergence of area and volume, symmetry, conditions at the poles,
// refusals.
#include "expect_user_error.h"

#include <pellicle/base/constants.h>
#include <pellicle/discretization/smooth_shape.h>
#include <pellicle/discretization/start_shapes.h>
#include <pellicle/discretization/surface_quality.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

namespace
{
using namespace pellicle;

StartShape start(const std::string &name, const unsigned int degree, const unsigned int refinements,
                 const bool axial = false, const bool mirror = false)
{
  StartShape shape;
  shape.name           = name;
  shape.degree         = degree;
  shape.refinements    = refinements;
  shape.axial          = axial;
  shape.mirror         = mirror;
  shape.reduced_volume = name == "stomatocyte" ? 0.62 : 0.8;
  shape.semi_axes      = {{0.7, 0.7, 1.2}};
  return shape;
}

SurfaceQuality quality(const StartShape &shape)
{
  const SurfaceDiscretization d = make_start_shape(shape);
  return surface_quality(d, d.positions);
}

/** Volume of the smooth shape at area 4 pi. */
double exact_volume(const StartShape &shape)
{
  const double sphere = 4. / 3. * pi;
  if (shape.name == "ellipsoid")
    return sphere * ellipsoid(shape.semi_axes).reduced_volume();
  if (shape.name == "biconcave")
    return sphere * biconcave().reduced_volume();
  if (shape.name == "torus") // A = 4 pi^2 R r, V = 2 pi^2 R r^2 = A r/2
    return 2. * pi * std::sqrt(4. * pi / (4. * pi * pi * shape.torus_ratio));
  return sphere * shape.reduced_volume;
}

class EveryDegree : public testing::TestWithParam<unsigned int>
{
};

TEST_P(EveryDegree, ClosedSurfacesAreOrientedOutwards)
{
  for (const std::string name : {"prolate", "oblate", "stomatocyte", "ellipsoid", "biconcave", "torus"})
  {
    const StartShape shape        = start(name, GetParam(), name == "stomatocyte" ? 3 : 2);
    const SurfaceDiscretization d = make_start_shape(shape); // throws where J is not positive
    const SurfaceQuality q        = surface_quality(d, d.positions);
    EXPECT_NEAR(q.area / (4. * pi), 1., 2e-2) << name;
    EXPECT_NEAR(q.volume / exact_volume(shape), 1., 3e-2) << name; // positive: outwards
    EXPECT_GT(q.min_cell_quality, .15) << name;
    EXPECT_EQ(d.rigid_motions.size(), 6u);
    EXPECT_TRUE(d.admissible.empty());
    EXPECT_EQ(d.positions.size(), 3 * d.n_nodes);
    EXPECT_EQ(d.cell_nodes.size(), d.n_cells * d.n_local());
    if (name != "torus")
    {
      EXPECT_EQ(d.n_cells, shape.refinements == 2 ? 96u : 384u);
      EXPECT_EQ(d.n_nodes, d.n_cells * GetParam() * GetParam() + 2); // Euler's formula for the sphere
    }
    else
      EXPECT_EQ(d.n_nodes, d.n_cells * GetParam() * GetParam()); // and for the torus
  }
}

TEST_P(EveryDegree, NormalsOfStarShapedSurfacesPointAwayFromTheCentre)
{
  for (const bool axial : {false, true})
  {
    const SurfaceDiscretization d = make_start_shape(start("prolate", GetParam(), 1, axial));
    std::vector<double> inputs(d.tables.n_points * 18);
    for (std::size_t cell = 0; cell < d.n_cells; ++cell)
    {
      evaluate_field(d.tables, &d.cell_nodes[cell * d.n_local()], d.positions, 3, inputs.data());
      for (unsigned int q = 0; q < d.tables.n_points; ++q)
      {
        const double *v = &inputs[q * 18];
        const Vector3<double> x(v[0], v[1], v[2]), a1(v[3], v[4], v[5]), a2(v[6], v[7], v[8]);
        EXPECT_GT(dot(x, cross(a1, a2)), 0.);
      }
    }
  }
}

/** Halving the cells divides the error by 2^order, until round-off is reached. */
testing::AssertionResult converges(const double coarse, const double fine, const double order)
{
  if (std::abs(fine) < 2e-13 || std::log2(std::abs(coarse / fine)) > order - .6)
    return testing::AssertionSuccess();
  return testing::AssertionFailure() << "errors " << coarse << ", " << fine << ": order "
                                     << std::log2(std::abs(coarse / fine)) << ", not " << order;
}

TEST_P(EveryDegree, AreaAndVolumeConvergeAtTwiceTheDegree)
{
  const unsigned int k = GetParam();
  for (const std::string name : {"prolate", "oblate", "ellipsoid", "torus", "biconcave"})
    for (const bool axial : {false, true})
    {
      if (axial && name == "torus")
        continue;
      const StartShape coarse_shape = start(name, k, axial ? 2 : (k < 4 ? 3 : 2), axial);
      StartShape fine_shape         = coarse_shape;
      const SurfaceQuality coarse   = quality(coarse_shape);
      ++fine_shape.refinements;
      const SurfaceQuality fine = quality(fine_shape);
      const double exact        = exact_volume(coarse_shape);
      EXPECT_TRUE(converges(coarse.area - 4. * pi, fine.area - 4. * pi, 2. * k))
          << "area, " << name << (axial ? " axial" : "");
      EXPECT_TRUE(converges(coarse.volume - exact, fine.volume - exact, 2. * k))
          << "volume, " << name << (axial ? " axial" : "");
    }
}

TEST_P(EveryDegree, MeridianHasItsCellsPolesAndMirror)
{
  const unsigned int k = GetParam();
  for (const std::string name : {"prolate", "oblate", "ellipsoid", "biconcave", "stomatocyte"})
  {
    const SurfaceDiscretization d = make_start_shape(start(name, k, 2, true));
    EXPECT_EQ(d.kind, SurfaceDiscretization::Kind::meridian);
    EXPECT_EQ(d.n_cells, 16u);
    ASSERT_EQ(d.n_nodes, 16 * k + 1);
    EXPECT_EQ(d.positions[0], 0.);
    EXPECT_EQ(d.positions[3 * (d.n_nodes - 1)], 0.);
    ASSERT_EQ(d.admissible.size(), d.n_nodes);
    for (std::size_t n = 0; n < d.n_nodes; ++n)
    {
      EXPECT_EQ(d.positions[3 * n + 1], 0.);
      const bool pole = n == 0 || n == d.n_nodes - 1;
      EXPECT_EQ(d.admissible[n].count, pole ? 1u : 2u);
      EXPECT_EQ(d.admissible[n].columns[0],
                (pole ? std::array<double, 3>{{0., 0., 1.}} : std::array<double, 3>{{1., 0., 0.}}));
      if (!pole)
      {
        EXPECT_GT(d.positions[3 * n], 0.);
        EXPECT_EQ(d.admissible[n].columns[1], (std::array<double, 3>{{0., 0., 1.}}));
      }
    }
    ASSERT_EQ(d.rigid_motions.size(), 1u);
    EXPECT_EQ(d.rigid_motions[0].translation, (std::array<double, 3>{{0., 0., 1.}}));
    EXPECT_EQ(d.rigid_motions[0].rotation, (std::array<double, 3>{}));
    if (name == "stomatocyte")
      continue;

    const SurfaceDiscretization half = make_start_shape(start(name, k, 2, true, true));
    EXPECT_TRUE(half.mirror);
    EXPECT_EQ(half.n_cells, 8u);
    EXPECT_TRUE(half.rigid_motions.empty());
    EXPECT_EQ(half.positions[3 * half.n_nodes - 1], 0.);
    EXPECT_EQ(half.admissible.back().count, 1u);
    EXPECT_EQ(half.admissible.back().columns[0], (std::array<double, 3>{{1., 0., 0.}}));
    EXPECT_GT(half.positions[2], 0.);
    for (std::size_t n = 0; n < half.n_nodes; ++n) // the same nodes as the upper half of the whole
      for (unsigned int c = 0; c < 3; ++c)
        EXPECT_NEAR(half.positions[3 * n + c], d.positions[3 * n + c], 1e-15);
    const SurfaceQuality whole_quality = surface_quality(d, d.positions),
                         half_quality  = surface_quality(half, half.positions);
    EXPECT_NEAR(half_quality.area, whole_quality.area, 1e-13);
    EXPECT_NEAR(half_quality.volume, whole_quality.volume, 1e-13);
  }
}

INSTANTIATE_TEST_SUITE_P(Degrees, EveryDegree, testing::Values(2u, 3u, 4u, 5u));

TEST(StartShape, CellCounts)
{
  for (unsigned int r = 0; r <= 3; ++r)
  {
    EXPECT_EQ(make_start_shape(start("prolate", 2, r)).n_cells, 6u << (2 * r));
    EXPECT_EQ(make_start_shape(start("prolate", 2, r, true)).n_cells, 4u << r);
    EXPECT_EQ(make_start_shape(start("prolate", 2, r, true, true)).n_cells, 2u << r);
    EXPECT_EQ(make_start_shape(start("torus", 2, r)).n_cells, 24u << (2 * r)); // 4 x round(4 sqrt 2)
  }
}

TEST(StartShape, ReducedVolumeIsTheWantedOne)
{
  for (const std::string name : {"prolate", "oblate", "stomatocyte"})
    for (const bool axial : {false, true})
    {
      std::vector<double> errors;
      for (unsigned int r = 3; r <= 4; ++r)
      {
        const StartShape shape = start(name, 3, axial ? r + 1 : r, axial);
        const SurfaceQuality q = quality(shape);
        errors.push_back(
            std::abs(3. * q.volume / (4. * pi * std::pow(q.area / (4. * pi), 1.5)) - shape.reduced_volume));
      }
      EXPECT_LT(errors[1], errors[0] / 8.) << name << (axial ? " axial" : "");
      EXPECT_LT(errors[1], name == "stomatocyte" ? 1e-5 : 1e-7) << name << (axial ? " axial" : "");
    }
}

TEST(StartShape, StomatocyteConvergesOnMeridianAtTwiceTheDegree)
{
  // Smooth outline: the full order, which arcs joined with jumps of curvature would not give.
  const double coarse = quality(start("stomatocyte", 3, 5, true)).area - 4. * pi,
               fine   = quality(start("stomatocyte", 3, 6, true)).area - 4. * pi;
  EXPECT_GT(std::log2(std::abs(coarse / fine)), 5.4) << coarse << " " << fine;
}

/** Positions as a set, to 1e-12. */
std::set<std::array<double, 3>> nodes_of(const SurfaceDiscretization &d,
                                         const std::function<std::array<double, 3>(const double *)> &image)
{
  std::set<std::array<double, 3>> nodes;
  for (std::size_t n = 0; n < d.n_nodes; ++n)
  {
    std::array<double, 3> x = image(&d.positions[3 * n]);
    for (double &c : x)
      c = std::round(1e12 * c) / 1e12 + 0.; // + 0: no negative zeros
    nodes.insert(x);
  }
  return nodes;
}

TEST(StartShape, NodesHaveTheSymmetriesOfTheShape)
{
  const auto same = [](const double *x) {
    return std::array<double, 3>{{x[0] + 0., x[1] + 0., x[2] + 0.}};
  }; // + 0: no negative zeros
  for (const std::string name : {"prolate", "oblate", "biconcave", "ellipsoid", "stomatocyte"})
  {
    const SurfaceDiscretization d = make_start_shape(start(name, 3, 2));
    const auto nodes              = nodes_of(d, same);
    EXPECT_EQ(nodes.size(), d.n_nodes) << name;
    EXPECT_EQ(nodes_of(d,
                       [](const double *x) {
                         return std::array<double, 3>{{0. - x[0], x[1] + 0., x[2] + 0.}};
                       }),
              nodes)
        << name;
    EXPECT_EQ(nodes_of(d,
                       [](const double *x) {
                         return std::array<double, 3>{{x[1] + 0., x[0] + 0., x[2] + 0.}};
                       }),
              nodes)
        << name;
    if (name != "stomatocyte")
    {
      EXPECT_EQ(nodes_of(d,
                         [](const double *x) {
                           return std::array<double, 3>{{x[0] + 0., x[1] + 0., 0. - x[2]}};
                         }),
                nodes)
          << name;
    }
  }
}

TEST(StartShape, CellsDifferLittleInSize)
{
  StartShape sphere      = start("ellipsoid", 3, 3);
  sphere.semi_axes       = {{1., 1., 1.}};
  const SurfaceQuality q = quality(sphere);
  EXPECT_LT(q.cell_area_ratio, 1.65);
  EXPECT_GT(q.min_cell_quality, .85);
  EXPECT_LT(q.largest_aspect, 1.45);

  const SurfaceQuality cup = quality(start("stomatocyte", 3, 3));
  EXPECT_LT(cup.cell_area_ratio, 50.); // small ones at the rim and in the neck, where the curvature is
  EXPECT_GT(cup.min_cell_quality, .4);

  const SurfaceQuality clifford = quality(start("torus", 3, 2));
  EXPECT_LT(clifford.largest_aspect, 3.7); // at the hole; 1.6 on the outside
}

TEST(StartShape, EulerCharacteristicCountsHandles)
{
  for (const unsigned int degree : {2u, 3u, 5u})
  {
    EXPECT_EQ(euler_characteristic(make_start_shape(start("prolate", degree, 2))), 2);
    EXPECT_EQ(euler_characteristic(make_start_shape(start("torus", degree, 1))), 0);
    EXPECT_EQ(euler_characteristic(make_start_shape(start("biconcave", degree, 2, true))), 2);
  }
}

TEST(StartShape, SizeFollowsTheArea)
{
  for (const std::string name : {"prolate", "torus", "biconcave"})
  {
    StartShape shape = start(name, 4, 3);
    shape.area       = 1e-14;
    EXPECT_NEAR(quality(shape).area / 1e-14, 1., 1e-6) << name;
    shape.area = 1e12;
    EXPECT_NEAR(quality(shape).area / 1e12, 1., 1e-6) << name;
  }
  StartShape red_cell           = start("biconcave", 5, 3, true);
  red_cell.area                 = 8.314387691448; // the outline's own size: its rim has the radius 1
  const SurfaceDiscretization d = make_start_shape(red_cell);
  EXPECT_NEAR(d.positions[3 * (d.n_nodes / 2)], 1., 1e-12);
  EXPECT_NEAR(d.positions[2], .1242, 1e-12);
}

TEST(StartShape, MistakesAreRefused)
{
  const auto with = [](const std::string &name, const std::function<void(StartShape &)> &change)
  {
    StartShape shape = start(name, 3, 1);
    change(shape);
    return make_start_shape(shape);
  };
  EXPECT_USER_ERROR(with("prolat", [](StartShape &) {}), "'prolat' is not known", "'prolate'");
  EXPECT_USER_ERROR(with("cube", [](StartShape &) {}), "'cube' is not known");
  EXPECT_USER_ERROR(with("prolate", [](StartShape &s) { s.reduced_volume = 1.; }), "Reduced volume = 1 is a sphere");
  EXPECT_USER_ERROR(with("oblate", [](StartShape &s) { s.reduced_volume = 1.1; }), "Reduced volume = 1.1",
                    "between 0 and 1");
  EXPECT_USER_ERROR(with("prolate", [](StartShape &s) { s.reduced_volume = 0.; }), "between 0 and 1");
  EXPECT_USER_ERROR(with("oblate", [](StartShape &s) { s.reduced_volume = -.2; }), "Reduced volume = -0.2",
                    "between 0 and 1");
  EXPECT_USER_ERROR(with("prolate", [](StartShape &s) { s.area = 0.; }), "Area = 0", "> 0");
  EXPECT_USER_ERROR(with("prolate", [](StartShape &s) { s.area = std::nan(""); }), "Area", "> 0");
  EXPECT_USER_ERROR(with("prolate", [](StartShape &s) { s.degree = 1; }), "Degree = 1", "2, 3, 4 or 5");
  EXPECT_USER_ERROR(with("prolate", [](StartShape &s) { s.refinements = 9; }), "Refinements = 9", "at most 8");
  EXPECT_USER_ERROR(with("torus", [](StartShape &s) { s.torus_ratio = 1.; }), "Torus ratio = 1", "> 1");
  EXPECT_USER_ERROR(with("ellipsoid", [](StartShape &s) { s.semi_axes[1] = -1.; }), "Semi axes", "> 0");
  EXPECT_USER_ERROR(with("torus", [](StartShape &s) { s.axial = true; }), "'torus' has no axial form");
  EXPECT_USER_ERROR(with("file", [](StartShape &s) { s.axial = true; }), "'file' has no axial form");
  EXPECT_USER_ERROR(with("stomatocyte", [](StartShape &s) { s.axial = s.mirror = true; }), "no mirror plane");
  EXPECT_USER_ERROR(with("prolate", [](StartShape &s) { s.mirror = true; }), "axial symmetry");
  EXPECT_USER_ERROR(with("ellipsoid",
                         [](StartShape &s)
                         {
                           s.axial     = true;
                           s.semi_axes = {{1., 2., 3.}};
                         }),
                    "first two to be equal");
}
} // namespace

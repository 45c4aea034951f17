// SPDX-License-Identifier: LGPL-2.1-or-later
// Caps, discs, tubes and annuli: sizes, rims, conormals, convergence, refusals.
#include "curvature_error.h"
#include "expect_user_error.h"

#include <pellicle/base/constants.h>
#include <pellicle/discretization/builders.h>
#include <pellicle/discretization/start_shapes.h>
#include <pellicle/discretization/surface_quality.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace
{
using namespace pellicle;
constexpr double infinity = std::numeric_limits<double>::infinity();

StartShape start(const std::string &name, const unsigned int degree, const unsigned int refinements, const bool axial)
{
  StartShape shape;
  shape.name        = name;
  shape.degree      = degree;
  shape.refinements = refinements;
  shape.axial       = axial;
  shape.cap_angle   = 1.2;
  return shape;
}

Vector3<double> node(const SurfaceDiscretization &d, const std::size_t n)
{
  return {d.positions[3 * n], d.positions[3 * n + 1], d.positions[3 * n + 2]};
}

/** Vectors of the loop at its quadrature points: position and tangent. */
std::vector<std::array<Vector3<double>, 2>> points_of(const SurfaceDiscretization &d, const EdgeLoop &loop)
{
  std::vector<std::array<Vector3<double>, 2>> result;
  std::vector<double> in(loop.tables.n_points * 18);
  for (std::size_t c = 0; c < loop.n_cells; ++c)
  {
    evaluate_field(loop.tables, &loop.cell_nodes[c * loop.tables.n_nodes], d.positions, 2, in.data());
    for (unsigned int q = 0; q < loop.tables.n_points; ++q)
      result.push_back(
          {{{in[q * 18], in[q * 18 + 1], in[q * 18 + 2]}, {in[q * 18 + 3], in[q * 18 + 4], in[q * 18 + 5]}}});
  }
  return result;
}

class OpenSurface : public testing::TestWithParam<unsigned int>
{
};

/** Radius of the sphere that the cap with angle 1.2 and area 4 pi belongs to; the rim lies in z = 0. */
const double cap_radius = 1. / std::sin(.6);

struct Rim
{
  std::string name;
  double radius, z;
  std::function<Vector3<double>(const Vector3<double> &)> normal, conormal; ///< at a point of the rim
};

std::vector<Rim> exact_rims(const std::string &name)
{
  const auto up     = [](const Vector3<double> &) { return Vector3<double>(0., 0., 1.); };
  const auto down   = [](const Vector3<double> &) { return Vector3<double>(0., 0., -1.); };
  const auto radial = [](const Vector3<double> &x) { return Vector3<double>(x[0], x[1], 0.) / std::hypot(x[0], x[1]); };
  const auto inward = [=](const Vector3<double> &x) { return -radial(x); };
  if (name == "cap")
    return {{"rim", cap_radius * std::sin(1.2), 0.,
             [=](const Vector3<double> &x) { return std::sin(1.2) * radial(x) + std::cos(1.2) * up(x); },
             [=](const Vector3<double> &x) { return std::cos(1.2) * radial(x) - std::sin(1.2) * up(x); }}};
  if (name == "disc")
    return {{"rim", 2., 0., up, radial}};
  if (name == "annulus")
    return {{"tip", .1, 0., up, inward}, {"ring", 1., 0., up, radial}};
  const double r = std::sqrt(.5); // 2 pi r (4 r) = 4 pi
  return {{"upper rim", r, 2. * r, radial, up}, {"lower rim", r, -2. * r, radial, down}};
}

TEST_P(OpenSurface, RimsAreCirclesWithTheSurfaceOnTheirLeft)
{
  const unsigned int k = GetParam();
  for (const std::string name : {"cap", "disc", "tube", "annulus"})
    for (const bool axial : {false, true})
    {
      SCOPED_TRACE(name + (axial ? " axial" : ""));
      const SurfaceDiscretization d = make_start_shape(start(name, k, 2, axial));
      const std::vector<Rim> rims   = exact_rims(name);
      EXPECT_FALSE(d.is_closed());
      EXPECT_EQ(d.mesh_reference, d.positions);
      EXPECT_EQ(d.rigid_motions.size(), axial ? 1u : 6u);
      ASSERT_EQ(d.edges.size(), rims.size());
      for (std::size_t i = 0; i < rims.size(); ++i)
      {
        const EdgeLoop &loop = d.edges[i];
        EXPECT_EQ(loop.name, rims[i].name);
        EXPECT_TRUE(loop.is_rim);
        for (const std::size_t n : loop.cell_nodes)
        {
          EXPECT_NEAR(std::hypot(node(d, n)[0], node(d, n)[1]), rims[i].radius, 1e-14);
          EXPECT_NEAR(node(d, n)[2], rims[i].z, 1e-14);
        }
        const double length = 2. * pi * rims[i].radius;
        EXPECT_NEAR(loop_length(loop, d.positions) / length, 1., axial ? 1e-14 : k == 2 ? 1e-3 : 1e-5);
        const auto nu = conormals(d, loop, d.positions);
        ASSERT_EQ(nu.size(), loop.n_cells * loop.tables.n_points);
        const auto points = points_of(d, loop);
        for (std::size_t q = 0; q < nu.size(); ++q)
        {
          const auto [x, t] = points[q];
          // Off by the angle between the cells and the smooth shape. The declared direction: nu = t x n.
          const double tolerance = k == 2 ? 6e-2 : k == 3 ? 4e-3 : 4e-4;
          EXPECT_NEAR(norm(nu[q]), 1., 1e-14);
          EXPECT_LT(norm(nu[q] - rims[i].conormal(x)), tolerance);
          EXPECT_LT(norm(cross(t, rims[i].normal(x)) / norm(t) - rims[i].conormal(x)), tolerance);
        }
      }
    }
}

TEST_P(OpenSurface, MeridiansRunFromTheAxisOrTheTop)
{
  const unsigned int k = GetParam();
  for (const std::string name : {"cap", "disc", "tube", "annulus"})
  {
    SCOPED_TRACE(name);
    const SurfaceDiscretization d = make_start_shape(start(name, k, 2, true));
    const bool pole               = name == "cap" || name == "disc";
    EXPECT_EQ(d.n_cells, name == "annulus" ? 32u : 8u);
    EXPECT_EQ(d.n_nodes, d.n_cells * k + 1);
    ASSERT_EQ(d.admissible.size(), d.n_nodes);
    for (std::size_t n = 0; n < d.n_nodes; ++n)
      EXPECT_EQ(d.admissible[n].count, n == 0 && pole ? 1u : 2u);
    EXPECT_EQ(d.positions[0] == 0., pole);
    for (std::size_t n = 1; n < d.n_nodes; ++n)
      if (name == "tube")
        EXPECT_LT(node(d, n)[2], node(d, n - 1)[2]);
      else
        EXPECT_GT(node(d, n)[0], node(d, n - 1)[0]);
    EXPECT_EQ(d.edges.back().cell_nodes, (std::vector<std::size_t>{d.n_nodes - 1}));
    EXPECT_EQ(d.edges.back().tables.tables[1][0], 1.);
    if (!pole)
    {
      EXPECT_EQ(d.edges[0].cell_nodes, (std::vector<std::size_t>{0}));
      EXPECT_EQ(d.edges[0].tables.tables[1][0], -1.);
    }
  }
}

/** Halving the cells divides the error by 2^order, until round-off is reached. */
testing::AssertionResult converges(const double coarse, const double fine, const double order)
{
  if (std::abs(fine) < 2e-12 || std::log2(std::abs(coarse / fine)) > order)
    return testing::AssertionSuccess();
  return testing::AssertionFailure() << "errors " << coarse << ", " << fine << ": order "
                                     << std::log2(std::abs(coarse / fine)) << ", not " << order;
}

TEST_P(OpenSurface, AreaConvergesAtTwiceTheDegree)
{
  const unsigned int k = GetParam();
  for (const std::string name : {"cap", "disc", "tube", "annulus"})
    for (const bool axial : {false, true})
    {
      double errors[2];
      for (unsigned int r = 0; r < 2; ++r)
      {
        const SurfaceDiscretization d = make_start_shape(start(name, k, (axial || k < 4 ? 2 : 1) + r, axial));
        errors[r]                     = surface_quality(d, d.positions).area - (name == "annulus" ? .99 * pi : 4. * pi);
      }
      EXPECT_TRUE(converges(errors[0], errors[1], 2. * k - .4)) << name << (axial ? " axial" : "");
    }
}

/** Root mean square of the angle between the cells' normals and the sphere's. */
double normal_error(const SurfaceDiscretization &d, const Vector3<double> &centre, const double R)
{
  double sum = 0., area = 0.;
  std::vector<double> in(d.tables.n_points * 18);
  for (std::size_t cell = 0; cell < d.n_cells; ++cell)
  {
    evaluate_field(d.tables, &d.cell_nodes[cell * d.n_local()], d.positions, 3, in.data());
    for (unsigned int q = 0; q < d.tables.n_points; ++q)
    {
      const double *v         = &in[q * 18];
      const Vector3<double> n = cross(Vector3<double>(v[3], v[4], v[5]), Vector3<double>(v[6], v[7], v[8]));
      const Vector3<double> e = n / norm(n) - (Vector3<double>(v[0], v[1], v[2]) - centre) / R;
      sum += d.tables.weights[q] * norm(n) * dot(e, e);
      area += d.tables.weights[q] * norm(n);
    }
  }
  return std::sqrt(sum / area);
}

ConormalField exact_conormal_of_cap(const double angle)
{
  return [angle](const Vector3<double> &x)
  {
    const double r = std::hypot(x[0], x[1]);
    return Vector3<double>(std::cos(angle) * x[0] / r, std::cos(angle) * x[1] / r, -std::sin(angle));
  };
}

TEST_P(OpenSurface, NormalAndCurvatureOfCapsConvergeAtTheDegree)
{
  const unsigned int k = GetParam();
  for (const double angle : {.3, 1.2, 2.3})
  {
    StartShape shape = start("cap", k, 0, false);
    shape.cap_angle  = angle;
    const double R   = 1. / std::sin(.5 * angle);
    const Vector3<double> centre(0., 0., -R * std::cos(angle));
    double normals[2], curvatures[2];
    for (unsigned int r = 0; r < 2; ++r)
    {
      shape.refinements             = (k < 4 ? 2 : 1) + r;
      const SurfaceDiscretization d = make_start_shape(shape);
      for (std::size_t n = 0; n < d.n_nodes; ++n)
        EXPECT_NEAR(norm(node(d, n) - centre) / R, 1., 1e-14);
      normals[r]          = normal_error(d, centre, R);
      const auto conormal = exact_conormal_of_cap(angle);
      curvatures[r]       = curvature_error(d, R, centre, conormal) * R;
    }
    EXPECT_TRUE(converges(normals[0], normals[1], k - .15)) << angle;
    EXPECT_TRUE(converges(curvatures[0], curvatures[1], k - .15)) << angle;
  }
}

TEST_P(OpenSurface, FlatOnesHaveNoCurvature)
{
  // Whatever the cells: a polynomial surface in the plane obeys the divergence theorem, with the conormals of its own
  // rim.
  for (const std::string name : {"disc", "annulus"})
  {
    StartShape shape              = start(name, GetParam(), 1, false);
    shape.inner_radius            = .4;
    const SurfaceDiscretization d = make_start_shape(shape);
    EXPECT_LT(mean_norm(d, curvature_vector(d)), 1e-9) << name;
  }
}

TEST_P(OpenSurface, NodesAreNumberedOnceAndInteriorEdgesShared)
{
  const unsigned int k = GetParam();
  for (const std::string name : {"cap", "disc", "tube", "annulus"})
  {
    SCOPED_TRACE(name);
    const SurfaceDiscretization d = make_start_shape(start(name, k, 1, false));
    std::size_t n_rim_edges       = 0;
    for (const EdgeLoop &loop : d.edges)
      n_rim_edges += loop.n_cells;
    // V - E + F = chi, with (4 F + rim)/2 edges, k - 1 nodes within an edge and (k - 1)^2 within a cell.
    const int chi             = name == "cap" || name == "disc" ? 1 : 0;
    const std::size_t n_edges = (4 * d.n_cells + n_rim_edges) / 2, n_vertices = n_edges - d.n_cells + chi;
    EXPECT_EQ(d.n_nodes, n_vertices + (k - 1) * n_edges + (k - 1) * (k - 1) * d.n_cells);
    EXPECT_EQ(euler_characteristic(d), chi);
    EXPECT_EQ(euler_characteristic(make_start_shape(start(name, k, 1, true))), chi);

    std::set<std::array<double, 3>> places;
    for (std::size_t n = 0; n < d.n_nodes; ++n)
      places.insert({{std::round(1e9 * node(d, n)[0]) + 0., std::round(1e9 * node(d, n)[1]) + 0.,
                      std::round(1e9 * node(d, n)[2]) + 0.}});
    EXPECT_EQ(places.size(), d.n_nodes);
    EXPECT_EQ(std::set<std::size_t>(d.cell_nodes.begin(), d.cell_nodes.end()).size(), d.n_nodes);
  }
}

INSTANTIATE_TEST_SUITE_P(Degrees, OpenSurface, testing::Values(2u, 3u, 4u, 5u));

TEST(OpenSurfaces, CellCountsAndShapes)
{
  for (unsigned int r = 0; r <= 3; ++r)
  {
    for (const std::string name : {"cap", "disc"})
    {
      const SurfaceDiscretization d = make_start_shape(start(name, 2, r, false));
      EXPECT_EQ(d.n_cells, 12u << (2 * r));
      EXPECT_EQ(d.edges[0].n_cells, 8u << r);
      const SurfaceQuality q = surface_quality(d, d.positions);
      EXPECT_LT(q.cell_area_ratio, 2.6);
      EXPECT_LT(q.largest_aspect, 2.2);
      EXPECT_GT(q.min_cell_quality, .8);
      EXPECT_EQ(make_start_shape(start(name, 2, r, true)).n_cells, 2u << r);
    }
    EXPECT_EQ(make_start_shape(start("annulus", 2, r, false)).n_cells, 64u << (2 * r));
    EXPECT_EQ(make_start_shape(start("annulus", 2, r, true)).n_cells, 8u << r);
    EXPECT_EQ(make_start_shape(start("tube", 2, r, true)).n_cells, 2u << r);
    EXPECT_EQ(make_start_shape(start("tube", 2, r, false)).n_cells, 12u << (2 * r)); // 4 around, 3 along
  }
  for (const double ratio : {.2, 1., 2. * pi, 40.})
  {
    const SurfaceDiscretization d = tube(ratio, 1., 3, 2, false);
    EXPECT_LT(surface_quality(d, d.positions).largest_aspect, 1.65) << ratio;
  }
}

TEST(OpenSurfaces, CapsTendToTheDisc)
{
  for (const bool axial : {false, true})
  {
    const SurfaceDiscretization flat = disc(pi, 3, 1, axial), shallow = cap(1e-4, pi, 3, 1, axial);
    ASSERT_EQ(flat.n_nodes, shallow.n_nodes);
    EXPECT_EQ(flat.cell_nodes, shallow.cell_nodes);
    for (std::size_t i = 0; i < flat.positions.size(); ++i)
      EXPECT_NEAR(flat.positions[i], shallow.positions[i], i % 3 == 2 ? 6e-5 : 1e-8);
  }
}

TEST(OpenSurfaces, RadialCellsAreGraded)
{
  const auto sizes = [](const double smallest, const double smallest_outer, const bool axial)
  {
    AnnulusShape ring;
    ring.inner_radius             = .1;
    ring.outer_radius             = 2.;
    ring.smallest                 = smallest;
    ring.smallest_outer           = smallest_outer;
    const SurfaceDiscretization d = annulus(ring, 3, 1, axial);
    std::set<double> radii; // of vertices
    const std::size_t n = d.n_local();
    for (std::size_t cell = 0; cell < d.n_cells; ++cell)
      for (const std::size_t corner :
           axial ? std::vector<std::size_t>{0, n - 1} : std::vector<std::size_t>{0, 3, 12, 15})
      {
        const Vector3<double> x = node(d, d.cell_nodes[cell * n + corner]);
        radii.insert(std::round(1e12 * std::hypot(x[0], x[1])) / 1e12);
      }
    EXPECT_EQ(radii.size(), 17u);
    EXPECT_NEAR(*radii.begin(), .1, 1e-12);
    EXPECT_NEAR(*radii.rbegin(), 2., 1e-12);
    std::vector<double> result;
    for (auto r = std::next(radii.begin()); r != radii.end(); ++r)
      result.push_back(*r - *std::prev(r));
    return result;
  };
  for (const bool axial : {false, true})
  {
    for (const double size : sizes(0., 0., axial))
      EXPECT_NEAR(size, 1.9 / 16., 1e-11);
    for (const double size : sizes(1.9 / 16., 0., axial))
      EXPECT_NEAR(size, 1.9 / 16., 1e-8);

    const auto inner = sizes(.01, 0., axial);
    EXPECT_NEAR(inner.front(), .01, 1e-11);
    for (std::size_t i = 2; i < inner.size(); ++i) // a geometric progression
      EXPECT_NEAR(inner[i] / inner[i - 1], inner[1] / inner[0], 1e-8);

    const auto outer = sizes(0., .03, axial);
    EXPECT_NEAR(outer.back(), .03, 1e-11);

    const auto both = sizes(.01, .05, axial);
    EXPECT_NEAR(both.front(), .01, 2e-4);
    EXPECT_NEAR(both.back(), .05, 4e-3);
    EXPECT_GT(*std::max_element(both.begin(), both.end()), .2);
  }
}

TEST(OpenSurfaces, MistakesAreRefused)
{
  const auto with = [](const std::string &name, const std::function<void(StartShape &)> &change)
  {
    StartShape shape = start(name, 3, 1, false);
    change(shape);
    return make_start_shape(shape);
  };
  EXPECT_USER_ERROR(with("cup", [](StartShape &) {}), "'cup' is not known", "'cap'");
  for (const double angle : {0., pi, -1., std::nan("")})
    EXPECT_USER_ERROR(with("cap", [&](StartShape &s) { s.cap_angle = angle; }), "Cap angle = ", "between 0 and pi",
                      "'disc'");
  for (const double ratio : {0., -1., infinity})
    EXPECT_USER_ERROR(with("tube", [&](StartShape &s) { s.tube_ratio = ratio; }), "Tube ratio = ", "length/radius");
  EXPECT_USER_ERROR(with("annulus", [](StartShape &s) { s.inner_radius = 1.; }), "Inner radius = 1, outer radius = 1",
                    "0 < inner radius < outer radius");
  EXPECT_USER_ERROR(with("annulus", [](StartShape &s) { s.inner_radius = 0.; }), "Inner radius = 0");
  EXPECT_USER_ERROR(with("annulus", [](StartShape &s) { s.radial_cells = 3; }), "at least 4 cells", "not 3");
  EXPECT_USER_ERROR(with("annulus", [](StartShape &s) { s.smallest_cell = .1; }), "Smallest cell = 0.1", "0.05625",
                    "16 equal cells");
  EXPECT_USER_ERROR(with("annulus", [](StartShape &s) { s.smallest_outer_cell = -.1; }), "Smallest outer cell = -0.1");
  EXPECT_USER_ERROR(with("annulus", [](StartShape &s) { s.smallest_cell = 1e-9; }), "Smallest cell = 1e-09",
                    "at most 3", "Refine");
  EXPECT_USER_ERROR(with("disc", [](StartShape &s) { s.area = -1.; }), "Area = -1");
  EXPECT_USER_ERROR(with("cap", [](StartShape &s) { s.axial = s.mirror = true; }), "'cap' is open", "mirror plane");
  EXPECT_USER_ERROR(with("tube", [](StartShape &s) { s.region_fraction = .5; }), "Region fraction = 0.5",
                    "'tube' is open");
}
} // namespace

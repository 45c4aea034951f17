// SPDX-License-Identifier: LGPL-2.1-or-later
// Closest points of surfaces made of cells: against samples of the whole surface, on edges, at rims, from both sides.
#include "sample_sheets.h"

#include <pellicle/assembly/contact_search.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/builders.h>
#include <pellicle/discretization/point_walk.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

const Vector3<double> nothing;

ContactSearch make_search(const SurfaceDiscretization &surface, const SearchLimits &limits)
{
  ContactSearch search(surface_cells(surface), limits);
  search.update(surface.positions);
  return search;
}

/** Distance from the nearest of many points of the surface. */
double sampled_distance(const SurfaceDiscretization &surface, const Vector3<double> &x, const unsigned int n_samples)
{
  std::vector<std::array<double, 2>> points;
  for (unsigned int i = 0; i <= n_samples; ++i)
    for (unsigned int j = 0; j <= n_samples; ++j)
      points.push_back({{double(i) / n_samples, double(j) / n_samples}});
  double nearest = 1e300;
  for_all_points(make_tables_at(surface.kind, surface.degree, points), surface.cell_nodes, surface.positions, 1,
                 [&](const WalkPoint &p) { nearest = std::min(nearest, norm(x - p[0])); });
  return nearest;
}

TEST(ContactSearchTest, NothingOfABumpySurfaceIsNearer)
{
  for (unsigned int degree = 1; degree <= 5; ++degree)
  {
    const SurfaceDiscretization bumps =
        sheet(degree, 4,
              [](const double u, const double v)
              { return Vector3<double>(u + 0.05 * std::sin(9. * v), v, 0.1 * std::sin(7. * u) * std::cos(6. * v)); });
    const ContactSearch search = make_search(bumps, {1., 1.});
    std::mt19937 generator(degree);
    std::uniform_real_distribution<double> uniform(0.15, 0.85);
    for (unsigned int i = 0; i < 10; ++i)
    {
      const Vector3<double> x(uniform(generator), uniform(generator), 0.3 * (uniform(generator) - 0.5));
      const double sampled = sampled_distance(bumps, x, 20);
      const auto found     = search.closest(x, nothing);
      ASSERT_TRUE(found);
      EXPECT_NEAR(std::abs(found->gap), found->at.distance, 1e-12);
      EXPECT_LE(found->at.distance, sampled + 1e-12);
      EXPECT_GT(found->at.distance, sampled - 3e-2);
      EXPECT_NEAR(norm(x - found->gap * found->normal - found->at.foot), 0., 1e-9);
    }
  }
}

TEST(ContactSearchTest, GapsOfASphereAreRadial)
{
  const SurfaceDiscretization sphere = on_cube_sphere(ellipsoid({{1., 1., 1.}}), 3, 1);
  const ContactSearch search         = make_search(sphere, {0.5, 0.5});
  std::mt19937 generator(4);
  std::normal_distribution<double> normal;
  for (const double g : {0.3, 1e-3, -1e-3, -0.3})
    for (unsigned int i = 0; i < 30; ++i)
    {
      Vector3<double> e(normal(generator), normal(generator), normal(generator));
      e                = e / norm(e);
      const auto found = search.closest((1. + g) * e, -e);
      ASSERT_TRUE(found);
      EXPECT_NEAR(found->gap, g, 6e-4);
      EXPECT_NEAR(dot(found->normal, e), 1., 1e-3);
    }
  EXPECT_FALSE(search.closest({0., 0., 1.1}, {0., 0., 1.})) << "faces away";
  EXPECT_FALSE(search.closest({0., 0., 1.6}, {0., 0., -1.})) << "too far";
}

TEST(ContactSearchTest, EdgesAndVerticesOfABox)
{
  const ContactSearch search = make_search(box({1., 1., 1.}), {1., 0.6});
  const auto edge            = search.closest({1.3, 1.4, 0.25}, nothing);
  ASSERT_TRUE(edge);
  EXPECT_EQ(edge->at.n_free(), 1u);
  EXPECT_NEAR(edge->gap, 0.5, 1e-14);
  EXPECT_NEAR(edge->normal[0], 0.6, 1e-14);
  EXPECT_NEAR(edge->at.foot[2], 0.25, 1e-14);
  const ClosestPoint variations({1.3, 1.4, 0.25}, master_point(search.shape(edge->cell), edge->at));
  EXPECT_NEAR(variations.gap, 0.5, 1e-14);
  EXPECT_EQ(variations.B.size(), 1u);

  const auto vertex = search.closest({-0.1, 1.2, -0.2}, nothing);
  ASSERT_TRUE(vertex);
  EXPECT_EQ(vertex->at.n_free(), 0u);
  EXPECT_NEAR(vertex->gap, 0.3, 1e-14);

  const auto face = search.closest({0.5, 0.9, 0.4}, nothing);
  ASSERT_TRUE(face);
  EXPECT_EQ(face->at.n_free(), 2u);
  EXPECT_NEAR(face->gap, -0.1, 1e-14);
  EXPECT_NEAR(face->normal[1], 1., 1e-14);
  // above an edge the slope along the face vanishes: still the interior of a face
  const auto above = search.closest({1., 0.5, 1.2}, nothing);
  ASSERT_TRUE(above);
  EXPECT_EQ(above->at.n_free(), 2u);
  EXPECT_NEAR(above->normal[2], 1., 1e-14);
}

// Inside the valley between two sloping squares the edge is closest: the gap is negative, n_p still points outward.
TEST(ContactSearchTest, BelowAValley)
{
  const SurfaceDiscretization valley =
      sheet(1, 2, [](const double u, const double v) { return Vector3<double>(u, v, std::abs(u - 0.5)); });
  const auto found = make_search(valley, {1., 1.}).closest({0.5, 0.3, -0.2}, {0., 0., -1.});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->at.n_free(), 1u);
  EXPECT_NEAR(found->gap, -0.2, 1e-14);
  EXPECT_NEAR(found->normal[2], 1., 1e-14);
}

TEST(ContactSearchTest, TheSideThatFacesIsTaken)
{
  const ContactSearch search = make_search(box({1., 1., 0.1}), {0.5, 0.09});
  const Vector3<double> x    = {0.4, 0.4, 0.07};
  const auto upper = search.closest(x, {0.1, 0., -1.}), lower = search.closest(x, {0.1, 0., 1.});
  ASSERT_TRUE(upper && lower);
  EXPECT_NEAR(upper->gap, -0.03, 1e-14);
  EXPECT_NEAR(lower->gap, -0.07, 1e-14);
  EXPECT_NEAR(lower->normal[2], -1., 1e-14);
}

TEST(ContactSearchTest, PointsBesideAnOpenMasterHaveNoPartner)
{
  const SurfaceDiscretization square =
      sheet(2, 3, [](const double u, const double v) { return Vector3<double>(u, v, 0.); });
  const ContactSearch search = make_search(square, {1., 1.});
  EXPECT_FALSE(search.closest({1.01, 0.5, 0.1}, nothing));
  EXPECT_FALSE(search.closest({1.01, -0.01, 0.1}, nothing));
  EXPECT_TRUE(search.closest({0.99, 0.5, 0.1}, nothing));
  EXPECT_TRUE(search.closest({1., 0.5, 0.1}, nothing));

  // Of two rows the upper one alone: its lower side is a rim. Joined by twins instead of nodes it is none.
  ContactSearch part(surface_cells(square, {6, 7, 8}), {1., 1.});
  part.update(square.positions);
  EXPECT_FALSE(part.closest({0.5, 0.6, 0.1}, nothing));
  EXPECT_TRUE(part.closest({0.5, 0.7, 0.1}, nothing));

  SurfaceDiscretization roof =
      sheet(1, 2, [](const double u, const double v) { return Vector3<double>(u, v, -std::abs(u - 0.5)); });
  for (std::size_t middle = 1; middle < 9; middle += 3)
  {
    roof.twins.emplace_back(roof.n_nodes, middle);
    for (const std::size_t c : {1, 3})
      for (std::size_t i = 4 * c; i < 4 * c + 4; ++i)
        if (roof.cell_nodes[i] == middle)
          roof.cell_nodes[i] = roof.n_nodes;
    for (unsigned int c = 0; c < 3; ++c)
      roof.positions.push_back(roof.positions[3 * middle + c]);
    ++roof.n_nodes;
  }
  EXPECT_TRUE(make_search(roof, {1., 1.}).closest({0.5, 0.3, 0.1}, nothing));
  roof.twins.clear();
  EXPECT_FALSE(make_search(roof, {1., 1.}).closest({0.5, 0.3, 0.1}, nothing));
}

TEST(ContactSearchTest, ThePreviousCellIsKept)
{
  const ContactSearch search =
      make_search(sheet(2, 2, [](const double u, const double v) { return Vector3<double>(u, v, 0.); }), {1., 1.});
  for (const std::size_t previous : {0, 1, 2, 3})
    EXPECT_EQ(search.closest({0.5, 0.5, 0.1}, nothing, previous)->cell, previous);
  EXPECT_EQ(search.closest({0.6, 0.6, 0.1}, nothing, 0)->cell, 3u);
}

TEST(ContactSearchTest, ATooDeepStartIsNamed)
{
  const ContactSearch search = make_search(box({1., 1., 1.}), {0.1, 0.2});
  try
  {
    search.closest({0.5, 0.5, 0.7}, {0., 0., -1.});
    FAIL();
  }
  catch (const SolveError &error)
  {
    const std::string text = error.what();
    EXPECT_NE(text.find("(0.500000, 0.500000, 0.700000)"), std::string::npos) << text;
    EXPECT_NE(text.find("0.300000 inside cell 5"), std::string::npos) << text;
  }
}

TEST(ContactSearchTest, LimitsArePositive)
{
  EXPECT_THROW(ContactSearch(surface_cells(box({1., 1., 1.})), {0., 1.}), UserError);
  EXPECT_THROW(ContactSearch(surface_cells(box({1., 1., 1.})), {1., 0.}), UserError);
}

// Numbers of nodes are shifted for surfaces that share a vector of positions.
TEST(ContactSearchTest, SecondSurfaceOfAVector)
{
  const SurfaceDiscretization square =
      sheet(2, 1, [](const double u, const double v) { return Vector3<double>(u, v, 0.5); });
  NodalVectors positions(3 * 7, 1e3);
  positions.insert(positions.end(), square.positions.begin(), square.positions.end());
  ContactSearch search(surface_cells(square, {}, 7), {1., 1.});
  search.update(positions);
  EXPECT_NEAR(search.closest({0.3, 0.3, 0.6}, nothing)->gap, 0.1, 1e-14);
  EXPECT_EQ(search.master().nodes(0)[8], 15u);
}
} // namespace

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "shapes.h"

#include <pellicle/models/make_sample.h>

#include <gtest/gtest.h>

namespace
{
using namespace pellicle;
using namespace pellicle::test_shapes;

/** Position, height z and the vector (x, y, 2 z) of every node. */
std::vector<SampledNodalField> linear_fields(const NodalVectors &positions)
{
  SampledNodalField height{"height", 1, {}}, stretched{"stretched", 3, {}};
  for (std::size_t I = 0; I < positions.size() / 3; ++I)
  {
    const Vector3<double> x = node(positions, I);
    height.values.push_back(x[2]);
    for (unsigned int c = 0; c < 3; ++c)
      stretched.values.push_back(c == 2 ? 2. * x[c] : x[c]);
  }
  return {{"position", 3, positions}, height, stretched};
}

Vector3<double> point(const SurfaceSample &sample, const std::size_t p)
{
  return node(sample.points, p);
}

/** The whole cell faces outwards: flat triangles of its sub-cells, seen from the origin (the shape is star-shaped). */
void expect_outward(const SurfaceSample &sample)
{
  const unsigned int n = sample.degree + 1;
  for (std::size_t cell = 0; cell < sample.n_cells; ++cell)
    for (unsigned int j = 0; j + 1 < n; ++j)
      for (unsigned int i = 0; i + 1 < n; ++i)
      {
        const std::size_t p              = cell * n * n + j * n + i;
        const Vector3<double> diagonal_1 = point(sample, p + n + 1) - point(sample, p),
                              diagonal_2 = point(sample, p + n) - point(sample, p + 1);
        EXPECT_GT(dot(cross(diagonal_1, diagonal_2), point(sample, p) + point(sample, p + n + 1)), 0.);
      }
}

/** Volume of the polyhedron through the points. */
double enclosed_volume(const SurfaceSample &sample)
{
  const unsigned int n = sample.degree + 1;
  double sum           = 0.;
  for (std::size_t cell = 0; cell < sample.n_cells; ++cell)
    for (unsigned int j = 0; j + 1 < n; ++j)
      for (unsigned int i = 0; i + 1 < n; ++i)
      {
        const std::size_t p = cell * n * n + j * n + i;
        const auto a = point(sample, p), b = point(sample, p + 1), c = point(sample, p + n + 1),
                   d = point(sample, p + n);
        sum += (dot(a, cross(b, c)) + dot(a, cross(c, d))) / 6.;
      }
  return sum;
}

void expect_linear_fields(const SurfaceSample &sample)
{
  ASSERT_EQ(sample.fields.size(), 3U);
  EXPECT_EQ(sample.fields[0].name, "position");
  EXPECT_EQ(sample.fields[0].values, sample.points);
  ASSERT_EQ(sample.fields[1].n_components, 1U);
  ASSERT_EQ(sample.fields[1].values.size(), sample.n_points());
  ASSERT_EQ(sample.fields[2].n_components, 3U);
  for (std::size_t p = 0; p < sample.n_points(); ++p)
  {
    const Vector3<double> x = point(sample, p), v = node(sample.fields[2].values, p);
    EXPECT_NEAR(norm(v - Vector3<double>(x[0], x[1], 2. * x[2])), 0., 1e-13);
  }
}

TEST(MakeSample, SurfaceAtEquidistantPoints)
{
  const auto surface = on_cube_sphere(sphere(1.), 4, 1);
  const auto sample  = make_sample(surface, surface.positions, linear_fields(surface.positions));
  EXPECT_EQ(sample.degree, 4U);
  EXPECT_EQ(sample.n_cells, 24U);
  ASSERT_EQ(sample.points.size(), 3 * sample.n_points());
  expect_linear_fields(sample);
  expect_outward(sample);
  for (std::size_t p = 0; p < sample.n_points(); ++p)
    EXPECT_NEAR(norm(point(sample, p)), 1., 2e-4);
  for (std::size_t p = 0; p < sample.n_points(); ++p)
    EXPECT_NEAR(sample.fields[1].values[p], point(sample, p)[2], 1e-14);

  // Corners are nodes, and the centre of an even degree's cell too; (1/4, 0) is not.
  const auto first = [&](const unsigned int i)
  { return norm(point(sample, i) - node(surface.positions, surface.cell_nodes[i])); };
  for (const unsigned int i : {0U, 4U, 12U, 20U, 24U})
    EXPECT_LT(first(i), 1e-14);
  EXPECT_GT(first(1), 1e-3);
}

TEST(MakeSample, MeridianIsRevolved)
{
  const SmoothShape shape = ellipsoid({{1.2, 1.2, 0.7}});
  for (const bool mirror : {false, true})
  {
    const auto meridian = on_meridian(shape, 3, 2, mirror);
    auto fields         = linear_fields(meridian.positions);
    const auto sample   = make_sample(meridian, meridian.positions, fields, 12);
    EXPECT_EQ(sample.n_cells, 16U * 12U);
    ASSERT_EQ(sample.points.size(), 3 * sample.n_points());
    expect_linear_fields(sample);
    expect_outward(sample);
    double top = 0., bottom = 0.;
    for (std::size_t p = 0; p < sample.n_points(); ++p)
    {
      const Vector3<double> x = point(sample, p);
      EXPECT_NEAR((x[0] * x[0] + x[1] * x[1]) / 1.44 + x[2] * x[2] / 0.49, 1., 1e-3); // on the surface
      const double height = sample.fields[1].values[p];
      EXPECT_NEAR(height, mirror ? std::abs(x[2]) : x[2], 1e-13); // scalars are even
      top    = std::max(top, x[2]);
      bottom = std::min(bottom, x[2]);
    }
    EXPECT_NEAR(top, 0.7, 1e-14);
    EXPECT_NEAR(bottom, -0.7, 1e-14);
    EXPECT_NEAR(enclosed_volume(sample), shape.volume, 0.02 * shape.volume);
  }
}

// Points of one parallel have one radius, and the seam closes exactly.
TEST(MakeSample, ParallelsAreCircles)
{
  const auto meridian  = on_meridian(sphere(1.), 3, 1, false);
  const auto sample    = make_sample(meridian, meridian.positions, {});
  const unsigned int n = 4;
  ASSERT_EQ(sample.n_cells, 8U * default_n_azimuth);
  for (std::size_t band = 0; band < 8; ++band)
    for (unsigned int i = 0; i < n; ++i)
    {
      const std::size_t first     = band * default_n_azimuth * n * n + i;
      const Vector3<double> start = point(sample, first);
      for (std::size_t cell = 0; cell < default_n_azimuth; ++cell)
        for (unsigned int j = 0; j < n; ++j)
        {
          const Vector3<double> x = point(sample, first + cell * n * n + j * n);
          EXPECT_NEAR(std::hypot(x[0], x[1]), start[0], 1e-15);
          EXPECT_EQ(x[2], start[2]);
          if (start[0] > 0.1)
          {
            EXPECT_NEAR(std::remainder(std::atan2(x[1], x[0]) - 2. * pi * (cell + j / 3.) / default_n_azimuth, 2. * pi),
                        0., 1e-14);
          }
        }
      EXPECT_EQ(point(sample, first + (default_n_azimuth - 1) * n * n + 3 * n).components, start.components);
    }
}
} // namespace

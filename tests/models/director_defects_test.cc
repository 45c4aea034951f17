// SPDX-License-Identifier: LGPL-2.1-or-later
// Defects of director fields that are known in closed form.
#include <pellicle/base/constants.h>
#include <pellicle/discretization/builders.h>
#include <pellicle/discretization/start_shapes.h>
#include <pellicle/models/director_defects.h>
#include <pellicle/models/director_start.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace pellicle;
using Direction = Vector3<double>;

SurfaceDiscretization start_shape(const std::string &name, const unsigned int degree, const int refinements,
                                  const bool axial = false)
{
  StartShape shape;
  shape.name        = name;
  shape.semi_axes   = {{1., 1., 1.}};
  shape.area        = 4. * pi;
  shape.degree      = degree;
  shape.refinements = refinements;
  shape.axial       = axial;
  return make_start_shape(shape);
}

int total_charge(const std::vector<Defect> &defects)
{
  int sum = 0;
  for (const Defect &defect : defects)
    sum += defect.charge;
  return sum;
}

/** Directors along a vector field, in the surface where it is large against `core`, normal where zero. */
template <typename Field>
NodalVectors along_field(const SurfaceDiscretization &sphere, const double core, const Field &field)
{
  NodalVectors directors;
  for (std::size_t I = 0; I < sphere.n_nodes; ++I)
  {
    const Direction x(sphere.positions[3 * I], sphere.positions[3 * I + 1], sphere.positions[3 * I + 2]);
    const Direction n = (1. / norm(x)) * x, g = field(n), t = g - dot(g, n) * n, O = t + core * n;
    for (unsigned int c = 0; c < 3; ++c)
      directors.push_back(norm(O) > 0. ? O[c] / norm(O) : n[c]);
  }
  return directors;
}

TEST(DirectorDefects, StartFieldsOfTheSphere)
{
  for (const auto &[degree, refinements] : {std::pair(3, 1), {3, 2}, {2, 2}, {4, 1}})
    for (const char *name : {"meridional", "azimuthal"})
      for (const double noise : {0., 0.05})
      {
        SCOPED_TRACE(std::string(name) + ", degree " + std::to_string(degree) + ", noise " + std::to_string(noise));
        const SurfaceDiscretization sphere = start_shape("ellipsoid", degree, refinements);
        NodalVectors directors             = start_directors(sphere, name, 0.);
        add_director_noise(sphere, noise, 3, directors);
        const auto defects = director_defects(sphere, sphere.positions, directors);
        ASSERT_TRUE(defects);
        ASSERT_EQ(defects->size(), 2u);
        const double spacing = pi / 2. / ((1 << refinements) * degree);
        double product       = 1.;
        for (const Defect &defect : *defects)
        {
          EXPECT_EQ(defect.charge, 1);
          product *= defect.position[2];
          EXPECT_LT(norm(defect.position - Direction(0., 0., std::copysign(1., defect.position[2]))), 0.5 * spacing);
        }
        EXPECT_LT(product, 0.) << "one at each pole";
      }
}

// xyz has eight extrema on the sphere, in the octants, and six saddles, on the axes. Turned, they are not at nodes.
TEST(DirectorDefects, GradientWithSaddles)
{
  const double c = std::cos(0.7), s = std::sin(0.7);
  const auto turned = [&](const Direction &v, const double sign)
  {
    const Direction w(c * v[0] - sign * s * v[1], sign * s * v[0] + c * v[1], v[2]);
    return sign > 0. ? Direction(w[0], c * w[1] - s * w[2], s * w[1] + c * w[2]) : w;
  };
  const auto turned_back = [&](const Direction &v)
  { return turned(Direction(v[0], c * v[1] + s * v[2], -s * v[1] + c * v[2]), -1.); };
  const SurfaceDiscretization sphere = start_shape("ellipsoid", 3, 3);
  for (const bool along_axes : {true, false})
    for (const double core : {0., 0.05})
    {
      SCOPED_TRACE("core " + std::to_string(core));
      const NodalVectors directors = along_field(sphere, core,
                                                 [&](const Direction &n)
                                                 {
                                                   const Direction m = along_axes ? n : turned_back(n),
                                                                   g(m[1] * m[2], m[0] * m[2], m[0] * m[1]);
                                                   return along_axes ? g : turned(g, 1.);
                                                 });
      const auto defects           = director_defects(sphere, sphere.positions, directors);
      ASSERT_TRUE(defects);
      EXPECT_EQ(defects->size(), 14u);
      EXPECT_EQ(total_charge(*defects), 2);
      for (const Defect &defect : *defects)
      {
        const Direction m = along_axes ? defect.position : turned_back(defect.position);
        double largest    = 0.;
        for (const double x : m.components)
          largest = std::max(largest, std::abs(x));
        if (defect.charge < 0)
          EXPECT_GT(largest, 0.99);
        else
          for (const double x : m.components)
            EXPECT_NEAR(std::abs(x), std::sqrt(1. / 3.), 0.05);
      }
    }
}

// The field of a dipole on the plane, laid on the sphere: one defect, which turns twice.
TEST(DirectorDefects, OneOfChargeTwo)
{
  const SurfaceDiscretization sphere = start_shape("ellipsoid", 3, 2);
  // The image of a constant field under stereographic projection from the north pole.
  const NodalVectors directors = along_field(
      sphere, 0.,
      [](const Direction &n) { return Direction(1. - n[2] - n[0] * n[0], -n[0] * n[1], n[0] * (1. - n[2])); });
  const auto defects = director_defects(sphere, sphere.positions, directors);
  ASSERT_TRUE(defects);
  ASSERT_EQ(defects->size(), 1u);
  EXPECT_EQ((*defects)[0].charge, 2);
  EXPECT_LT(norm((*defects)[0].position - Direction(0., 0., 1.)), 0.05);
}

TEST(DirectorDefects, NoneOnTheTorus)
{
  const SurfaceDiscretization surface = torus(std::sqrt(2.), 4. * pi, 3, 1);
  NodalVectors directors              = start_directors(surface, "azimuthal", 0.);
  add_director_noise(surface, 0.05, 3, directors);
  const auto defects = director_defects(surface, surface.positions, directors);
  ASSERT_TRUE(defects);
  EXPECT_TRUE(defects->empty());
  // Meridional: t is zero, and turns round, all along the two horizontal circles, where no charge is.
  EXPECT_EQ(
      total_charge(director_defects(surface, surface.positions, start_directors(surface, "meridional", 0.)).value()),
      0);
}

TEST(DirectorDefects, AreNotThoseOfNormals)
{
  const SurfaceDiscretization sphere = start_shape("ellipsoid", 3, 1);
  EXPECT_FALSE(director_defects(sphere, sphere.positions, start_directors(sphere, "normal", 0.)));
  EXPECT_FALSE(director_defects(sphere, sphere.positions, start_directors(sphere, "towards z", 0.4)));
}

TEST(DirectorDefects, OnAMeridian)
{
  const SurfaceDiscretization meridian = start_shape("ellipsoid", 3, 2, true);
  EXPECT_FALSE(director_defects(meridian, meridian.positions, start_directors(meridian, "normal", 0.)));
  const auto defects = director_defects(meridian, meridian.positions, start_directors(meridian, "meridional", 0.));
  ASSERT_TRUE(defects);
  ASSERT_EQ(defects->size(), 2u);
  EXPECT_EQ(total_charge(*defects), 2);
  EXPECT_NEAR(std::abs((*defects)[0].position[2]), 1., 1e-12);
  EXPECT_NEAR((*defects)[0].position[2] + (*defects)[1].position[2], 0., 1e-12);
}

// In a flat disc: a defect inside is one, what leaves the plane at the rim is none.
TEST(DirectorDefects, OfADisc)
{
  const SurfaceDiscretization disc = start_shape("disc", 3, 2);
  const double radius              = 2.;
  const auto with                  = [&](const Direction &centre, const bool out_at_rim)
  {
    NodalVectors directors;
    for (std::size_t I = 0; I < disc.n_nodes; ++I)
    {
      const Direction x(disc.positions[3 * I], disc.positions[3 * I + 1], 0.);
      Direction O = x - centre;
      if (norm(O) == 0. || (out_at_rim && norm(x) > 0.8 * radius))
        O = Direction(0., 0., 1.);
      for (unsigned int c = 0; c < 3; ++c)
        directors.push_back(O[c] / norm(O));
    }
    return director_defects(disc, disc.positions, directors).value();
  };
  for (const bool out_at_rim : {false, true})
    for (const Direction &centre : {Direction(0., 0., 0.), Direction(0.31, 0.23, 0.)})
    {
      const auto defects = with(centre, out_at_rim);
      ASSERT_EQ(defects.size(), 1u);
      EXPECT_EQ(defects[0].charge, 1);
      EXPECT_LT(norm(defects[0].position - centre), 0.1);
    }
  EXPECT_TRUE(with(Direction(5., 0., 0.), false).empty());
}
} // namespace

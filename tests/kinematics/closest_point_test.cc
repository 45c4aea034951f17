// SPDX-License-Identifier: LGPL-2.1-or-later
// Variations of gap and closest point against differences of the projection, inside cells, on edges, at vertices.
#include "bernstein_patch.h"

#include <pellicle/base/exceptions.h>
#include <pellicle/kinematics/gap_second_variation.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

/** A patch, a point off it, and which parameters of its closest point are free. */
struct Case
{
  std::string name;
  PatchAndPoint patch;
  std::array<double, 2> xi;
  std::vector<unsigned int> free;

  MasterPoint master() const { return patch.master(xi, free); }
  ClosestPoint point() const { return ClosestPoint(patch.point(), master()); }

  /** The closest point after an increment. */
  Case moved(const double eps, const std::vector<double> &u) const
  {
    Case other = *this;
    for (std::size_t i = 0; i < u.size(); ++i)
      other.patch.coordinates[i] += eps * u[i];
    other.patch.closest(other.xi, free);
    return other;
  }
};

/** x off the point xi at distance g: along the normal, on edges and at vertices in a direction normal to what is free.
 */
Case make_case(const unsigned int degree, const std::array<double, 2> &xi, const std::vector<unsigned int> &free,
               const double g, const unsigned int seed)
{
  std::mt19937 generator(seed);
  Case c{"Q" + std::to_string(degree) + ", " + std::to_string(free.size()) + " free", random_patch(degree, generator),
         xi, free};
  const MasterPoint p = c.master();
  Vector3<double> n   = p.outward;
  if (free.size() < 2)
    n += Vector3<double>(0.3, 0.4, 0.);
  if (free.size() == 1)
    n -= (dot(n, p.first[0]) / dot(p.first[0], p.first[0])) * p.first[0];
  c.patch.set_point(p.x + (g / norm(n)) * n);
  return c;
}

std::vector<Case> cases(const double g)
{
  std::vector<Case> all;
  for (unsigned int degree = 1; degree <= 3; ++degree)
  {
    all.push_back(make_case(degree, {{0.37, 0.61}}, {0, 1}, g, degree));
    all.push_back(make_case(degree, {{1., 0.4}}, {1}, g, 10 + degree));
    all.push_back(make_case(degree, {{0.7, 0.}}, {0}, g, 20 + degree));
    all.push_back(make_case(degree, {{1., 0.}}, {}, g, 30 + degree));
  }
  return all;
}

std::vector<double> random_direction(const std::size_t n, const unsigned int seed)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  std::vector<double> u(n);
  for (double &value : u)
    value = uniform(generator);
  return u;
}

std::vector<double> times(const DenseMatrix &m, const std::vector<double> &u)
{
  std::vector<double> product(m.n_rows, 0.);
  for (std::size_t i = 0; i < m.n_rows; ++i)
    for (std::size_t j = 0; j < m.n_rows; ++j)
      product[i] += m(i, j) * u[j];
  return product;
}

double inner(const std::vector<double> &a, const std::vector<double> &b)
{
  double sum = 0.;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += a[i] * b[i];
  return sum;
}

double largest_difference(const std::vector<double> &a, const std::vector<double> &b)
{
  double largest = 0.;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

DenseMatrix second_variation(const std::string &name, const ClosestPoint &p)
{
  DenseMatrix m(p.n_rows());
  gap_second_variation(name).add(p, 1., m);
  return m;
}

/** Central differences of quantity(case) along a random direction approach `exact` with the square of the step. */
template <typename Quantity>
void expect_derivative(const Case &c, const std::vector<double> &u, const std::vector<double> &exact,
                       const Quantity &quantity, const std::string &what)
{
  double error[2];
  for (int half = 0; half < 2; ++half)
  {
    const double eps               = half == 0 ? 4e-3 : 2e-3;
    std::vector<double> difference = quantity(c.moved(eps, u)), behind = quantity(c.moved(-eps, u));
    for (std::size_t i = 0; i < difference.size(); ++i)
      difference[i] = (difference[i] - behind[i]) / (2. * eps);
    error[half] = largest_difference(difference, exact);
  }
  EXPECT_LT(error[1], 1e-2 * (1. + largest_difference(exact, std::vector<double>(exact.size(), 0.))))
      << c.name << ": " << what;
  if (error[1] > 1e-11) // else the quantity is linear in u
  {
    EXPECT_NEAR(std::log2(error[0] / error[1]), 2., 0.15) << c.name << ": " << what;
  }
}

TEST(ClosestPointTest, FirstVariations)
{
  for (const double g : {0.15, -0.1})
    for (const Case &c : cases(g))
    {
      const ClosestPoint p        = c.point();
      const std::vector<double> u = random_direction(p.n_rows(), 3);
      EXPECT_NEAR(p.gap, g, 1e-14);
      expect_derivative(
          c, u, {inner(p.N, u)}, [](const Case &moved) { return std::vector<double>{moved.point().gap}; }, "gap");
      for (unsigned int a = 0; a < p.n_parameters; ++a)
        expect_derivative(
            c, u, {inner(p.D[a], u)}, [&](const Case &moved) { return std::vector<double>{moved.xi[moved.free[a]]}; },
            "parameter");
    }
}

TEST(ClosestPointTest, SecondVariationOfTheGap)
{
  for (const double g : {0.15, -0.1})
    for (const Case &c : cases(g))
    {
      const ClosestPoint p   = c.point();
      const DenseMatrix full = second_variation("full", p), equal = second_variation("equal", p);
      for (unsigned int seed = 1; seed < 4; ++seed)
      {
        const std::vector<double> u = random_direction(p.n_rows(), seed);
        expect_derivative(
            c, u, times(full, u), [](const Case &moved) { return moved.point().N; }, "dN");
      }
      const double size = largest_difference(full.entries, std::vector<double>(full.entries.size(), 0.));
      EXPECT_LT(largest_difference(full.entries, equal.entries), 1e-13 * (1. + size)) << c.name;
      for (std::size_t i = 0; i < p.n_rows(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          EXPECT_NEAR(equal(i, j), equal(j, i), 1e-13 * (1. + size)) << c.name;
    }
}

// The variant with D_hat for D; and `none` is nothing.
TEST(ClosestPointTest, HatIsWrongByTheGapToFirstOrder)
{
  for (unsigned int degree = 1; degree <= 3; ++degree)
  {
    double error[2];
    for (int half = 0; half < 2; ++half)
    {
      const ClosestPoint p = make_case(degree, {{0.37, 0.61}}, {0, 1}, half == 0 ? 2e-3 : 1e-3, degree).point();
      error[half] = largest_difference(second_variation("full", p).entries, second_variation("hat", p).entries);
    }
    EXPECT_GT(error[1], 1e-4);
    EXPECT_NEAR(std::log2(error[0] / error[1]), 1., 0.02);
    const ClosestPoint p = make_case(degree, {{0.37, 0.61}}, {0, 1}, 0.1, degree).point();
    for (const double entry : second_variation("none", p).entries)
      EXPECT_EQ(entry, 0.);
  }
}

TEST(ClosestPointTest, SecondVariationOfTheParameters)
{
  for (const double g : {0.15, -0.1})
    for (const Case &c : cases(g))
    {
      const ClosestPoint p = c.point();
      for (unsigned int a = 0; a < p.n_parameters; ++a)
      {
        const DenseMatrix exact      = parameter_second_variation(p, c.master(), a);
        const DenseMatrix simplified = simplified_parameter_second_variation(p, c.master(), a);
        for (unsigned int seed = 1; seed < 3; ++seed)
        {
          const std::vector<double> u = random_direction(p.n_rows(), seed);
          expect_derivative(
              c, u, times(exact, u), [a](const Case &moved) { return moved.point().D[a]; }, "dD");
          expect_derivative(
              c, u, times(simplified, u), [a](const Case &moved) { return moved.point().D_hat[a]; }, "d hat D");
        }
      }
    }
}

// g(Q x + t) = g(x): no change by translations; under rotations the vectors turn along.
TEST(ClosestPointTest, RigidMotionsChangeNothing)
{
  for (const Case &c : cases(0.15))
  {
    const ClosestPoint p   = c.point();
    const DenseMatrix full = second_variation("full", p);
    const std::size_t n    = p.n_rows() / 3;
    const Vector3<double> omega(0.3, -0.8, 0.5);
    std::vector<double> translation(p.n_rows()), rotation(p.n_rows()), turned(p.n_rows());
    for (std::size_t I = 0; I < n; ++I)
    {
      const auto at = [&](const std::vector<double> &v) { return Vector3<double>(v[I], v[n + I], v[2 * n + I]); };
      const Vector3<double> w = cross(omega, at(c.patch.coordinates)), turn = cross(omega, at(p.N));
      for (unsigned int i = 0; i < 3; ++i)
      {
        translation[i * n + I] = omega[i];
        rotation[i * n + I]    = w[i];
        turned[i * n + I]      = turn[i];
      }
    }
    for (const std::vector<double> &motion : {translation, rotation})
    {
      EXPECT_NEAR(inner(p.N, motion), 0., 1e-13) << c.name;
      for (unsigned int a = 0; a < p.n_parameters; ++a)
        EXPECT_NEAR(inner(p.D[a], motion), 0., 1e-12) << c.name;
    }
    EXPECT_LT(largest_difference(times(full, translation), std::vector<double>(p.n_rows(), 0.)), 1e-11) << c.name;
    EXPECT_LT(largest_difference(times(full, rotation), turned), 1e-11) << c.name;
  }
}

// Of a straight edge along e_y and of a vertex: distances from a line and from a point.
TEST(ClosestPointTest, StraightEdgeAndVertex)
{
  std::mt19937 generator(1);
  PatchAndPoint flat = random_patch(1, generator);
  for (unsigned int K = 0; K < 4; ++K)
  {
    flat.at(1 + K, 0) = K % 2;
    flat.at(1 + K, 1) = K / 2;
    flat.at(1 + K, 2) = 0.;
  }
  flat.set_point({1.3, 0.4, 0.4});
  const ClosestPoint edge(flat.point(), flat.master({{1., 0.4}}, {1}));
  const DenseMatrix line = second_variation("full", edge);
  EXPECT_NEAR(edge.gap, 0.5, 1e-15);
  const std::size_t n = 5; // rows of a component
  EXPECT_NEAR(line(0, 0), (1. - 0.36) / 0.5, 1e-14);
  EXPECT_NEAR(line(0, 2 * n), -0.48 / 0.5, 1e-14);
  EXPECT_NEAR(line(n, n), 0., 1e-14);

  flat.set_point({1.2, -0.1, -0.2});
  const ClosestPoint vertex(flat.point(), flat.master({{1., 0.}}, {}));
  EXPECT_NEAR(vertex.gap, -0.3, 1e-15);
  const DenseMatrix corner = second_variation("full", vertex);
  EXPECT_NEAR(corner(0, 0), -(1. - 4. / 9.) / 0.3, 1e-14);
  EXPECT_NEAR(corner(n, 2 * n), (2. / 9.) / 0.3, 1e-14);
}

// The bowl z = (x^2 + y^2)/2 has its centre of curvature at (0, 0, 1).
TEST(ClosestPointTest, CentresOfCurvatureAreRefused)
{
  std::mt19937 generator(1);
  PatchAndPoint bowl = random_patch(2, generator);
  const std::array<double, 3> parabola{{0.5, -0.5, 0.5}}; // Bernstein coefficients of s^2/2, s = -1 ... 1
  for (unsigned int K = 0; K < 9; ++K)
  {
    bowl.at(1 + K, 0) = K % 3 - 1.;
    bowl.at(1 + K, 1) = K / 3 - 1.;
    bowl.at(1 + K, 2) = parabola[K % 3] + parabola[K / 3];
  }
  for (const double height : {0.9, -3.})
  {
    bowl.set_point({0., 0., height});
    const ClosestPoint p(bowl.point(), bowl.master({{0.5, 0.5}}, {0, 1}));
    EXPECT_NEAR(p.gap, height, 1e-15);
    EXPECT_NEAR(p.c(0, 0), 0.25 / (1. - height), 1e-13);
  }
  for (const double height : {1., 1.5})
  {
    bowl.set_point({0., 0., height});
    try
    {
      ClosestPoint(bowl.point(), bowl.master({{0.5, 0.5}}, {0, 1}));
      FAIL() << height;
    }
    catch (const SolveError &error)
    {
      EXPECT_NE(std::string(error.what()).find("centre of curvature"), std::string::npos);
    }
  }
  bowl.set_point(bowl.master({{1., 0.5}}, {1}).x);
  EXPECT_THROW(ClosestPoint(bowl.point(), bowl.master({{1., 0.5}}, {1})), SolveError);
}

TEST(ClosestPointTest, UnknownVariationsAreNamed)
{
  try
  {
    gap_second_variation("ful");
    FAIL();
  }
  catch (const UserError &error)
  {
    EXPECT_NE(std::string(error.what()).find("'full'"), std::string::npos);
  }
}
} // namespace

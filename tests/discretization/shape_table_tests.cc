// SPDX-License-Identifier: LGPL-2.1-or-later
// Shape tables and evaluate_field(): polynomials and their derivatives are reproduced, and revolution is differentiated
// rightly.
#include <pellicle/base/constants.h>
#include <pellicle/discretization/surface_discretization.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace pellicle;
using Kind = SurfaceDiscretization::Kind;

/** (x, y)^p and derivatives, each coordinate with its own powers. */
double power_derivative(const double x, const int power, const int derivative)
{
  double factor = 1.;
  for (int d = 0; d < derivative; ++d)
    factor *= power - d;
  return factor == 0. ? 0. : factor * std::pow(x, power - derivative);
}

/** Nodal coordinates of a cell along one direction on [0, 1], read off the basis itself: sum_I x_I N_I(x) = x needs
 * known nodes. */
std::vector<double> unit_nodes(const unsigned int degree)
{
  // Gauss-Lobatto points on [0, 1].
  switch (degree)
  {
  case 2:
    return {0., .5, 1.};
  case 3:
    return {0., .5 - .5 / std::sqrt(5.), .5 + .5 / std::sqrt(5.), 1.};
  case 4:
    return {0., .5 - .5 * std::sqrt(3. / 7.), .5, .5 + .5 * std::sqrt(3. / 7.), 1.};
  default:
  {
    const double outer = std::sqrt(1. / 3. + 2. * std::sqrt(7.) / 21.),
                 inner = std::sqrt(1. / 3. - 2. * std::sqrt(7.) / 21.);
    return {0., .5 - .5 * outer, .5 - .5 * inner, .5 + .5 * inner, .5 + .5 * outer, 1.};
  }
  }
}

class ShapeTablesOfDegree : public testing::TestWithParam<unsigned int>
{
};

TEST_P(ShapeTablesOfDegree, SurfaceReproducesPolynomialsAndDerivatives)
{
  const unsigned int k                            = GetParam();
  const std::vector<double> nodes                 = unit_nodes(k);
  const std::vector<std::array<double, 2>> points = {{{0.13, 0.71}}, {{0.5, 0.5}}, {{0.97, 0.02}}};
  const ShapeTables tables                        = make_tables_at(Kind::surface, k, points);
  ASSERT_EQ(tables.n_nodes, (k + 1) * (k + 1));
  EXPECT_TRUE(tables.identity_map);
  EXPECT_EQ(tables.weights, std::vector<double>(3, 1.));

  // Component c of node (x, y) is x^k y^(k-1), x y^k, x^2.
  const int px[3] = {int(k), 1, 2}, py[3] = {int(k) - 1, int(k), 0};
  NodalVectors values;
  std::vector<std::size_t> numbers;
  for (const double y : nodes)
    for (const double x : nodes)
    {
      numbers.push_back(numbers.size());
      for (int c = 0; c < 3; ++c)
        values.push_back(std::pow(x, px[c]) * std::pow(y, py[c]));
    }

  std::vector<double> inputs(points.size() * 18);
  evaluate_field(tables, numbers.data(), values, 6, inputs.data());
  const int dx[6] = {0, 1, 0, 2, 1, 0}, dy[6] = {0, 0, 1, 0, 1, 2};
  for (std::size_t q = 0; q < points.size(); ++q)
    for (int s = 0; s < 6; ++s)
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(inputs[(q * 6 + s) * 3 + c],
                    power_derivative(points[q][0], px[c], dx[s]) * power_derivative(points[q][1], py[c], dy[s]), 1e-11)
            << "point " << q << " slot " << s << " component " << c;
}

TEST_P(ShapeTablesOfDegree, MeridianDifferentiatesTheRevolution)
{
  const unsigned int k                            = GetParam();
  const std::vector<std::array<double, 2>> points = {{{0.3, 0.}}, {{0.9, 7.}}};
  const ShapeTables tables                        = make_tables_at(Kind::meridian, k, points);
  ASSERT_EQ(tables.n_nodes, k + 1);
  EXPECT_FALSE(tables.identity_map);

  NodalVectors values; // r = 1 + s^k, a y component that must drop out, z = -s^2
  std::vector<std::size_t> numbers;
  for (const double s : unit_nodes(k))
  {
    numbers.push_back(numbers.size());
    values.insert(values.end(), {1. + std::pow(s, k), 5. * s, -s * s});
  }
  std::vector<double> inputs(points.size() * 18);
  evaluate_field(tables, numbers.data(), values, 6, inputs.data());
  for (std::size_t q = 0; q < points.size(); ++q)
  {
    const double s = points[q][0], r = 1. + std::pow(s, k), r1 = power_derivative(s, k, 1),
                 r11          = power_derivative(s, k, 2);
    const double expected[18] = {r, 0., -s * s, r1, 0., -2. * s, 0., r, 0., r11, 0., -2., 0., r1, 0., -r, 0., 0.};
    for (int i = 0; i < 18; ++i)
      EXPECT_NEAR(inputs[q * 18 + i], expected[i], 1e-11) << "point " << q << " entry " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Degrees, ShapeTablesOfDegree, testing::Values(2u, 3u, 4u, 5u));

TEST(ShapeTables, WeightsIntegrateTheUnitCellAndTheRevolution)
{
  const auto sum = [](const ShapeTables &t)
  {
    double s = 0.;
    for (const double w : t.weights)
      s += w;
    return s;
  };
  EXPECT_EQ(make_surface_tables(3, 4).n_points, 16u);
  EXPECT_NEAR(sum(make_surface_tables(3, 4)), 1., 1e-14);
  EXPECT_NEAR(sum(make_meridian_tables(3, 4, false)), 2. * pi, 1e-13);
  EXPECT_NEAR(sum(make_meridian_tables(3, 4, true)), 4. * pi, 1e-13);
}

TEST(ShapeTables, FewerSlotsLeaveTheOthersUntouched)
{
  const ShapeTables tables = make_surface_tables(2, 2);
  const NodalVectors values(27, 2.);
  const std::vector<std::size_t> numbers = {0, 1, 2, 3, 4, 5, 6, 7, 8};
  for (const unsigned int n_slots : {1u, 2u, 3u, 4u, 5u, 6u})
  {
    std::vector<double> inputs(4 * 18, -77.);
    evaluate_field(tables, numbers.data(), values, n_slots, inputs.data());
    for (unsigned int q = 0; q < 4; ++q)
    {
      EXPECT_NEAR(inputs[q * 18], 2., 1e-14);
      for (unsigned int i = 3 * n_slots; i < 18; ++i)
        EXPECT_EQ(inputs[q * 18 + i], -77.);
    }
  }
}
} // namespace

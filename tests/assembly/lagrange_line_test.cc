// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/discretization/lagrange_line.h>
#include <pellicle/discretization/surface_discretization.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace pellicle;

TEST(LagrangeLineTest, EqualsTheShapeTables)
{
  for (unsigned int degree = 1; degree <= LagrangeLine::largest_degree; ++degree)
  {
    const LagrangeLine line(degree);
    const std::array<double, 2> xi{{0.23, 0.81}};
    const ShapeTables tables     = make_tables_at(SurfaceDiscretization::Kind::surface, degree, {xi});
    const LagrangeLine::Values s = line.at(xi[0]), t = line.at(xi[1]);
    const unsigned int orders[6][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}};
    for (unsigned int slot = 0; slot < 6; ++slot)
      for (unsigned int i = 0; i < tables.n_nodes; ++i)
        EXPECT_NEAR(tables.tables[slot][i], s[orders[slot][0]][i % (degree + 1)] * t[orders[slot][1]][i / (degree + 1)],
                    1e-11);
  }
}

TEST(LagrangeLineTest, ThirdDerivatives)
{
  for (unsigned int degree = 3; degree <= LagrangeLine::largest_degree; ++degree)
  {
    // of s^3, which the basis reproduces
    const LagrangeLine line(degree);
    double third = 0.;
    for (unsigned int i = 0; i <= degree; ++i)
      third += std::pow(line.points()[i], 3) * line.at(0.3)[3][i];
    EXPECT_NEAR(third, 6., 1e-10);
  }
}

TEST(LagrangeLineTest, LebesgueConstantsBoundWithoutWaste)
{
  for (unsigned int degree = 1; degree <= LagrangeLine::largest_degree; ++degree)
  {
    const LagrangeLine line(degree);
    double largest = 0.;
    for (unsigned int step = 0; step <= 1000; ++step)
    {
      double sum                        = 0.;
      const LagrangeLine::Values values = line.at(step / 1000.);
      for (const double value : values[0])
        sum += std::abs(value);
      largest = std::max(largest, sum);
    }
    EXPECT_LE(largest, line.lebesgue_constant() + 1e-14);
    EXPECT_GT(largest, line.lebesgue_constant() - 2e-4);
  }
}
} // namespace

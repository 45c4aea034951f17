// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

namespace pellicle
{
/**
 * The basis that cells are made of in each direction: Lagrange polynomials of degree k on the Gauss-Lobatto points of
 * [0, 1], as in ShapeTables, at any point and with derivatives up to the third.
 */
class LagrangeLine
{
public:
  static constexpr unsigned int largest_degree = 5;
  /** [derivative][i], i = 0 ... k. */
  using Values = std::array<std::array<double, largest_degree + 1>, 4>;

  explicit LagrangeLine(unsigned int degree);

  unsigned int degree() const { return nodes.size() - 1; }
  const std::vector<double> &points() const { return nodes; }
  Values at(double s) const;

  /** Largest sum of |N_i| on [0, 1]: how far, relative to its nodes, a curve can reach. A cell's is the square. */
  double lebesgue_constant() const;

private:
  std::vector<double> nodes;
  std::vector<std::vector<double>> coefficients; ///< [i]: of N_i in powers of s - 1/2
};
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/lagrange_line.h>

#include <deal.II/base/quadrature_lib.h>

namespace pellicle
{
LagrangeLine::LagrangeLine(const unsigned int degree)
{
  PELLICLE_ASSERT(degree >= 1 && degree <= largest_degree, "degrees of cells");
  const dealii::QGaussLobatto<1> gauss_lobatto(degree + 1);
  for (const dealii::Point<1> &point : gauss_lobatto.get_points())
    nodes.push_back(point[0]);
  for (unsigned int i = 0; i <= degree; ++i)
  {
    std::vector<double> polynomial{1.};
    for (unsigned int j = 0; j <= degree; ++j)
      if (j != i)
      {
        // times ((s - 1/2) - (s_j - 1/2))/(s_i - s_j)
        polynomial.push_back(0.);
        for (std::size_t power = polynomial.size(); power-- > 0;)
          polynomial[power] =
              ((power > 0 ? polynomial[power - 1] : 0.) - (nodes[j] - 0.5) * polynomial[power]) / (nodes[i] - nodes[j]);
      }
    coefficients.push_back(polynomial);
  }
}

LagrangeLine::Values LagrangeLine::at(const double s) const
{
  Values values{};
  const double t = s - 0.5;
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    double p0 = 0., p1 = 0., p2 = 0., p3 = 0.; // derivatives over their factorials, by Horner's rule
    for (std::size_t power = nodes.size(); power-- > 0;)
    {
      p3 = p3 * t + p2;
      p2 = p2 * t + p1;
      p1 = p1 * t + p0;
      p0 = p0 * t + coefficients[i][power];
    }
    values[0][i] = p0;
    values[1][i] = p1;
    values[2][i] = 2. * p2;
    values[3][i] = 6. * p3;
  }
  return values;
}

// Rounded up in the last digit from degree 4 on.
double LagrangeLine::lebesgue_constant() const
{
  static constexpr std::array<double, largest_degree + 1> of_degree{{1., 1., 1.25, 1.5, 1.6359, 1.7786}};
  return of_degree[degree()];
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "graded_line.h"

#include <boost/math/tools/toms748_solve.hpp>

#include <cmath>
#include <cstdint>

namespace pellicle
{
GradedLine::GradedLine(const double wanted_length, const double n, const double first, const double last)
    : length(wanted_length)
    , n_cells(n)
{
  // A geometric row whose first cell is s begins with the density 1/h = (e^q - 1)/(q s).
  const auto slope  = [](const double q, const double size) { return size > 0. ? std::expm1(q) / size : 0.; };
  const auto excess = [&](const double q)
  { return (std::log1p(slope(q, first) * length) + std::log1p(slope(q, last) * length)) / q - n_cells; };
  constexpr double lowest = 1e-8, highest = 50.;
  if (!(excess(lowest) > 0. && excess(highest) < 0.))
    return; // cells of equal size have the wanted one already
  std::uintmax_t iterations = 200;
  const auto bracket        = boost::math::tools::toms748_solve(
             excess, lowest, highest, [](const double a, const double b) { return std::abs(b - a) <= 4e-16 * b; }, iterations);
  rate        = 0.5 * (bracket.first + bracket.second);
  first_slope = slope(rate, first);
  last_slope  = slope(rate, last);
}

double GradedLine::at(const double t) const
{
  if (rate == 0. || t <= 0. || t >= n_cells)
    return length * (t / n_cells);
  // e^(q t) = (1 + a x)(1 + b L)/(1 + b (L - x)), solved for x.
  const double whole = 1. + last_slope * length;
  return whole * std::expm1(rate * t) / (first_slope * whole + std::exp(rate * t) * last_slope);
}

double GradedLine::growth() const
{
  return std::exp(rate);
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/models/error_estimate.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>

namespace pellicle
{
namespace
{
constexpr double least_share      = 0.1;  ///< of what was expected: no difference counts as smaller
constexpr double least_part       = 5e-4; ///< of a part: no sum of two parts counts as smaller
constexpr double largest_believed = 0.8;  ///< ratio of errors from level to level
constexpr double first_guess      = 0.5;  ///< of it

double ratio_of(const double after, const double before)
{
  return before > 0. ? std::min(after / before, largest_believed) : largest_believed;
}
} // namespace

double estimate_from(const RicherSpace &richer, const std::vector<double> &before)
{
  const double sum   = std::abs(richer.seen + richer.relaxed);
  const double parts = std::max(std::abs(richer.seen), std::abs(richer.relaxed));
  const double error = std::max(sum, least_part * parts);
  return error / (1. - (before.empty() ? first_guess : ratio_of(error, before.back())));
}

std::vector<double> estimates_of_sequence(const std::vector<double> &values)
{
  std::vector<double> estimates;
  double previous = 0., expected = 0.;
  for (std::size_t i = 1; i < values.size(); ++i)
  {
    const double difference = std::max(std::abs(values[i] - values[i - 1]), least_share * expected);
    const double ratio      = i == 1 ? first_guess : ratio_of(difference, previous);
    estimates.push_back(difference / (1. - ratio));
    expected = i == 1 ? 0. : ratio * difference; // one difference has no ratio
    previous = difference;
  }
  return estimates;
}

double expected_error(const std::vector<double> &estimates)
{
  const std::size_t n = estimates.size();
  if (n == 0)
    return 0.;
  double ratio = n == 1 ? 1. : 0.;
  for (std::size_t i = std::max<std::size_t>(n, 3) - 2; i < n; ++i)
    ratio = std::max(ratio, estimates[i - 1] > 0. ? std::min(1., estimates[i] / estimates[i - 1]) : 1.);
  return ratio * estimates.back();
}
} // namespace pellicle

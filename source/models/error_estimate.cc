// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/models/error_estimate.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pellicle
{
namespace
{
constexpr double least_share      = 0.1; ///< of a part, or of what was expected, that an estimate never falls below
constexpr double largest_believed = 0.5; ///< ratio of errors from level to level

double ratio_of(const double after, const double before)
{
  return before > 0. ? std::min(after / before, largest_believed) : largest_believed;
}
} // namespace

double estimate_from(const RicherSpace &richer, const std::vector<double> &before)
{
  const double sum   = std::abs(richer.seen + richer.relaxed);
  const double parts = std::max(std::abs(richer.seen), std::abs(richer.relaxed));
  const double error = std::max(sum, least_share * parts);
  return error / (1. - (before.empty() ? largest_believed : ratio_of(error, before.back())));
}

std::vector<double> estimates_of_sequence(const std::vector<double> &values)
{
  std::vector<double> estimates;
  double previous = 0., expected = 0.;
  for (std::size_t i = 1; i < values.size(); ++i)
  {
    const double difference = std::max(std::abs(values[i] - values[i - 1]), least_share * expected);
    const double ratio      = i == 1 ? largest_believed : ratio_of(difference, previous);
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

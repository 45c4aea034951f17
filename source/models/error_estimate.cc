// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/models/error_estimate.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace pellicle
{
namespace
{
constexpr double least_share      = 0.1;  ///< of what was expected: no difference counts as smaller
constexpr double least_part       = 5e-4; ///< of a part: no sum of two parts counts as smaller
constexpr double greatest_gain    = 400.; ///< from level to level: beyond it, two errors are equal by accident
constexpr double largest_believed = 0.8;  ///< ratio of errors from level to level
constexpr double first_guess      = 0.5;  ///< of it

double ratio_of(const double after, const double before)
{
  return before > 0. ? std::min(after / before, largest_believed) : largest_believed;
}
} // namespace

double estimate_from(const std::vector<RicherSpace> &levels)
{
  double estimate = 0.;
  for (std::size_t i = 0; i < levels.size(); ++i)
  {
    const double sum   = std::abs(levels[i].seen + levels[i].relaxed);
    const double part  = std::max(std::abs(levels[i].seen), std::abs(levels[i].relaxed));
    const double error = std::max({sum, least_part * part, estimate / greatest_gain});
    estimate           = error / (1. - (i == 0 ? first_guess : ratio_of(error, estimate)));
  }
  return estimate;
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
    return std::numeric_limits<double>::infinity();
  double ratio = n == 1 ? 1. : 0.;
  for (std::size_t i = std::max<std::size_t>(n, 3) - 2; i < n; ++i)
    ratio = std::max(ratio, estimates[i - 1] > 0. ? std::min(1., estimates[i] / estimates[i - 1]) : 1.);
  return ratio * estimates.back();
}
} // namespace pellicle

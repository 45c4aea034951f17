// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/kinematics/find_kink.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace pellicle
{
namespace
{
/** An interval shorter than this is not halved any more: places within it differ by some digits of round-off only. */
constexpr double least_width = 1e-11;
/** Part of a difference between two samples that must be left for a jump. */
constexpr double least_rest = 0.01;
/** Differences below this part of the function's size are round-off of the derivatives. */
constexpr double least_jump = 1e-8;

/** The gradient (order 1) or the second derivatives (order 2). */
std::array<double, 4> derivatives(const PlaceSample &H, const unsigned int order)
{
  if (order == 1)
    return {H.dx, H.dy, 0., 0.};
  return {H.dxx, H.dxy, H.dxy, H.dyy};
}

double difference(const PlaceSample &a, const PlaceSample &b, const unsigned int order)
{
  const auto of_a = derivatives(a, order), of_b = derivatives(b, order);
  double sum = 0.;
  for (unsigned int i = 0; i < 4; ++i)
    sum += (of_a[i] - of_b[i]) * (of_a[i] - of_b[i]);
  return std::sqrt(sum);
}

bool is_finite(const PlaceSample &H)
{
  return std::isfinite(H.value + H.dx + H.dy + H.dxx + H.dxy + H.dyy);
}

struct Sample
{
  double s = 0., x = 0., y = 0.;
  PlaceSample H;
};

class KinkSearch
{
public:
  KinkSearch(const FunctionOfPlace &H, const std::function<std::pair<double, double>(double)> &curve)
      : H(H)
      , curve(curve)
  {
  }

  std::optional<Kink> run(const unsigned int n_samples)
  {
    // Uneven ends, so that a kink on a line of symmetry is not just hit, where nothing but "not finite" could be said.
    std::vector<Sample> samples{sample(0.)};
    for (unsigned int i = 1; i < n_samples; ++i)
      samples.push_back(sample((i - 0.382) / n_samples));
    samples.push_back(sample(1.));
    for (const Sample &at : samples)
      if (!is_finite(at.H))
        return Kink{at.s, at.x, at.y};
    measure(samples);
    for (std::size_t i = 0; i + 1 < samples.size(); ++i)
      for (const unsigned int order : {1u, 2u})
        if (const auto kink = jump(samples[i], samples[i + 1], order))
          return kink;
    return {};
  }

private:
  Sample sample(const double s) const
  {
    const auto [x, y] = curve(s);
    return {s, x, y, H.at(x, y)};
  }

  /** Sizes of the curve and of H: the height over the extent squared, the slope over the extent and the second
   * derivatives are alike. */
  void measure(const std::vector<Sample> &samples)
  {
    for (const Sample &at : samples)
      extent = std::max(extent, std::hypot(at.x - samples[0].x, at.y - samples[0].y));
    if (extent == 0.)
      return;
    for (const Sample &at : samples)
    {
      const PlaceSample none;
      size = std::max(size,
                      (std::abs(at.H.value) / extent + difference(at.H, none, 1)) / extent + difference(at.H, none, 2));
    }
  }

  /** A jump of derivatives of an order between two samples. */
  std::optional<Kink> jump(Sample a, Sample b, const unsigned int order) const
  {
    const double noise = least_jump * size * (order == 1 ? extent : 1.);
    const double least = std::max(least_rest * difference(a.H, b.H, order), noise);
    while (difference(a.H, b.H, order) > least)
    {
      const Sample middle = sample(0.5 * (a.s + b.s));
      if (!is_finite(middle.H) || b.s - a.s < least_width)
        return Kink{middle.s, middle.x, middle.y};
      (difference(a.H, middle.H, order) > difference(middle.H, b.H, order) ? b : a) = middle;
    }
    return {};
  }

  const FunctionOfPlace &H;
  const std::function<std::pair<double, double>(double)> &curve;
  double extent = 0., size = 0.;
};
} // namespace

std::optional<Kink> find_kink(const FunctionOfPlace &H, const std::function<std::pair<double, double>(double s)> &curve,
                              const unsigned int n_samples)
{
  return KinkSearch(H, curve).run(n_samples);
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "polar_area.h"
#include "turned.h"

#include <pellicle/base/constants.h>
#include <pellicle/base/exact_text.h>
#include <pellicle/base/exceptions.h>

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <cmath>
#include <cstdint>
#include <vector>

namespace pellicle
{
namespace
{
constexpr unsigned int n_panels   = 16;
constexpr unsigned int n_azimuths = 128; ///< the trapezoidal rule converges exponentially in a periodic direction
using PanelRule                   = boost::math::quadrature::gauss<double, 15>;

/** Central difference of order 8; at this step, truncation and round-off of smooth shapes are both about 1e-14. */
template <typename Function>
Vector3<double> derivative(const Function &f)
{
  constexpr double step = 0.01;
  constexpr std::array<double, 4> weights{{4. / 5., -1. / 5., 4. / 105., -1. / 280.}};
  Vector3<double> sum;
  for (unsigned int i = 0; i < 4; ++i)
    sum += weights[i] / step * (f(step * (i + 1.)) - f(-step * (i + 1.)));
  return sum;
}

/** Area of the strip between polar angles a and b. */
double strip_area(const SmoothShape &shape, const double a, const double b)
{
  const auto along = [&](const double polar, const double azimuth)
  { return derivative([&](const double d) { return shape.point(sphere_point(polar + d, azimuth)); }); };
  if (shape.axisymmetric)
    return PanelRule::integrate([&](const double polar)
                                { return 2. * pi * shape.point(sphere_point(polar, 0.))[0] * norm(along(polar, 0.)); },
                                a, b);

  const auto ring = [&](const double polar)
  {
    double sum = 0.;
    for (unsigned int i = 0; i < n_azimuths; ++i)
    {
      const double azimuth = 2. * i / n_azimuths;
      const Vector3<double> around =
          derivative([&](const double d) { return shape.point(sphere_point(polar, azimuth + d / pi)); });
      sum += 2. * pi / n_azimuths * norm(cross(along(polar, azimuth), around));
    }
    return sum;
  };
  return PanelRule::integrate(ring, a, b);
}
} // namespace

Vector3<double> sphere_point(const double polar, const double azimuth_over_pi)
{
  return turned(std::sin(polar), azimuth_over_pi, std::cos(polar));
}

double polar_angle_of_area(const SmoothShape &shape, const double fraction)
{
  if (!(fraction > 0. && fraction < 1.))
    throw UserError("Region fraction = " + exact_text(fraction) +
                    ": the part of the area that the region around the north pole has must lie strictly between 0 and "
                    "1.");
  const double wanted = fraction * shape.area;
  double before       = 0.; // area of the panels that lie within
  for (unsigned int p = 0; p < n_panels; ++p)
  {
    const double a = pi * p / n_panels, b = pi * (p + 1) / n_panels, panel = strip_area(shape, a, b);
    if (before + panel < wanted && p + 1 < n_panels)
    {
      before += panel;
      continue;
    }
    const double missing      = wanted - before;
    std::uintmax_t iterations = 100;
    const auto bracket        = boost::math::tools::toms748_solve(
        [&](const double polar) { return strip_area(shape, a, polar) - missing; }, a, b, -missing, panel - missing,
        [](const double x, const double y) { return std::abs(x - y) < 1e-15; }, iterations);
    return 0.5 * (bracket.first + bracket.second);
  }
  return pi;
}
} // namespace pellicle

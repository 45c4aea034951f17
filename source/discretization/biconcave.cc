// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/constants.h>
#include <pellicle/discretization/smooth_shape.h>

#include <boost/math/quadrature/gauss.hpp>

namespace pellicle
{
namespace
{
// Coefficients of the outline in powers of sin^2 p; radius of the rim 1.
constexpr double c0 = 0.1242, c1 = 0.8012, c2 = -0.4492;
} // namespace

SmoothShape biconcave()
{
  const auto height = [](const double sine_squared) { return c0 + sine_squared * (c1 + sine_squared * c2); };
  const auto slope  = [](const double sine_squared) { return c1 + 2. * sine_squared * c2; };

  SmoothShape shape;
  // (r, z) = (sin p, height cos p) with r^2 = x^2 + y^2 = sin^2 p and u_z = cos p.
  shape.point = [height](const Vector3<double> &u)
  { return Vector3<double>(u[0], u[1], height(u[0] * u[0] + u[1] * u[1]) * u[2]); };

  // Upper half, twice.
  using Gauss     = boost::math::quadrature::gauss<double, 60>;
  const auto ring = [&](const double p)
  {
    const double s = std::sin(p), c = std::cos(p);
    const double dz = -s * height(s * s) + 2. * s * c * c * slope(s * s);
    return s * std::sqrt(c * c + dz * dz);
  };
  const auto column = [&](const double p) { // r z dr
    const double s = std::sin(p), c = std::cos(p);
    return s * height(s * s) * c * c;
  };
  shape.area   = 4. * pi * Gauss::integrate(ring, 0., pi / 2.);
  shape.volume = 4. * pi * Gauss::integrate(column, 0., pi / 2.);
  return shape;
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/constants.h>
#include <pellicle/base/exact_text.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/smooth_shape.h>

#include <boost/math/special_functions/ellint_rg.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pellicle
{
namespace
{
SmoothShape stretched_sphere(const std::array<double, 3> &axes, const double area)
{
  SmoothShape shape;
  shape.point = [axes](const Vector3<double> &u)
  { return Vector3<double>(axes[0] * u[0], axes[1] * u[1], axes[2] * u[2]); };
  shape.area         = area;
  shape.volume       = 4. / 3. * pi * axes[0] * axes[1] * axes[2];
  shape.axisymmetric = (axes[0] == axes[1]);
  return shape;
}

/** Area of the spheroid with semi axes 1, 1, e^t, from its closed forms. */
double spheroid_area(const double t)
{
  // Eccentricity squared, without cancellation near the sphere: 1 - e^(-2 |t|).
  const double e = std::sqrt(-std::expm1(-2. * std::abs(t)));
  if (e < 1e-8)
    return 4. * pi * std::exp(2. * t / 3.);
  if (t > 0.)
    return 2. * pi * (1. + std::exp(t) * std::asin(e) / e);
  // 1 - e^2 = e^(2 t); atanh(e) = log((1 + e)/sqrt(1 - e^2)) keeps its digits when the spheroid is flat.
  return 2. * pi * (1. + std::exp(2. * t) * (std::log1p(e) - t) / e);
}

/**
 * Spheroid with semi axes 1, 1, c = e^t. A prolate one is not simply a stretched sphere, which crowds nodes a little
 * too much at its tips: polar angles are mapped by tan(tau) = c^q tan(theta) first, so that the spacing of nodes along
 * a meridian goes from c^q at the tips to c^(1 - q) at the equator.
 */
SmoothShape spheroid(const double t)
{
  constexpr double q = 0.04; // measured on the prolate of v = 0.65: the energy errors of Q3 and Q4 on 96 cells are
                             // smallest between 0 and 0.06
  SmoothShape shape = stretched_sphere({{1., 1., std::exp(t)}}, spheroid_area(t));
  if (t > 0.)
    shape.point = [stretched = shape.point, g = std::exp(q * t)](const Vector3<double> &u)
    {
      const Vector3<double> v(g * u[0], g * u[1], u[2]);
      return stretched(v / norm(v));
    };
  else
    shape.even_mesh = SmoothShape::EvenMesh::sphere;
  return shape;
}

/** Solves for the logarithm t of the aspect ratio; v falls from 1 at t = 0 to 0 at either end. */
SmoothShape spheroid_of_reduced_volume(const double v, const double sign, const std::string &name)
{
  if (v == 1.)
    throw UserError(
        "Reduced volume = 1 is a sphere, whose area and volume cannot be prescribed independently (their gradients are "
        "parallel). Take a value below 1, for example 0.99.");
  if (!(v > 0. && v < 1.))
    throw UserError(
        "Reduced volume = " + exact_text(v) + " is not possible for the start shape '" + name +
        "': it must lie strictly between 0 and 1 (1 is the sphere, which encloses the most volume for its area).");
  const auto excess = [&](const double t) { return spheroid(sign * t).reduced_volume() - v; };

  double far = 1.;
  while (excess(far) > 0.)
    far *= 2.;
  std::uintmax_t iterations = 200;
  const auto bracket        = boost::math::tools::toms748_solve(
             excess, 0., far, 1. - v, excess(far),
             [](const double a, const double b) { return std::abs(b - a) <= 4e-16 * std::abs(b); }, iterations);
  // Of the two ends of the bracket, the one that fits better.
  const bool first = std::abs(excess(bracket.first)) < std::abs(excess(bracket.second));
  return spheroid(sign * (first ? bracket.first : bracket.second));
}
} // namespace

SmoothShape ellipsoid(const std::array<double, 3> &semi_axes)
{
  for (const double axis : semi_axes)
    if (!(axis > 0. && axis < std::numeric_limits<double>::infinity()))
      throw UserError("Semi axes = " + exact_text(semi_axes[0]) + ", " + exact_text(semi_axes[1]) + ", " +
                      exact_text(semi_axes[2]) + ": each of the three must be a number > 0.");
  // Of the longest axis, so that no power of an axis overflows.
  const double longest = *std::max_element(semi_axes.begin(), semi_axes.end());
  std::array<double, 3> axes;
  for (unsigned int c = 0; c < 3; ++c)
    axes[c] = semi_axes[c] / longest;
  const double a = axes[0] * axes[0], b = axes[1] * axes[1], c = axes[2] * axes[2];
  const double area = 4. * pi * boost::math::ellint_rg(a * b, a * c, b * c);
  return scaled_to_area(stretched_sphere(axes, area), area * longest * longest);
}

SmoothShape prolate_spheroid(const double reduced_volume)
{
  return spheroid_of_reduced_volume(reduced_volume, 1., "prolate");
}

SmoothShape oblate_spheroid(const double reduced_volume)
{
  return spheroid_of_reduced_volume(reduced_volume, -1., "oblate");
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>

namespace pellicle
{
/**
 * Energies U(J) of a change of volume, by way of a pressure p (BodyPressure): each is
 *
 *     U(J) = maximum over p of f(p) - p h(J),        p = -dU/dh,
 *
 * with f concave, f(p) -> p or 0 as the modulus goes to infinity, so that p becomes the multiplier of J = 1. For small
 * strains U = (J - 1)^2/(2 compliance).
 */

/** U = (K/2) (J - 1)^2, h = J, f = p - p^2/(2 K), p the Cauchy pressure. Compliance 0: J = 1 in the mean of each cell,
 * whatever the material. */
struct LinearVolumeLaw
{
  double compliance = 0.; ///< 1/K

  template <typename Number>
  Number measure(const Number &J) const
  {
    return J;
  }
  template <typename Number>
  Number dual(const Number &p) const
  {
    return p - 0.5 * compliance * p * p;
  }
};

/** U = (lambda/2) (ln J)^2, h = ln J, f = -p^2/(2 lambda), p = -lambda ln J the Kirchhoff pressure (J times the
 * Cauchy pressure). */
struct LogarithmicVolumeLaw
{
  double compliance = 0.; ///< 1/lambda

  template <typename Number>
  Number measure(const Number &J) const
  {
    using std::log;
    return log(J);
  }
  template <typename Number>
  Number dual(const Number &p) const
  {
    return -0.5 * compliance * p * p;
  }
};

/** U = (lambda/4) (J^2 - 1 - 2 ln J), h = J, p = (lambda/2) (1/J - J) the Cauchy pressure. With s = p/lambda
 * stationary at J = sqrt(1 + s^2) - s, hence f = (lambda/2) (s sqrt(1 + s^2) - s^2 + asinh s), df/dp = J. */
struct QuadraticVolumeLaw
{
  double compliance = 1.; ///< 1/lambda > 0

  template <typename Number>
  Number measure(const Number &J) const
  {
    return J;
  }
  template <typename Number>
  Number dual(const Number &p) const
  {
    using std::asinh;
    using std::sqrt;
    const Number s = compliance * p, root = sqrt(1. + s * s);
    return (0.5 / compliance) * (s * root - s * s + asinh(s));
  }
};
} // namespace pellicle

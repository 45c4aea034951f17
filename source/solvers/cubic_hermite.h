// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace pellicle::internal
{
/** A value and its slope at one place. */
struct Knot
{
  double at, value, slope;
};

/** The cubic with given values and slopes at two places. */
class CubicHermite
{
public:
  CubicHermite(const Knot &left, const Knot &right)
      : left(left)
      , right(right)
  {
  }

  double value(const double s) const
  {
    const double h = right.at - left.at, u = (s - left.at) / h, v = 1. - u;
    return v * v * ((1. + 2. * u) * left.value + u * h * left.slope) +
           u * u * ((1. + 2. * v) * right.value - v * h * right.slope);
  }
  double slope(const double s) const
  {
    const double h = right.at - left.at, u = (s - left.at) / h, v = 1. - u;
    return 6. * u * v * (right.value - left.value) / h + v * (v - 2. * u) * left.slope + u * (u - 2. * v) * right.slope;
  }

  /** A place between the knots where the value is c, which must lie between their values. */
  double place_of_value(const double c) const
  {
    return zero([&](const double s) { return value(s) - c; });
  }
  /** A place between the knots where the slope is zero; their slopes must differ in sign. */
  double place_of_extremum() const
  {
    return zero([&](const double s) { return slope(s); });
  }

private:
  /** Bisection: it costs nothing here and cannot fail. */
  template <typename Function>
  double zero(const Function &f) const
  {
    double a = left.at, b = right.at;
    const bool rises = f(b) > f(a);
    for (int i = 0; i < 60; ++i)
    {
      const double middle                 = 0.5 * (a + b);
      ((f(middle) > 0.) == rises ? b : a) = middle;
    }
    return 0.5 * (a + b);
  }

  Knot left, right;
};
} // namespace pellicle::internal

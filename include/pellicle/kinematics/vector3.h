// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cmath>

namespace pellicle
{
/**
 * Three Cartesian components of any number type, automatic differentiation types included. Plain on purpose: operators
 * that return values, no expression templates, so that nested number types never dangle.
 */
template <typename Number>
struct Vector3
{
  std::array<Number, 3> components{};

  Vector3() = default;
  Vector3(const Number &x, const Number &y, const Number &z)
      : components{{x, y, z}}
  {
  }

  Number &operator[](const unsigned int i) { return components[i]; }
  const Number &operator[](const unsigned int i) const { return components[i]; }

  Vector3 &operator+=(const Vector3 &b)
  {
    for (unsigned int i = 0; i < 3; ++i)
      components[i] += b[i];
    return *this;
  }
  Vector3 &operator-=(const Vector3 &b)
  {
    for (unsigned int i = 0; i < 3; ++i)
      components[i] -= b[i];
    return *this;
  }
  friend Vector3 operator+(Vector3 a, const Vector3 &b) { return a += b; }
  friend Vector3 operator-(Vector3 a, const Vector3 &b) { return a -= b; }
  friend Vector3 operator-(const Vector3 &a) { return Vector3(Number(-a[0]), Number(-a[1]), Number(-a[2])); }
  friend Vector3 operator*(const Number &s, const Vector3 &a)
  {
    return Vector3(Number(s * a[0]), Number(s * a[1]), Number(s * a[2]));
  }
  friend Vector3 operator/(const Vector3 &a, const Number &s)
  {
    return Vector3(Number(a[0] / s), Number(a[1] / s), Number(a[2] / s));
  }
};

template <typename Number>
Number dot(const Vector3<Number> &a, const Vector3<Number> &b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <typename Number>
Vector3<Number> cross(const Vector3<Number> &a, const Vector3<Number> &b)
{
  return Vector3<Number>(Number(a[1] * b[2] - a[2] * b[1]), Number(a[2] * b[0] - a[0] * b[2]),
                         Number(a[0] * b[1] - a[1] * b[0]));
}

template <typename Number>
Number norm(const Vector3<Number> &a)
{
  using std::sqrt;
  return sqrt(dot(a, a));
}

/** a/|a|, or `otherwise` where |a| is too small (1e-10) for a direction; for numbers of order one. */
inline Vector3<double> unit_or(const Vector3<double> &a, const Vector3<double> &otherwise)
{
  constexpr double smallest = 1e-10;
  const double length       = norm(a);
  return length < smallest ? otherwise : (1. / length) * a;
}
} // namespace pellicle

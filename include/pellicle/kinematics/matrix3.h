// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/kinematics/vector3.h>

#include <array>

namespace pellicle
{
/** A 3 x 3 block, row-major. Arithmetic of hand-written second derivatives. */
struct Matrix3
{
  std::array<double, 9> entries{};

  double &operator()(const unsigned int i, const unsigned int j) { return entries[3 * i + j]; }
  double operator()(const unsigned int i, const unsigned int j) const { return entries[3 * i + j]; }

  friend Matrix3 operator+(Matrix3 a, const Matrix3 &b)
  {
    for (unsigned int k = 0; k < 9; ++k)
      a.entries[k] += b.entries[k];
    return a;
  }
  friend Matrix3 operator-(Matrix3 a, const Matrix3 &b)
  {
    for (unsigned int k = 0; k < 9; ++k)
      a.entries[k] -= b.entries[k];
    return a;
  }
  friend Matrix3 operator*(const double s, Matrix3 a)
  {
    for (double &entry : a.entries)
      entry *= s;
    return a;
  }
};

/** s I. */
inline Matrix3 identity3(const double s)
{
  return {{{s, 0., 0., 0., s, 0., 0., 0., s}}};
}

/** a b^T. */
inline Matrix3 outer(const Vector3<double> &a, const Vector3<double> &b)
{
  Matrix3 m;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      m(i, j) = a[i] * b[j];
  return m;
}

/** [a]x, the matrix of b -> a x b. */
inline Matrix3 cross_matrix(const Vector3<double> &a)
{
  return {{{0., -a[2], a[1], a[2], 0., -a[0], -a[1], a[0], 0.}}};
}

/** m^T. */
inline Matrix3 transposed(const Matrix3 &m)
{
  return {{{m(0, 0), m(1, 0), m(2, 0), m(0, 1), m(1, 1), m(2, 1), m(0, 2), m(1, 2), m(2, 2)}}};
}

/** m n. */
inline Matrix3 operator*(const Matrix3 &m, const Matrix3 &n)
{
  Matrix3 result;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      result(i, j) = m(i, 0) * n(0, j) + m(i, 1) * n(1, j) + m(i, 2) * n(2, j);
  return result;
}

/** m b. */
inline Vector3<double> operator*(const Matrix3 &m, const Vector3<double> &b)
{
  return {m(0, 0) * b[0] + m(0, 1) * b[1] + m(0, 2) * b[2], m(1, 0) * b[0] + m(1, 1) * b[1] + m(1, 2) * b[2],
          m(2, 0) * b[0] + m(2, 1) * b[1] + m(2, 2) * b[2]};
}
} // namespace pellicle

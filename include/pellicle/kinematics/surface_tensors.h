// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>

namespace pellicle
{
/**
 * Symmetric pair of surface indices, such as a_ab or b_ab. Index 0 of the code is index 1 of the formulas, 1 is 2.
 * Whether the indices are up or down is the business of who names the variable.
 */
template <typename Number>
struct SymmetricSurfaceTensor
{
  std::array<Number, 3> components{}; ///< 11, 12, 22

  SymmetricSurfaceTensor() = default;
  SymmetricSurfaceTensor(const Number &c11, const Number &c12, const Number &c22)
      : components{{c11, c12, c22}}
  {
  }

  Number &operator()(const unsigned int a, const unsigned int b) { return components[a + b]; }
  const Number &operator()(const unsigned int a, const unsigned int b) const { return components[a + b]; }
};

/** Determinant s_11 s_22 - s_12^2. */
template <typename Number>
Number determinant(const SymmetricSurfaceTensor<Number> &s)
{
  return s(0, 0) * s(1, 1) - s(0, 1) * s(0, 1);
}

/** Full contraction s^ab t_ab, the mixed component counted twice. */
template <typename Number>
Number contract(const SymmetricSurfaceTensor<Number> &s, const SymmetricSurfaceTensor<Number> &t)
{
  return s(0, 0) * t(0, 0) + 2. * s(0, 1) * t(0, 1) + s(1, 1) * t(1, 1);
}

/** Both indices moved with the (inverse) metric m: m^ag s_gd m^db. */
template <typename Number>
SymmetricSurfaceTensor<Number> move_indices(const SymmetricSurfaceTensor<Number> &m,
                                            const SymmetricSurfaceTensor<Number> &s)
{
  SymmetricSurfaceTensor<Number> result;
  for (unsigned int a = 0; a < 2; ++a)
  {
    const Number row_0 = m(a, 0) * s(0, 0) + m(a, 1) * s(1, 0);
    const Number row_1 = m(a, 0) * s(0, 1) + m(a, 1) * s(1, 1);
    for (unsigned int b = a; b < 2; ++b)
      result(a, b) = row_0 * m(0, b) + row_1 * m(1, b);
  }
  return result;
}
} // namespace pellicle

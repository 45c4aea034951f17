// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/point_inputs.h>
#include <pellicle/potentials/shell/shell_reference.h>

#include <array>

namespace pellicle
{
/** Components 11 22 33 23 13 12 of a symmetric tensor in Cartesian coordinates; of strains the last three are doubled,
 * of stresses they are not: the product of both is the sum over the six. */
template <typename Number>
using Symmetric6 = std::array<Number, 6>;

/**
 * Strains of a Cosserat shell of Rubin type (paper 003, "Displacement, deformation, curvature, strain"): with d_a = x,a
 * and the extensible director d_3,
 *
 *     F = d_i (x) D^i,   E = (F^T F - 1)/2,   beta_a = F^-1 d_3,a - D_3,a,   Ebar = E + sym(beta_a (x) H^a).
 *
 * Rigid motions x -> Q x + c, d_3 -> Q d_3 change none of them.
 */
template <typename Number>
struct ShellStrains
{
  Symmetric6<Number> strain;             ///< Ebar, doubled off the diagonal
  std::array<Vector3<Number>, 2> couple; ///< beta_1 beta_2

  ShellStrains(const FieldAtPoint<Number> &x, const FieldAtPoint<Number> &d, const ShellReference &D,
               const std::array<Vector3<double>, 2> &H);
};

/** Row and column of the six components. */
constexpr std::array<std::array<unsigned int, 2>, 6> symmetric_index{
    {{{0, 0}}, {{1, 1}}, {{2, 2}}, {{1, 2}}, {{0, 2}}, {{0, 1}}}};

namespace internal
{
template <typename Number>
Number times(const Vector3<double> &a, const Vector3<Number> &b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
} // namespace internal

template <typename Number>
ShellStrains<Number>::ShellStrains(const FieldAtPoint<Number> &x, const FieldAtPoint<Number> &d,
                                   const ShellReference &D, const std::array<Vector3<double>, 2> &H)
{
  const std::array<Vector3<Number>, 3> base{{x.d1(), x.d2(), d.value()}};
  const Number volume = dot(base[0], cross(base[1], base[2]));
  const std::array<Vector3<Number>, 3> dual{
      {cross(base[1], base[2]) / volume, cross(base[2], base[0]) / volume, cross(base[0], base[1]) / volume}};
  // beta_a = D_k (d^k . d_3,a) - D_3,a
  const std::array<const Vector3<Number> *, 2> director_d{{&d.d1(), &d.d2()}};
  for (unsigned int a = 0; a < 2; ++a)
    for (unsigned int c = 0; c < 3; ++c)
      couple[a][c] = -D.director_d[a][c];
  for (unsigned int k = 0; k < 3; ++k)
    for (unsigned int a = 0; a < 2; ++a)
    {
      const Number part = dot(dual[k], *director_d[a]);
      for (unsigned int c = 0; c < 3; ++c)
        couple[a][c] += D.base[k][c] * part;
    }
  // E = (d_i . d_j - D_i . D_j) D^i (x) D^j/2
  for (unsigned int s = 0; s < 6; ++s)
  {
    const auto [p, q] = symmetric_index[s];
    strain[s]         = Number(0.);
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j <= i; ++j)
      {
        const double factor = D.dual[i][p] * D.dual[j][q] + D.dual[j][p] * D.dual[i][q];
        const Number change = dot(base[i], base[j]) - dot(D.base[i], D.base[j]);
        strain[s] += ((i == j ? 0.25 : 0.5) * (p == q ? 1. : 2.) * factor) * change;
      }
    for (unsigned int a = 0; a < 2; ++a)
    {
      if (p == q)
        strain[s] += H[a][p] * couple[a][p];
      else
        strain[s] += H[a][q] * couple[a][p] + H[a][p] * couple[a][q];
    }
  }
}
} // namespace pellicle

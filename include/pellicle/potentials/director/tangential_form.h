// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/surface_measures.h>

#include <array>

namespace pellicle
{
/**
 * A quadratic form of n vectors v_i on a surface that weighs their tangential and normal parts differently, per unit of
 * parametric area:
 *
 *     f = J (1/2) sum_ij alpha_ij v_i . v_j - (1/J) (1/2) sum_ij beta_ij t_i t_j,    t_i = (x,1 x x,2) . v_i = J n .
 * v_i.
 *
 * With beta = alpha it is the form of the tangential parts (I - n n) v_i alone. alpha and beta are symmetric.
 */
template <unsigned int n>
struct TangentialForm
{
  std::array<std::array<double, n>, n> alpha{}, beta{};

  /** f; `vectors` may be of any number type. */
  template <typename Number>
  Number density(const FieldAtPoint<Number> &x, const std::array<Vector3<Number>, n> &vectors) const
  {
    const Vector3<Number> N = cross(x.d1(), x.d2());
    const Number J          = norm(N);
    Number whole(0.), normal(0.);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
      {
        whole += 0.5 * alpha[i][j] * dot(vectors[i], vectors[j]);
        normal += 0.5 * beta[i][j] * dot(N, vectors[i]) * dot(N, vectors[j]);
      }
    return J * whole - normal / J;
  }

  /** Derivatives of f; the position is field 0 of the density, v_i the value of field 1 + i. */
  void add_derivatives(const FieldAtPoint<double> &x, const std::array<Vector3<double>, n> &vectors,
                       const PointDerivativeView &view) const;
};

extern template struct TangentialForm<1>;
extern template struct TangentialForm<2>;
} // namespace pellicle

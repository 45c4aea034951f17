// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/kinematics/matrix3.h>
#include <pellicle/kinematics/vector3.h>

#include <array>

namespace pellicle
{
/**
 * Derivatives of E = J_ref W(F), F = x,a (x) G^a, with respect to the reference X, given those with respect to x at the
 * same X. E is per unit of parametric volume (n = 3, W per volume of the reference) or area (n = 2, G^a the tangential
 * dual vectors). With p_a = dE/dx,a, that is J_ref P G^a of the first Piola-Kirchhoff stress P, H_ab = d2E/(dx,a dx,b)
 * and e_a = F^T p_a:
 *
 *     dE/dX,a          = E G^a - e_a
 *     d2E/(dx,a dX,b)  = p_a (x) G^b - p_b (x) G^a - H_ab F
 *     d2E/(dX,a dX,b)  = E (G^a (x) G^b - G^b (x) G^a) - e_a (x) G^b - G^a (x) e_b + e_b (x) G^a + G^b (x) e_a
 *                        + F^T H_ab F.
 *
 * The first is J_ref G^a times Eshelby's energy-momentum tensor W 1 - F^T P: dE = integral of (W 1 - F^T P) : Grad dX
 * dV, the force that drives material points. On a surface the last gains (E G^ab - e_a . G^b) N (x) N, N the normal of
 * the reference.
 */
template <unsigned int n>
class EshelbyDerivatives
{
public:
  EshelbyDerivatives(const double energy, const std::array<Vector3<double>, n> &dual,
                     const std::array<Vector3<double>, n> &x_a, const std::array<Vector3<double>, n> &dE_dx_a)
      : E(energy)
      , G(dual)
      , p(dE_dx_a)
  {
    for (unsigned int a = 0; a < n; ++a)
      F = F + outer(x_a[a], G[a]);
    F_transposed = transposed(F);
    for (unsigned int a = 0; a < n; ++a)
      e[a] = F_transposed * p[a];
    if constexpr (n == 2)
    {
      const Vector3<double> N = cross(G[0], G[1]);
      normal_square           = (1. / dot(N, N)) * outer(N, N);
    }
  }

  Vector3<double> gradient(const unsigned int a) const { return E * G[a] - e[a]; }

  /** H_ab F, for the two below. */
  Matrix3 along_material(const Matrix3 &H_ab) const { return H_ab * F; }

  /** d2E/(dx,a dX,b): rows x,a, columns X,b. */
  Matrix3 mixed(const unsigned int a, const unsigned int b, const Matrix3 &H_ab_F) const
  {
    Matrix3 block = -1. * H_ab_F;
    if (a != b)
      block = block + outer(p[a], G[b]) - outer(p[b], G[a]);
    return block;
  }

  /** d2E/(dX,a dX,b). */
  Matrix3 second(const unsigned int a, const unsigned int b, const Matrix3 &H_ab_F) const
  {
    Matrix3 block = F_transposed * H_ab_F;
    if (a != b) // what is left of the other terms: antisymmetric in a and b
    {
      const Vector3<double> left = 0.5 * E * G[a] - e[a], right = 0.5 * E * G[b] - e[b];
      block = block + outer(left, G[b]) + outer(G[a], right) - outer(right, G[a]) - outer(G[b], left);
    }
    if constexpr (n == 2)
      block = block + (E * dot(G[a], G[b]) - dot(e[a], G[b])) * normal_square;
    return block;
  }

  /** With a further input q of the density: rows X,a, columns q, from dE/dq and d2E/(dx,a dq). */
  Matrix3 with_further(const unsigned int a, const Vector3<double> &E_q, const Matrix3 &E_xq) const
  {
    return outer(G[a], E_q) - F_transposed * E_xq;
  }

private:
  double E;
  std::array<Vector3<double>, n> G, p, e;
  Matrix3 F, F_transposed, normal_square;
};
} // namespace pellicle

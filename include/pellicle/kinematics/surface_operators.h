// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/kinematics/surface_point.h>

/** Differential operators along a surface, from parametric derivatives. Vectors v need not be tangential. */
namespace pellicle
{
/** grad_s f = a^a f,a: a tangential vector. */
template <typename Number>
Vector3<Number> surface_gradient(const TangentPlane<Number> &p, const Number &f_1, const Number &f_2)
{
  return f_1 * p.dual[0] + f_2 * p.dual[1];
}

/** grad_s v = v,a (x) a^a, component [i][j] = v_i,a a^a_j: row i is the surface gradient of v_i. */
template <typename Number>
std::array<Vector3<Number>, 3> surface_gradient(const TangentPlane<Number> &p, const FirstDerivatives<Number> &v)
{
  std::array<Vector3<Number>, 3> rows;
  for (unsigned int i = 0; i < 3; ++i)
    rows[i] = surface_gradient(p, v[0][i], v[1][i]);
  return rows;
}

/** div_s v = a^a . v,a; of the normal div_s n = -2H, of the position 2. */
template <typename Number>
Number surface_divergence(const TangentPlane<Number> &p, const FirstDerivatives<Number> &v)
{
  return dot(p.dual[0], v[0]) + dot(p.dual[1], v[1]);
}

/** grad_s v : grad_s w = a^ab v,a . w,b. */
template <typename Number>
Number gradient_product(const TangentPlane<Number> &p, const FirstDerivatives<Number> &v,
                        const FirstDerivatives<Number> &w)
{
  return p.inverse_metric(0, 0) * dot(v[0], w[0]) + p.inverse_metric(0, 1) * (dot(v[0], w[1]) + dot(v[1], w[0])) +
         p.inverse_metric(1, 1) * dot(v[1], w[1]);
}

/** Lap_s v = a^ab (v,ab - Gamma^g_ab v,g), component by component; of the position 2 H n. */
template <typename Number>
Vector3<Number> surface_laplacian(const SurfacePoint<Number> &p, const FirstDerivatives<Number> &v,
                                  const SecondDerivatives<Number> &v_second)
{
  const auto &up = p.inverse_metric;
  return up(0, 0) * v_second(0, 0) + Number(2. * up(0, 1)) * v_second(0, 1) + up(1, 1) * v_second(1, 1) -
         contract(up, p.christoffel[0]) * v[0] - contract(up, p.christoffel[1]) * v[1];
}

/** (I - n n) v */
template <typename Number>
Vector3<Number> tangential_part(const TangentPlane<Number> &p, const Vector3<Number> &v)
{
  return v - dot(p.normal, v) * p.normal;
}

/** The projector I - n n itself, by rows. */
template <typename Number>
std::array<Vector3<Number>, 3> tangential_projector(const TangentPlane<Number> &p)
{
  const Number one(1.), zero(0.);
  std::array<Vector3<Number>, 3> rows{
      {Vector3<Number>(one, zero, zero), Vector3<Number>(zero, one, zero), Vector3<Number>(zero, zero, one)}};
  for (unsigned int i = 0; i < 3; ++i)
    rows[i] = tangential_part(p, rows[i]);
  return rows;
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/kinematics/surface_point.h>

/**
 * First and second variations of surface geometry: w = delta x is one increment of the position, u a second one, and
 * only their parametric derivatives w_a = w,a and w,ab enter. The second variation D2 f[w, u] is the derivative of
 * delta f[w] in the direction u with w fixed, symmetric in w and u. Notation as in surface_point.h. For the formulas
 * see R. A. Sauer, A contact theory for surface tension driven systems (2014), section 2 and eq. (112), and with the
 * velocity in place of w, D. Hu, P. Zhang, W. E, Continuum theory of a moving membrane (2007), section II.
 */
namespace pellicle
{
/** delta a_ab = a_a . w_b + a_b . w_a */
template <typename Number>
SymmetricSurfaceTensor<Number> variation_of_metric(const TangentPlane<Number> &p, const FirstDerivatives<Number> &w)
{
  return SymmetricSurfaceTensor<Number>(Number(2. * dot(p.base[0], w[0])),
                                        Number(dot(p.base[0], w[1]) + dot(p.base[1], w[0])),
                                        Number(2. * dot(p.base[1], w[1])));
}

/** delta a^ab = -a^ag a^bd delta a_gd, for any delta a_gd */
template <typename Number>
SymmetricSurfaceTensor<Number> variation_of_inverse_metric(const TangentPlane<Number> &p,
                                                           const SymmetricSurfaceTensor<Number> &metric_variation)
{
  SymmetricSurfaceTensor<Number> result = move_indices(p.inverse_metric, metric_variation);
  for (Number &component : result.components)
    component = -component;
  return result;
}

/** delta J = J a^a . w_a */
template <typename Number>
Number variation_of_jacobian(const TangentPlane<Number> &p, const FirstDerivatives<Number> &w)
{
  return p.jacobian * (dot(p.dual[0], w[0]) + dot(p.dual[1], w[1]));
}

/** delta (a_1 x a_2) = w_1 x a_2 + a_1 x w_2, the variation of n dA */
template <typename Number>
Vector3<Number> variation_of_area_vector(const TangentPlane<Number> &p, const FirstDerivatives<Number> &w)
{
  return cross(w[0], p.base[1]) + cross(p.base[0], w[1]);
}

/** delta n = -(n . w_a) a^a */
template <typename Number>
Vector3<Number> variation_of_normal(const TangentPlane<Number> &p, const FirstDerivatives<Number> &w)
{
  return -(dot(p.normal, w[0]) * p.dual[0] + dot(p.normal, w[1]) * p.dual[1]);
}

/** delta a^a = -(a^a . w_b) a^b + a^ab (n . w_b) n */
template <typename Number>
FirstDerivatives<Number> variation_of_dual(const TangentPlane<Number> &p, const FirstDerivatives<Number> &w)
{
  FirstDerivatives<Number> result;
  for (unsigned int a = 0; a < 2; ++a)
  {
    const Number along_normal =
        p.inverse_metric(a, 0) * dot(p.normal, w[0]) + p.inverse_metric(a, 1) * dot(p.normal, w[1]);
    result[a] = along_normal * p.normal - dot(p.dual[a], w[0]) * p.dual[0] - dot(p.dual[a], w[1]) * p.dual[1];
  }
  return result;
}

/** delta b_ab = n . (w,ab - Gamma^g_ab w_g) */
template <typename Number>
SymmetricSurfaceTensor<Number> variation_of_curvature(const SurfacePoint<Number> &p, const FirstDerivatives<Number> &w,
                                                      const SecondDerivatives<Number> &w_second)
{
  const Number n_w_1 = dot(p.normal, w[0]), n_w_2 = dot(p.normal, w[1]);
  SymmetricSurfaceTensor<Number> result;
  for (unsigned int i = 0; i < 3; ++i)
    result.components[i] = dot(p.normal, w_second.components[i]) - p.christoffel[0].components[i] * n_w_1 -
                           p.christoffel[1].components[i] * n_w_2;
  return result;
}

/** delta H = (b_ab delta a^ab + a^ab delta b_ab) / 2, from delta a_ab and delta b_ab */
template <typename Number>
Number variation_of_mean_curvature(const SurfacePoint<Number> &p,
                                   const SymmetricSurfaceTensor<Number> &metric_variation,
                                   const SymmetricSurfaceTensor<Number> &curvature_variation)
{
  return 0.5 * (contract(p.inverse_metric, curvature_variation) -
                contract(move_indices(p.inverse_metric, p.curvature), metric_variation));
}

/** delta K = (b_11 delta b_22 + b_22 delta b_11 - 2 b_12 delta b_12)/J^2 - K a^ab delta a_ab, from delta a_ab and delta
 * b_ab */
template <typename Number>
Number variation_of_gauss_curvature(const SurfacePoint<Number> &p,
                                    const SymmetricSurfaceTensor<Number> &metric_variation,
                                    const SymmetricSurfaceTensor<Number> &curvature_variation)
{
  const SymmetricSurfaceTensor<Number> &b = p.curvature, &db = curvature_variation;
  const Number det_variation = b(0, 0) * db(1, 1) + b(1, 1) * db(0, 0) - 2. * b(0, 1) * db(0, 1);
  return det_variation / (p.jacobian * p.jacobian) - p.gauss_curvature * contract(p.inverse_metric, metric_variation);
}

/** D2 a_ab[w, u] = w_a . u_b + u_a . w_b */
template <typename Number>
SymmetricSurfaceTensor<Number> second_variation_of_metric(const FirstDerivatives<Number> &w,
                                                          const FirstDerivatives<Number> &u)
{
  return SymmetricSurfaceTensor<Number>(Number(2. * dot(w[0], u[0])), Number(dot(w[0], u[1]) + dot(u[0], w[1])),
                                        Number(2. * dot(w[1], u[1])));
}

/** D2 a^ab[w, u] = a^ag (delta_w a_gd a^de delta_u a_ez + delta_u a_gd a^de delta_w a_ez - D2 a_gz) a^zb */
template <typename Number>
SymmetricSurfaceTensor<Number> second_variation_of_inverse_metric(const TangentPlane<Number> &p,
                                                                  const FirstDerivatives<Number> &w,
                                                                  const FirstDerivatives<Number> &u)
{
  const SymmetricSurfaceTensor<Number> a_w = variation_of_metric(p, w), a_u = variation_of_metric(p, u);
  SymmetricSurfaceTensor<Number> inner = second_variation_of_metric(w, u);
  for (unsigned int a = 0; a < 2; ++a)
    for (unsigned int b = a; b < 2; ++b)
    {
      Number product(0.);
      for (unsigned int g = 0; g < 2; ++g)
        for (unsigned int d = 0; d < 2; ++d)
          product += p.inverse_metric(g, d) * (a_w(a, g) * a_u(d, b) + a_u(a, g) * a_w(d, b));
      inner(a, b) = product - inner(a, b);
    }
  return move_indices(p.inverse_metric, inner);
}

/** D2 J[w, u] = J ((a^a . w_a)(a^b . u_b) - (a^a . u_b)(a^b . w_a) + a^ab (n . w_a)(n . u_b)): the geometric tangent of
 * every tension */
template <typename Number>
Number second_variation_of_jacobian(const TangentPlane<Number> &p, const FirstDerivatives<Number> &w,
                                    const FirstDerivatives<Number> &u)
{
  Number sum(0.);
  for (unsigned int a = 0; a < 2; ++a)
    for (unsigned int b = 0; b < 2; ++b)
      sum += dot(p.dual[a], w[a]) * dot(p.dual[b], u[b]) - dot(p.dual[a], u[b]) * dot(p.dual[b], w[a]) +
             p.inverse_metric(a, b) * dot(p.normal, w[a]) * dot(p.normal, u[b]);
  return p.jacobian * sum;
}

/** D2 (a_1 x a_2)[w, u] = w_1 x u_2 + u_1 x w_2 */
template <typename Number>
Vector3<Number> second_variation_of_area_vector(const FirstDerivatives<Number> &w, const FirstDerivatives<Number> &u)
{
  return cross(w[0], u[1]) + cross(u[0], w[1]);
}

/** D2 n[w, u] = (n . u_b)(a^b . w_a) a^a + (n . w_a)(a^a . u_b) a^b - a^ab (n . w_a)(n . u_b) n */
template <typename Number>
Vector3<Number> second_variation_of_normal(const TangentPlane<Number> &p, const FirstDerivatives<Number> &w,
                                           const FirstDerivatives<Number> &u)
{
  Vector3<Number> sum{Number(0.), Number(0.), Number(0.)};
  for (unsigned int a = 0; a < 2; ++a)
    for (unsigned int b = 0; b < 2; ++b)
    {
      const Number n_w = dot(p.normal, w[a]), n_u = dot(p.normal, u[b]);
      sum += Number(n_u * dot(p.dual[b], w[a])) * p.dual[a] + Number(n_w * dot(p.dual[a], u[b])) * p.dual[b] -
             Number(p.inverse_metric(a, b) * n_w * n_u) * p.normal;
    }
  return sum;
}

/** D2 b_ab[w, u] = D2 n[w, u] . x,ab + delta_w n . u,ab + delta_u n . w,ab */
template <typename Number>
SymmetricSurfaceTensor<Number>
second_variation_of_curvature(const SurfacePoint<Number> &p, const FirstDerivatives<Number> &w,
                              const SecondDerivatives<Number> &w_second, const FirstDerivatives<Number> &u,
                              const SecondDerivatives<Number> &u_second)
{
  const Vector3<Number> n_wu = second_variation_of_normal(p, w, u);
  const Vector3<Number> n_w = variation_of_normal(p, w), n_u = variation_of_normal(p, u);
  SymmetricSurfaceTensor<Number> result;
  for (unsigned int i = 0; i < 3; ++i)
    result.components[i] =
        dot(n_wu, p.second.components[i]) + dot(n_w, u_second.components[i]) + dot(n_u, w_second.components[i]);
  return result;
}
} // namespace pellicle

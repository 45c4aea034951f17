// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/potential.h>

namespace pellicle
{
/**
 * Area J = |x,1 x x,2| and cone volume x . (x,1 x x,2)/3 per unit of parametric area, with hand-written derivatives.
 * Shared by the energies (tension, pressure) and the constraints (area, volume) made of them.
 *
 * | code        | symbol                                      |
 * |-------------|---------------------------------------------|
 * | normal      | n = x,1 x x,2 / J                            |
 * | dual[a]     | a^a, dual base vectors                       |
 * | dJ[a]       | dJ/dx,a = J a^a = (x,2 x n, n x x,1)         |
 */
struct AreaDerivatives
{
  double J = 0.;
  Vector3<double> normal;
  Vector3<double> dJ[2];
  double inverse_metric[3] = {0., 0., 0.}; ///< a^11, a^12, a^22

  AreaDerivatives(const Vector3<double> &x1, const Vector3<double> &x2)
  {
    const Vector3<double> N = cross(x1, x2);
    J                       = norm(N);
    normal                  = (1. / J) * N;
    dJ[0]                   = cross(x2, normal);
    dJ[1]                   = cross(normal, x1);
    const double s          = 1. / (J * J);
    inverse_metric[0]       = s * dot(x2, x2);
    inverse_metric[1]       = -s * dot(x1, x2);
    inverse_metric[2]       = s * dot(x1, x1);
  }

  /** d2J/(dx,a dx,b) = J (a^a (x) a^b - a^b (x) a^a + a^ab n (x) n), a and b in {0, 1}: (112) of Sauer 2014, D2 J of
   * the conventions. */
  Matrix3 d2J(const unsigned int a, const unsigned int b) const
  {
    Matrix3 block = (J * inverse_metric[a + b]) * outer(normal, normal);
    if (a != b)
      block = block + (1. / J) * (outer(dJ[a], dJ[b]) - outer(dJ[b], dJ[a]));
    return block;
  }
};

template <typename Number>
Number area_density(const FieldAtPoint<Number> &x)
{
  return norm(cross(x.d1(), x.d2()));
}

template <typename Number>
Number volume_density(const FieldAtPoint<Number> &x)
{
  return dot(x.value(), cross(x.d1(), x.d2())) / 3.;
}

/** Adds `factor` times the derivatives of J; `field` is the position's index in the density's own order. */
inline void add_area_derivatives(const FieldAtPoint<double> &x, const unsigned int field, const double factor,
                                 const PointDerivativeView &view)
{
  const AreaDerivatives area(x.d1(), x.d2());
  for (unsigned int a = 0; a < 2; ++a)
    view.add_gradient(field, 1 + a, factor * area.dJ[a]);
  if (view.wants_hessian())
    for (unsigned int a = 0; a < 2; ++a)
      for (unsigned int b = a; b < 2; ++b)
        view.add_hessian(field, 1 + a, field, 1 + b, factor * area.d2J(a, b));
}

/** Adds `factor` times the derivatives of x . (x,1 x x,2)/3. */
inline void add_volume_derivatives(const FieldAtPoint<double> &x, const unsigned int field, const double factor,
                                   const PointDerivativeView &view)
{
  const double third = factor / 3.;
  view.add_gradient(field, 0, third * cross(x.d1(), x.d2()));
  view.add_gradient(field, 1, third * cross(x.d2(), x.value()));
  view.add_gradient(field, 2, third * cross(x.value(), x.d1()));
  if (view.wants_hessian())
  {
    view.add_hessian(field, 0, field, 1, -third * cross_matrix(x.d2()));
    view.add_hessian(field, 0, field, 2, third * cross_matrix(x.d1()));
    view.add_hessian(field, 1, field, 2, -third * cross_matrix(x.value()));
  }
}
} // namespace pellicle

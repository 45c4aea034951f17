// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/reference_metric.h>
#include <pellicle/potentials/surface_measures.h>

namespace pellicle
{
/**
 * The metric a_ab = x,a . x,b measured by a reference metric A_ab. With the principal stretches l1, l2 of the map from
 * the reference to the surface
 *
 *     T = A^ab a_ab = l1^2 + l2^2,    s = J/J_ref = l1 l2,    T >= 2 s.
 *
 * Every isotropic energy of in-plane deformation is a function W(T, s) per reference area, that is J_ref W per unit of
 * parametric area. T = 2 and s = 1 at the reference.
 */
template <typename Number>
struct StretchInvariants
{
  Number T, s;

  template <typename Reference>
  StretchInvariants(const FieldAtPoint<Number> &x, const BasicReferenceMetric<Reference> &A)
  {
    const Reference r = 1. / A.area_element();
    T = (r * r) * (A.A22 * dot(x.d1(), x.d1()) - 2. * A.A12 * dot(x.d1(), x.d2()) + A.A11 * dot(x.d2(), x.d2()));
    s = r * area_density(x);
  }
};

/** First and second derivatives of W(T, s): dW/dT is T, d2W/(dT ds) is Ts. */
struct InvariantDerivatives
{
  double T = 0., s = 0., TT = 0., Ts = 0., ss = 0.;
};

/**
 * Adds the derivatives of J_ref W(T, s), given those of W: the chain rule shared by the elastic skins and the mesh
 * energy.
 *
 * | code   | symbol                                                    |
 * |--------|-----------------------------------------------------------|
 * | T_x[a] | dT/dx,a = 2 A^ab x,b                                      |
 * | s_x[a] | ds/dx,a = (J/J_ref) a^a                                   |
 * | T_xx   | d2T/(dx,a dx,b) = 2 A^ab I, at position a + b             |
 */
class StretchDerivatives
{
public:
  double T = 0., s = 0.; ///< the invariants themselves

  StretchDerivatives(const FieldAtPoint<double> &x, const ReferenceMetric &A)
      : area(x.d1(), x.d2())
      , J0(A.area_element())
  {
    const double r = 1. / J0;
    T_xx[0]        = (2. * r * r) * A.A22;
    T_xx[1]        = (-2. * r * r) * A.A12;
    T_xx[2]        = (2. * r * r) * A.A11;
    for (unsigned int a = 0; a < 2; ++a)
    {
      T_x[a] = T_xx[a] * x.d1() + T_xx[a + 1] * x.d2();
      s_x[a] = r * area.dJ[a];
    }
    T = 0.5 * (dot(T_x[0], x.d1()) + dot(T_x[1], x.d2()));
    s = r * area.J;
  }

  /** `field` is the position's index in the density's own order. */
  void add(const InvariantDerivatives &W, const unsigned int field, const PointDerivativeView &view) const
  {
    for (unsigned int a = 0; a < 2; ++a)
      view.add_gradient(field, 1 + a, (J0 * W.T) * T_x[a] + (J0 * W.s) * s_x[a]);
    if (!view.wants_hessian())
      return;
    for (unsigned int b = 0; b < 2; ++b)
    {
      const Vector3<double> W_T_x = (J0 * W.TT) * T_x[b] + (J0 * W.Ts) * s_x[b]; // J_ref d(dW/dT)/dx,b
      const Vector3<double> W_s_x = (J0 * W.Ts) * T_x[b] + (J0 * W.ss) * s_x[b];
      for (unsigned int a = 0; a <= b; ++a)
        view.add_hessian(field, 1 + a, field, 1 + b,
                         identity3(J0 * W.T * T_xx[a + b]) + W.s * area.d2J(a, b) + outer(T_x[a], W_T_x) +
                             outer(s_x[a], W_s_x));
    }
  }

private:
  AreaDerivatives area;
  double J0;
  double T_xx[3];
  Vector3<double> T_x[2], s_x[2];
};
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/potentials/director/director_gradient.h>
#include <pellicle/potentials/surface_measures.h>

namespace pellicle
{
// f = (K/2) S/J with S quadratic in x,a and in O,b: every block is one product rule.
void DirectorGradientEnergy::add_derivatives(const PointInputs<double, 2> &inputs, const PointData & /*data*/,
                                             const PointDerivativeView &view) const
{
  constexpr unsigned int position = 0, directors = 1;
  const Vector3<double> &x1 = inputs[position].d1(), &x2 = inputs[position].d2();
  const Vector3<double> &O1 = inputs[directors].d1(), &O2 = inputs[directors].d2();
  const AreaDerivatives area(x1, x2);
  const double a11 = dot(x1, x1), a12 = dot(x1, x2), a22 = dot(x2, x2);
  const double o11 = dot(O1, O1), o12 = dot(O1, O2), o22 = dot(O2, O2);

  // Derivatives of S/2, times K/J; f_J is that of f with respect to J at fixed S.
  const double factor          = modulus / area.J;
  const double S_half          = 0.5 * (a22 * o11 + a11 * o22) - a12 * o12;
  const double f_J             = -factor * S_half / area.J;
  const Vector3<double> S_x[2] = {o22 * x1 - o12 * x2, o11 * x2 - o12 * x1};
  const Vector3<double> S_O[2] = {a22 * O1 - a12 * O2, a11 * O2 - a12 * O1};
  for (unsigned int a = 0; a < 2; ++a)
  {
    view.add_gradient(position, 1 + a, factor * S_x[a] + f_J * area.dJ[a]);
    view.add_gradient(directors, 1 + a, factor * S_O[a]);
  }
  if (!view.wants_hessian())
    return;

  const double S_xx[3] = {o22, -o12, o11}, S_OO[3] = {a22, -a12, a11}; // times I
  const double factor_J = -factor / area.J;
  for (unsigned int a = 0; a < 2; ++a)
    for (unsigned int b = a; b < 2; ++b)
    {
      view.add_hessian(position, 1 + a, position, 1 + b,
                       identity3(factor * S_xx[a + b]) +
                           factor_J * (outer(S_x[a], area.dJ[b]) + outer(area.dJ[a], S_x[b])) -
                           (2. * f_J / area.J) * outer(area.dJ[a], area.dJ[b]) + f_J * area.d2J(a, b));
      view.add_hessian(directors, 1 + a, directors, 1 + b, identity3(factor * S_OO[a + b]));
    }
  const Matrix3 S_xO[2][2] = {{-1. * outer(x2, O2), 2. * outer(x1, O2) - outer(x2, O1)},
                              {2. * outer(x2, O1) - outer(x1, O2), -1. * outer(x1, O1)}};
  for (unsigned int a = 0; a < 2; ++a)
    for (unsigned int b = 0; b < 2; ++b)
      view.add_hessian(position, 1 + a, directors, 1 + b, factor * S_xO[a][b] + factor_J * outer(area.dJ[a], S_O[b]));
}
} // namespace pellicle

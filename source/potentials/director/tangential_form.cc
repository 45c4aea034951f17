// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/potentials/director/tangential_form.h>

namespace pellicle
{
// With f = J A(v) - B(t)/J, t_i = N . v_i and N = x,1 x x,2:
//
// | code        | symbol                                                       |
// |-------------|--------------------------------------------------------------|
// | A_v[i]      | dA/dv_i = sum_j alpha_ij v_j                                 |
// | tau[i]      | dB/dt_i = sum_j beta_ij t_j                                  |
// | t_x(a, v)   | d(N . v)/dx,a = x,2 x v (a = 1), v x x,1 (a = 2), linear in v |
// | B_x[a]      | dB/dx,a = t_x(a, sum_i tau_i v_i)                            |
template <unsigned int n>
void TangentialForm<n>::add_derivatives(const FieldAtPoint<double> &x, const std::array<Vector3<double>, n> &vectors,
                                        const PointDerivativeView &view) const
{
  constexpr unsigned int position = 0;
  const Vector3<double> &x1 = x.d1(), &x2 = x.d2();
  const AreaDerivatives area(x1, x2);
  const double J          = area.J;
  const Vector3<double> N = J * area.normal;
  const auto t_x = [&](const unsigned int a, const Vector3<double> &v) { return a == 0 ? cross(x2, v) : cross(v, x1); };

  double A = 0., B = 0.;
  std::array<Vector3<double>, n> A_v, beta_v;
  std::array<double, n> tau;
  Vector3<double> w; // sum_i tau_i v_i
  for (unsigned int i = 0; i < n; ++i)
  {
    for (unsigned int j = 0; j < n; ++j)
    {
      A_v[i] += alpha[i][j] * vectors[j];
      beta_v[i] += beta[i][j] * vectors[j];
    }
    tau[i] = dot(N, beta_v[i]);
    A += 0.5 * dot(A_v[i], vectors[i]);
    B += 0.5 * tau[i] * dot(N, vectors[i]);
    w += tau[i] * vectors[i];
  }
  const Vector3<double> B_x[2] = {t_x(0, w), t_x(1, w)};
  const double f_J             = A + B / (J * J); // df/dJ at fixed A and B

  for (unsigned int a = 0; a < 2; ++a)
    view.add_gradient(position, 1 + a, f_J * area.dJ[a] - (1. / J) * B_x[a]);
  for (unsigned int i = 0; i < n; ++i)
    view.add_gradient(1 + i, 0, J * A_v[i] - (tau[i] / J) * N);
  if (!view.wants_hessian())
    return;

  const double inverse_square = 1. / (J * J), f_JJ = -2. * B / (J * J * J);
  for (unsigned int a = 0; a < 2; ++a)
    for (unsigned int b = a; b < 2; ++b)
    {
      Matrix3 B_xx = a == b ? Matrix3() : -1. * cross_matrix(w);
      for (unsigned int i = 0; i < n; ++i)
        B_xx = B_xx + outer(t_x(a, vectors[i]), t_x(b, beta_v[i]));
      view.add_hessian(position, 1 + a, position, 1 + b,
                       f_J * area.d2J(a, b) + f_JJ * outer(area.dJ[a], area.dJ[b]) +
                           inverse_square * (outer(area.dJ[a], B_x[b]) + outer(B_x[a], area.dJ[b])) - (1. / J) * B_xx);
    }
  for (unsigned int i = 0; i < n; ++i)
  {
    for (unsigned int a = 0; a < 2; ++a)
      view.add_hessian(
          position, 1 + a, 1 + i, 0,
          outer(area.dJ[a], A_v[i] + (tau[i] * inverse_square) * N) -
              (1. / J) * (outer(t_x(a, beta_v[i]), N) + (a == 0 ? tau[i] : -tau[i]) * cross_matrix(a == 0 ? x2 : x1)));
    for (unsigned int j = i; j < n; ++j)
      view.add_hessian(1 + i, 0, 1 + j, 0, identity3(J * alpha[i][j]) - (beta[i][j] / J) * outer(N, N));
  }
}

template struct TangentialForm<1>;
template struct TangentialForm<2>;
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/potentials/shell/shell_strain_derivatives.h>

namespace pellicle
{
namespace
{
/** sym(a (x) b), doubled off the diagonal. */
Symmetric6<double> symmetric_product(const Vector3<double> &a, const Vector3<double> &b)
{
  return {{a[0] * b[0], a[1] * b[1], a[2] * b[2], a[1] * b[2] + a[2] * b[1], a[0] * b[2] + a[2] * b[0],
           a[0] * b[1] + a[1] * b[0]}};
}

/** The tensor of six stresses applied to b. */
Vector3<double> apply(const double *S, const Vector3<double> &b)
{
  return {S[0] * b[0] + S[5] * b[1] + S[4] * b[2], S[5] * b[0] + S[1] * b[1] + S[3] * b[2],
          S[4] * b[0] + S[3] * b[1] + S[2] * b[2]};
}
} // namespace

ShellStrainDerivatives::ShellStrainDerivatives(const FieldAtPoint<double> &x, const FieldAtPoint<double> &d,
                                               const ShellReference &reference,
                                               const std::array<Vector3<double>, 2> &moments)
    : strains(x, d, reference, moments)
    , D(reference)
    , H(moments)
    , rows{}
{
  const std::array<Vector3<double>, 3> base{{x.d1(), x.d2(), d.value()}};
  const double volume = dot(base[0], cross(base[1], base[2]));
  for (unsigned int i = 0; i < 3; ++i)
    dual[i] = cross(base[(i + 1) % 3], base[(i + 2) % 3]) / volume;
  for (unsigned int a = 0; a < 2; ++a)
    for (unsigned int i = 0; i < 3; ++i)
      weight[a][i] = dot(D.dual[i], strains.couple[a] + D.director_d[a]);
  for (unsigned int c = 0; c < 3; ++c)
  {
    Vector3<double> F_transposed, F_inverse; // F^T e_c, F^-1 e_c
    for (unsigned int j = 0; j < 3; ++j)
    {
      F_transposed += base[j][c] * D.dual[j];
      F_inverse += dual[j][c] * D.base[j];
    }
    const auto add_couple = [&](const unsigned int column, const unsigned int a, const double factor)
    {
      for (unsigned int k = 0; k < 3; ++k)
        rows[6 + 3 * a + k][column] += factor * F_inverse[k];
      const Symmetric6<double> strain = symmetric_product(factor * F_inverse, H[a]);
      for (unsigned int s = 0; s < 6; ++s)
        rows[s][column] += strain[s];
    };
    for (unsigned int i = 0; i < 3; ++i)
    {
      const Symmetric6<double> strain = symmetric_product(F_transposed, D.dual[i]);
      for (unsigned int s = 0; s < 6; ++s)
        rows[s][3 * i + c] += strain[s];
      for (unsigned int a = 0; a < 2; ++a)
        add_couple(3 * i + c, a, -weight[a][i]);
    }
    for (unsigned int a = 0; a < 2; ++a)
      add_couple(9 + 3 * a + c, a, 1.);
  }
}

std::array<Symmetric6<double>, 3> ShellStrainDerivatives::of_strain(const unsigned int k) const
{
  std::array<Symmetric6<double>, 3> result;
  for (unsigned int c = 0; c < 3; ++c)
    for (unsigned int s = 0; s < 6; ++s)
      result[c][s] = rows[s][3 * k + c];
  return result;
}

void ShellStrainDerivatives::add(const Gradient &gradient, const Hessian &hessian,
                                 const PointDerivativeView &view) const
{
  for (unsigned int k = 0; k < n_vectors; ++k)
  {
    Vector3<double> g;
    for (unsigned int c = 0; c < 3; ++c)
      for (unsigned int s = 0; s < n_strains; ++s)
        g[c] += gradient[s] * rows[s][3 * k + c];
    view.add_gradient(input[k][0], input[k][1], g);
  }
  if (!view.wants_hessian())
    return;
  std::array<std::array<double, 15>, n_strains> stresses{}; // hessian . rows
  for (unsigned int s = 0; s < n_strains; ++s)
    for (unsigned int t = 0; t < n_strains; ++t)
      if (hessian[s][t] != 0.)
        for (unsigned int i = 0; i < 15; ++i)
          stresses[s][i] += hessian[s][t] * rows[t][i];
  for (unsigned int k = 0; k < n_vectors; ++k)
    for (unsigned int l = k; l < n_vectors; ++l)
    {
      Matrix3 block;
      for (unsigned int s = 0; s < n_strains; ++s)
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            block(i, j) += rows[s][3 * k + i] * stresses[s][3 * l + j];
      view.add_hessian(input[k][0], input[k][1], input[l][0], input[l][1], block);
    }
  add_second_variation(gradient, view);
}

void ShellStrainDerivatives::add_second_variation(const Gradient &gradient, const PointDerivativeView &view) const
{
  std::array<Vector3<double>, 2> q; // F^-T p^a, where p^a includes the part of Ebar
  for (unsigned int a = 0; a < 2; ++a)
  {
    const double *const direct = gradient.data() + 6 + 3 * a;
    const Vector3<double> p    = Vector3<double>(direct[0], direct[1], direct[2]) + apply(gradient.data(), H[a]);
    for (unsigned int k = 0; k < 3; ++k)
      q[a] += dot(p, D.base[k]) * dual[k];
  }
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = i; j < 3; ++j)
    {
      Matrix3 block = identity3(dot(D.dual[i], apply(gradient.data(), D.dual[j])));
      for (unsigned int a = 0; a < 2; ++a)
        block = block + weight[a][i] * outer(dual[j], q[a]) + weight[a][j] * outer(q[a], dual[i]);
      view.add_hessian(input[i][0], input[i][1], input[j][0], input[j][1], block);
    }
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int a = 0; a < 2; ++a)
      view.add_hessian(input[i][0], input[i][1], input[3 + a][0], input[3 + a][1], -1. * outer(q[a], dual[i]));
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/potential.h>
#include <pellicle/potentials/shell/shell_strains.h>

#include <array>

namespace pellicle
{
/**
 * First derivatives of the twelve strains of a shell (Ebar, then beta_1 and beta_2) with respect to the fifteen numbers
 * x,1 x,2 d_3 d_3,1 d_3,2, and what an energy of the strains adds to gradient and Hessian by them. With gamma_a = F^-1
 * d_3,a and c^i_a = D^i . gamma_a,
 *
 *     delta E = sym(F^T delta d_i (x) D^i),   delta beta_a = F^-1 (delta d_3,a - c^i_a delta d_i);
 *
 * the second variation of p^a . beta_a, with q^a = F^-T p^a and the present dual basis d^i, is
 *
 *     -(q^a . Delta d_i) d^i . (delta d_3,a - c^j_a delta d_j) - the same with Delta and delta exchanged.
 *
 * It takes about a thirtieth of the time of automatic derivatives over all inputs.
 */
class ShellStrainDerivatives
{
public:
  static constexpr unsigned int n_strains = 12;
  using Gradient                          = std::array<double, n_strains>;
  using Hessian                           = std::array<std::array<double, n_strains>, n_strains>;

  /** x and d: position and director with their first derivatives. */
  ShellStrainDerivatives(const FieldAtPoint<double> &x, const FieldAtPoint<double> &d, const ShellReference &reference,
                         const std::array<Vector3<double>, 2> &moments);

  /** Adds what an energy with these derivatives by the strains has by the fields; the position is the first field of
   * the view, the director the second. */
  void add(const Gradient &gradient, const Hessian &hessian, const PointDerivativeView &view) const;

  /** Derivatives of Ebar by vector k of x,1 x,2 d_3 d_3,1 d_3,2: [component of the vector][component of Ebar]. */
  std::array<Symmetric6<double>, 3> of_strain(unsigned int k) const;

  static constexpr unsigned int n_vectors = 5;
  /** Field and slot of vector k. */
  static constexpr std::array<std::array<unsigned int, 2>, n_vectors> input{
      {{{0, 1}}, {{0, 2}}, {{1, 0}}, {{1, 1}}, {{1, 2}}}};

  const ShellStrains<double> strains;

private:
  void add_second_variation(const Gradient &gradient, const PointDerivativeView &view) const;

  const ShellReference &D;
  const std::array<Vector3<double>, 2> &H;
  std::array<Vector3<double>, 3> dual;                ///< d^1 d^2 d^3
  std::array<std::array<double, 3>, 2> weight;        ///< c^i_a
  std::array<std::array<double, 15>, n_strains> rows; ///< of each strain
};
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/director/unit_director.h>
#include <pellicle/potentials/potential.h>

#include <array>

namespace pellicle
{
/**
 * Collects derivatives of a density of x (field 0) and of d = O/|O| (field 1), each with first derivatives, and adds
 * them as derivatives with respect to x and O. With A and B_a symmetric,
 *
 *     delta d = A delta O,                       A   = (I - d d)/|O|,
 *     delta d,a = A delta O,a + B_a delta O,     B_a = -(d,a d + d d,a + (d . O,a) A)/|O|.
 *
 * The density may be continued off the unit vectors as one likes.
 */
class UnitDirectorDerivatives
{
public:
  UnitDirectorDerivatives(const FieldAtPoint<double> &O, bool wants_hessian);

  /** d with its derivatives, as a field. */
  const FieldAtPoint<double> &unit_field() const { return d; }
  /** Where to add derivatives with respect to x and d. */
  PointDerivativeView collect(double factor);
  /** Adds what was collected to a view of x and O. */
  void add_to(const PointDerivativeView &view) const;

private:
  static constexpr unsigned int n = 18; ///< x and d in three slots of three components
  static constexpr std::array<unsigned int, 2> offsets{{0, 9}};

  void add_hessian_to(const PointDerivativeView &view) const;
  Vector3<double> gradient_of(unsigned int block) const;
  Matrix3 hessian_of(unsigned int block, unsigned int other) const;
  /** Second derivatives of sum_k g_k . y_k(O, O,1, O,2) for the collected gradient g with respect to y = (d, d,1, d,2).
   */
  std::array<double, 81> curvature_of_map() const;
  /** Block of the derivative of (d, d,1, d,2) with respect to (O, O,1, O,2); null where it vanishes. */
  const Matrix3 *map_block(unsigned int row, unsigned int column) const;

  FieldAtPoint<double> O, d;
  Matrix3 A;
  std::array<Matrix3, 2> B;
  std::array<double, n> gradient{};
  std::vector<double> hessian; ///< n x n; empty if not wanted
};
} // namespace pellicle

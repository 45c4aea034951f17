// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/kinematics/automatic_differentiation.h>
#include <pellicle/potentials/director/unit_director_derivatives.h>

namespace pellicle
{
UnitDirectorDerivatives::UnitDirectorDerivatives(const FieldAtPoint<double> &O, const bool wants_hessian)
    : O(O)
    , hessian(wants_hessian ? n * n : 0, 0.)
{
  const UnitDirector<double> unit(O);
  d.slots                     = {unit.d, unit.derivatives[0], unit.derivatives[1]};
  const double inverse_length = 1. / norm(O.value());
  A                           = inverse_length * (identity3(1.) - outer(unit.d, unit.d));
  for (unsigned int a = 0; a < 2; ++a)
    B[a] = -inverse_length *
           (outer(unit.derivatives[a], unit.d) + outer(unit.d, unit.derivatives[a]) + dot(unit.d, O.slots[1 + a]) * A);
}

PointDerivativeView UnitDirectorDerivatives::collect(const double factor)
{
  return {gradient.data(), hessian.empty() ? nullptr : hessian.data(), n, offsets.data(), factor};
}

// Blocks 0 to 2 belong to x, 3 to 5 to d, in the order of slots.
Vector3<double> UnitDirectorDerivatives::gradient_of(const unsigned int block) const
{
  return {gradient[3 * block], gradient[3 * block + 1], gradient[3 * block + 2]};
}

Matrix3 UnitDirectorDerivatives::hessian_of(const unsigned int block, const unsigned int other) const
{
  Matrix3 m;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      m(i, j) = hessian[(3 * block + i) * n + 3 * other + j];
  return m;
}

const Matrix3 *UnitDirectorDerivatives::map_block(const unsigned int row, const unsigned int column) const
{
  if (row == column)
    return &A;
  return column == 0 ? &B[row - 1] : nullptr;
}

void UnitDirectorDerivatives::add_to(const PointDerivativeView &view) const
{
  constexpr unsigned int position = 0, directors = 1;
  for (unsigned int slot = 0; slot < 3; ++slot)
    view.add_gradient(position, slot, gradient_of(slot));
  view.add_gradient(directors, 0, A * gradient_of(3) + B[0] * gradient_of(4) + B[1] * gradient_of(5));
  view.add_gradient(directors, 1, A * gradient_of(4));
  view.add_gradient(directors, 2, A * gradient_of(5));
  if (view.wants_hessian())
    add_hessian_to(view);
}

void UnitDirectorDerivatives::add_hessian_to(const PointDerivativeView &view) const
{
  constexpr unsigned int position = 0, directors = 1;
  // H T, blocks of x and of d against those of O.
  std::array<std::array<Matrix3, 3>, 6> product{};
  for (unsigned int block = 0; block < 6; ++block)
    for (unsigned int column = 0; column < 3; ++column)
      for (unsigned int row = 0; row < 3; ++row)
        if (const Matrix3 *const T = map_block(row, column))
          product[block][column] = product[block][column] + hessian_of(block, 3 + row) * *T;

  for (unsigned int slot = 0; slot < 3; ++slot)
  {
    for (unsigned int other = slot; other < 3; ++other)
      view.add_hessian(position, slot, position, other, hessian_of(slot, other));
    for (unsigned int other = 0; other < 3; ++other)
      view.add_hessian(position, slot, directors, other, product[slot][other]);
  }
  const std::array<double, 81> curvature = curvature_of_map();
  for (unsigned int slot = 0; slot < 3; ++slot)
    for (unsigned int other = slot; other < 3; ++other)
    {
      Matrix3 block;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          block(i, j) = curvature[(3 * slot + i) * 9 + 3 * other + j];
      for (unsigned int row = 0; row < 3; ++row)
        if (const Matrix3 *const T = map_block(row, slot))
          block = block + *T * product[3 + row][other];
      view.add_hessian(directors, slot, directors, other, block);
    }
}

std::array<double, 81> UnitDirectorDerivatives::curvature_of_map() const
{
  using Number = SecondOrder<9>;
  FieldAtPoint<Number> seeded;
  for (unsigned int slot = 0; slot < 3; ++slot)
    for (unsigned int c = 0; c < 3; ++c)
      seeded.slots[slot][c] = seed<Number>(3 * slot + c, O.slots[slot][c]);
  const UnitDirector<Number> unit(seeded);
  Number sum(0.);
  for (unsigned int c = 0; c < 3; ++c)
    sum += gradient[9 + c] * unit.d[c] + gradient[12 + c] * unit.derivatives[0][c] +
           gradient[15 + c] * unit.derivatives[1][c];
  return pellicle::hessian_of(sum);
}
} // namespace pellicle

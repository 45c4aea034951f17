// SPDX-License-Identifier: LGPL-2.1-or-later
#include "shifted_pencil.h"

#include <pellicle/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pellicle::internal
{
namespace
{
/** Calls action(row, column, value) for each entry of the matrix, those above the diagonal included. */
template <typename Action>
void for_each_entry(const SparseMatrix &matrix, const Action &action)
{
  for (int i = 0; i < matrix.size; ++i)
    for (int k = matrix.row_start[i]; k < matrix.row_start[i + 1]; ++k)
    {
      action(i, matrix.columns[k], matrix.values[k]);
      if (matrix.columns[k] != i)
        action(matrix.columns[k], i, matrix.values[k]);
    }
}
} // namespace

ShiftedPencil::ShiftedPencil(const SparseMatrix &K_, const SparseMatrix &M_)
    : K(K_)
    , M(M_)
{
  PELLICLE_ASSERT(K.size == M.size, "matrices of different size");
  PELLICLE_ASSERT(K.symmetry == MatrixSymmetry::symmetric && M.symmetry == MatrixSymmetry::symmetric,
                  "eigenvalues of matrices that are not symmetric");
  const bool subtracts_mass = communicator.rank() == 0;
  shifted.size              = K.size;
  shifted.row_start.push_back(0);
  for (int i = 0; i < K.size; ++i)
  {
    // Merges two ascending rows.
    int k = K.row_start[i], m = subtracts_mass ? M.row_start[i] : 0;
    const int k_end = K.row_start[i + 1], m_end = subtracts_mass ? M.row_start[i + 1] : 0;
    while (k < k_end || m < m_end)
    {
      constexpr int none = std::numeric_limits<int>::max();
      const int from_K = k < k_end ? K.columns[k] : none, from_M = m < m_end ? M.columns[m] : none;
      shifted.columns.push_back(std::min(from_K, from_M));
      stiffness.push_back(from_K <= from_M ? K.values[k++] : 0.);
      mass.push_back(from_M <= from_K ? M.values[m++] : 0.);
    }
    shifted.row_start.push_back(int(shifted.columns.size()));
  }
  shifted.values.resize(shifted.columns.size());
}

const SparseMatrix &ShiftedPencil::at(const double shift)
{
  for (std::size_t k = 0; k < stiffness.size(); ++k)
    shifted.values[k] = stiffness[k] - shift * mass[k];
  return shifted;
}

int ShiftedPencil::n_massive() const
{
  std::vector<bool> massive(M.size, false);
  for_each_entry(M,
                 [&](const int row, int, const double value)
                 {
                   if (value != 0.)
                     massive[row] = true;
                 });
  return int(std::count(massive.begin(), massive.end(), true));
}

void ShiftedPencil::apply_mass(const double *const x, double *const result) const
{
  std::fill(result, result + M.size, 0.);
  for_each_entry(M, [&](const int row, const int column, const double value) { result[row] += value * x[column]; });
}

double ShiftedPencil::relative_residual(const double value, const std::vector<double> &vector) const
{
  // Sums of K's entries first, those of their absolute values behind them: one exchange for both.
  const std::size_t n = vector.size();
  std::vector<double> sums(2 * n, 0.);
  for_each_entry(K,
                 [&](const int row, const int column, const double entry)
                 {
                   sums[row] += entry * vector[column];
                   sums[n + row] += std::abs(entry * vector[column]);
                 });
  communicator.sum(sums);
  for_each_entry(M,
                 [&](const int row, const int column, const double entry)
                 {
                   sums[row] -= value * entry * vector[column];
                   sums[n + row] += std::abs(value * entry * vector[column]);
                 });
  double residual = 0., contributions = 0.;
  for (std::size_t i = 0; i < n; ++i)
  {
    residual += sums[i] * sums[i];
    contributions += sums[n + i] * sums[n + i];
  }
  return std::sqrt(residual / contributions);
}
} // namespace pellicle::internal

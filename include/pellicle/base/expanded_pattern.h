// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/sparse_matrix.h>

#include <vector>

namespace pellicle
{
/** All entries of a matrix by rows, with the place each comes from. */
struct ExpandedPattern
{
  std::vector<int> row_start, columns, origin;

  explicit ExpandedPattern(const SparseMatrix &matrix)
      : row_start(matrix.size + 1, 0)
  {
    for_each_entry(matrix, [this](const int row, int, int) { ++row_start[row + 1]; });
    for (int i = 0; i < matrix.size; ++i)
      row_start[i + 1] += row_start[i];
    columns.resize(row_start.back());
    origin.resize(row_start.back());
    // Rows are visited from top to bottom, and a row's own entries precede those mirrored from below: columns come out
    // ascending.
    std::vector<int> next(row_start.begin(), row_start.end() - 1);
    for_each_entry(matrix,
                   [&](const int row, const int column, const int k)
                   {
                     columns[next[row]] = column;
                     origin[next[row]]  = k;
                     ++next[row];
                   });
  }

private:
  template <typename Action>
  static void for_each_entry(const SparseMatrix &matrix, const Action &action)
  {
    for (int i = 0; i < matrix.size; ++i)
      for (int k = matrix.row_start[i]; k < matrix.row_start[i + 1]; ++k)
      {
        action(i, matrix.columns[k], k);
        if (matrix.symmetry == MatrixSymmetry::symmetric && matrix.columns[k] != i)
          action(matrix.columns[k], i, k);
      }
  }
};
} // namespace pellicle

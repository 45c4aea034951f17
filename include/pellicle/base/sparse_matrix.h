// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

namespace pellicle
{
/** Which entries a matrix stores and what a solver may assume. */
enum class MatrixSymmetry
{
  symmetric, ///< only entries with column <= row are stored
  general    ///< all entries are stored
};

/**
 * Square sparse matrix in compressed rows, columns ascending within a row. With several MPI processes every process
 * holds the contributions of its own cells (with a pattern of its own); the matrix is their sum.
 */
struct SparseMatrix
{
  MatrixSymmetry symmetry = MatrixSymmetry::symmetric;
  int size                = 0;
  std::vector<int> row_start; ///< size + 1 entries
  std::vector<int> columns;
  std::vector<double> values;
};

/** y += factor * A x, A this process's part. */
void add_product(const SparseMatrix &matrix, double factor, const std::vector<double> &x, std::vector<double> &y);
} // namespace pellicle

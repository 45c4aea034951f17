// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/sparse_matrix.h>

namespace pellicle
{
void add_product(const SparseMatrix &matrix, const double factor, const std::vector<double> &x, std::vector<double> &y)
{
  for (int i = 0; i < matrix.size; ++i)
    for (int k = matrix.row_start[i]; k < matrix.row_start[i + 1]; ++k)
    {
      const int j = matrix.columns[k];
      y[i] += factor * matrix.values[k] * x[j];
      if (matrix.symmetry == MatrixSymmetry::symmetric && i != j)
        y[j] += factor * matrix.values[k] * x[i];
    }
}
} // namespace pellicle

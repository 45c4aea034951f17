// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace pellicle
{
/** A square matrix, row-major, that is made by adding products of vectors. */
struct DenseMatrix
{
  explicit DenseMatrix(const std::size_t n_rows)
      : n_rows(n_rows)
      , entries(n_rows * n_rows, 0.)
  {
  }

  double &operator()(const std::size_t i, const std::size_t j) { return entries[i * n_rows + j]; }
  double operator()(const std::size_t i, const std::size_t j) const { return entries[i * n_rows + j]; }

  /** += s u v^T */
  void add_outer(const double s, const std::vector<double> &u, const std::vector<double> &v)
  {
    for (std::size_t i = 0; i < n_rows; ++i)
    {
      const double factor = s * u[i];
      if (factor != 0.)
        for (std::size_t j = 0; j < n_rows; ++j)
          entries[i * n_rows + j] += factor * v[j];
    }
  }

  /** += s (u v^T + v u^T) */
  void add_both_outer(const double s, const std::vector<double> &u, const std::vector<double> &v)
  {
    add_outer(s, u, v);
    add_outer(s, v, u);
  }

  std::size_t n_rows;
  std::vector<double> entries; ///< [i * n_rows + j]
};
} // namespace pellicle

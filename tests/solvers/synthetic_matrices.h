// SPDX-License-Identifier: LGPL-2.1-or-later
// Sparse matrices with known properties for tests of the linear solvers.
#pragma once

#include <pellicle/base/sparse_matrix.h>

#include <algorithm>
#include <map>
#include <random>
#include <vector>

namespace pellicle::synthetic
{
/** Sums entries, whatever their order, into compressed rows; of a symmetric matrix it keeps the entries with column <=
 * row. */
class MatrixBuilder
{
public:
  MatrixBuilder(const MatrixSymmetry symmetry_, const int size)
      : symmetry(symmetry_)
      , rows(size)
  {
  }

  void add(const int row, const int column, const double value)
  {
    if (symmetry == MatrixSymmetry::general || column <= row)
      rows[row][column] += value;
  }

  SparseMatrix matrix() const
  {
    SparseMatrix result;
    result.symmetry = symmetry;
    result.size     = int(rows.size());
    result.row_start.push_back(0);
    for (const auto &row : rows)
    {
      for (const auto &[column, value] : row)
      {
        result.columns.push_back(column);
        result.values.push_back(value);
      }
      result.row_start.push_back(int(result.columns.size()));
    }
    return result;
  }

private:
  MatrixSymmetry symmetry;
  std::vector<std::map<int, double>> rows;
};

inline std::vector<double> product(const SparseMatrix &matrix, const std::vector<double> &x)
{
  std::vector<double> y(x.size(), 0.);
  for (int i = 0; i < matrix.size; ++i)
    for (int k = matrix.row_start[i]; k < matrix.row_start[i + 1]; ++k)
    {
      const int j = matrix.columns[k];
      y[i] += matrix.values[k] * x[j];
      if (matrix.symmetry == MatrixSymmetry::symmetric && i != j)
        y[j] += matrix.values[k] * x[i];
    }
  return y;
}

inline std::vector<double> random_vector(const int size, const unsigned int seed)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  std::vector<double> x(size);
  for (double &entry : x)
    entry = uniform(generator);
  return x;
}

/**
 * What a vesicle's tangent looks like: bicubic cells on a periodic grid (n_cells x n_cells, 9 n_cells^2 nodes), four
 * unknowns a node of which the first is the displacement (its block positive definite), the others the moment (negative
 * definite), both coupled; and n_border rows at the end, dense in the displacements, with a zero diagonal block: 27
 * n_cells^2 + n_border negative eigenvalues. With several ranks, rank r builds the contributions of the cells r, r +
 * n_ranks, ...; the numbers do not depend on the ranks.
 */
inline SparseMatrix saddle_matrix(const int n_cells, const int n_border, const unsigned int seed = 1,
                                  const int rank = 0, const int n_ranks = 1)
{
  const int side = 3 * n_cells, n_nodal = 4 * side * side;
  MatrixBuilder builder(MatrixSymmetry::symmetric, n_nodal + n_border);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  for (int cell = rank; cell < n_cells * n_cells; cell += n_ranks)
  {
    std::mt19937 generator(seed * 100003 + cell);
    std::vector<int> nodes;
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i)
        nodes.push_back((3 * (cell / n_cells) + j) % side * side + (3 * (cell % n_cells) + i) % side);
    // Diagonally dominant blocks of either sign, arbitrary coupling between them.
    for (unsigned int a = 0; a < nodes.size(); ++a)
      for (unsigned int b = 0; b <= a; ++b)
        for (int c = 0; c < 4; ++c)
          for (int d = 0; d < 4; ++d)
          {
            const double sign = c == 0 ? 1. : -1.;
            double v          = 0.;
            if (a == b && c == d)
              v = sign * 20.;
            else if (a != b || d < c)
              v = uniform(generator) * ((c == 0) == (d == 0) ? 0.3 : 3.);
            else
              continue; // the upper triangle
            const int row = 4 * nodes[a] + c, column = 4 * nodes[b] + d;
            builder.add(std::max(row, column), std::min(row, column), v);
          }
    for (int k = 0; k < n_border; ++k)
      for (const int node : nodes)
        builder.add(n_nodal + k, 4 * node, uniform(generator));
  }
  return builder.matrix();
}
} // namespace pellicle::synthetic

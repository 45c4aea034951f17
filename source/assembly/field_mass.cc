// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/field_mass.h>
#include <pellicle/discretization/point_walk.h>

#include <algorithm>
#include <map>
#include <vector>

namespace pellicle
{
SparseMatrix field_mass(const SurfaceDiscretization &discretization, const NodalVectors &positions,
                        const Numbering &numbering, const std::size_t field)
{
  const ShapeTables &tables = discretization.tables;
  const unsigned int n      = tables.n_nodes;
  std::vector<std::map<int, double>> rows(numbering.size());
  std::vector<double> cell_mass(std::size_t(n) * n);
  const auto add_cell = [&](const WalkCell &cell)
  {
    const std::size_t *const nodes = cell.nodes;
    std::fill(cell_mass.begin(), cell_mass.end(), 0.);
    for (unsigned int q = 0; q < tables.n_points; ++q)
    {
      const double *N = tables.tables[0].data() + std::size_t(q) * n;
      const double dA = cell[q].area();
      for (unsigned int I = 0; I < n; ++I)
        for (unsigned int J = 0; J < n; ++J)
          cell_mass[I * n + J] += dA * N[I] * N[J];
    }
    for (unsigned int I = 0; I < n; ++I)
      for (unsigned int J = 0; J < n; ++J)
        numbering.for_all_columns(field, nodes[I],
                                  [&](const std::size_t row, const Vector3<double> &row_column, const bool)
                                  {
                                    numbering.for_all_columns(
                                        field, nodes[J],
                                        [&](const std::size_t column, const Vector3<double> &column_column, const bool)
                                        {
                                          if (column <= row)
                                            rows[row][static_cast<int>(column)] +=
                                                cell_mass[I * n + J] * dot(row_column, column_column);
                                        });
                                  });
  };
  for_all_cells(tables, discretization.cell_nodes, positions, 3, add_cell);
  SparseMatrix mass;
  mass.size     = static_cast<int>(numbering.size());
  mass.symmetry = MatrixSymmetry::symmetric;
  mass.row_start.assign(1, 0);
  for (const auto &row : rows)
  {
    for (const auto &[column, value] : row)
    {
      mass.columns.push_back(column);
      mass.values.push_back(value);
    }
    mass.row_start.push_back(static_cast<int>(mass.columns.size()));
  }
  return mass;
}
} // namespace pellicle

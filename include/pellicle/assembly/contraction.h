// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/field_layout.h>

#include <vector>

namespace pellicle
{
/**
 * Contribution of one cell in plain R^3: derivatives with respect to the nodal vectors of the cell.
 * Row of field f, component c, local node I: (3 f + c) * n_nodes + I.
 */
struct Element
{
  unsigned int n_rows = 0;
  std::vector<double> gradient; ///< [row]
  std::vector<double> matrix;   ///< [row * n_rows + column], symmetric
};

/**
 * Contracts derivatives with respect to the inputs of points (PointSums) with the shape tables: the one place where
 * that happens. The tables are the same for all fields and cells; what differs is summed before.
 */
class Contraction
{
public:
  /** `active[f]`: whether rows and columns of field f are wanted; the others stay zero. */
  Contraction(const ShapeTables &tables, const FieldLayout &layout, std::vector<bool> active);

  unsigned int n_rows() const { return rows; }

  void gradient(const PointSums &sums, std::vector<double> &gradient) const;

  /** Changes the sums' Hessian when the map of the tables is not the identity. */
  void matrix(PointSums &sums, std::vector<double> &matrix);

private:
  void apply_map(PointSums &sums) const;
  const double *table(const unsigned int s) const { return stacked.data() + std::size_t(s) * n_points * n_nodes; }

  const ShapeTables &tables;
  std::vector<Field> fields;
  std::vector<bool> active;
  unsigned int n_points, n_nodes, rows;
  std::vector<double> stacked; ///< [(s * n_points + q) * n_nodes + I]
  std::vector<double> half_contracted;
};
} // namespace pellicle

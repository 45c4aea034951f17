// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>
#include <pellicle/kinematics/vector3.h>

#include <cstddef>
#include <vector>

namespace pellicle
{
/** A field at one point of a cell: [s] is the input in slot s (see ShapeTables) if that one was asked for. */
struct WalkPoint
{
  const std::size_t *nodes; ///< of the cell
  unsigned int q;           ///< number of the point in the cell
  double weight;            ///< quadrature weight
  const double *inputs;

  Vector3<double> operator[](const unsigned int slot) const
  {
    const double *const v = inputs + std::size_t(3) * slot;
    return {v[0], v[1], v[2]};
  }

  /** dA: weight times J = |x,1 x x,2|, if the field is the position. */
  double area() const { return weight * norm(cross((*this)[1], (*this)[2])); }
};

/** A field in one cell: [q] is its point q. */
struct WalkCell
{
  std::size_t number;       ///< of the cell
  const std::size_t *nodes; ///< of the cell
  const ShapeTables &tables;
  const double *inputs;

  WalkPoint operator[](const unsigned int q) const
  {
    return {nodes, q, tables.weights[q], inputs + std::size_t(18) * q};
  }
};

/**
 * Calls visit(WalkCell) for cell after cell, with the first `n_slots` slots of a field at the points of the tables.
 * `cell_nodes` has tables.n_nodes numbers a cell: those of a surface, of the edges of a line, or of a body.
 */
template <typename Visit>
void for_all_cells(const ShapeTables &tables, const std::vector<std::size_t> &cell_nodes, const NodalVectors &values,
                   const unsigned int n_slots, const Visit &visit)
{
  if (cell_nodes.empty())
    return;
  std::vector<double> inputs(std::size_t(tables.n_points) * 18);
  const std::size_t n_cells = cell_nodes.size() / tables.n_nodes;
  for (std::size_t cell = 0; cell < n_cells; ++cell)
  {
    const std::size_t *const nodes = cell_nodes.data() + cell * tables.n_nodes;
    evaluate_field(tables, nodes, values, n_slots, inputs.data());
    visit(WalkCell{cell, nodes, tables, inputs.data()});
  }
}

/** Calls visit(WalkPoint) for point after point of cell after cell. */
template <typename Visit>
void for_all_points(const ShapeTables &tables, const std::vector<std::size_t> &cell_nodes, const NodalVectors &values,
                    const unsigned int n_slots, const Visit &visit)
{
  for_all_cells(tables, cell_nodes, values, n_slots,
                [&](const WalkCell &cell)
                {
                  for (unsigned int q = 0; q < tables.n_points; ++q)
                    visit(cell[q]);
                });
}
} // namespace pellicle

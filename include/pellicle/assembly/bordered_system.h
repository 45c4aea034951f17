// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/cells.h>
#include <pellicle/assembly/contact_elements.h>
#include <pellicle/assembly/nodal_chart.h>
#include <pellicle/base/sparse_matrix.h>

#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace pellicle
{
/**
 * Unknowns of a linear system: the charts' unknowns node after node (fields in the layout's order within a node), then
 * the multipliers of the constraints, then one row for each rigid motion. Nodes that follow another one have no
 * unknowns of their own: they move with that one's.
 */
struct Numbering
{
  std::vector<NodalChart> charts; ///< one a field; a chart without nodes: the field is not part of this system
  std::size_t n_constraints = 0;
  std::size_t n_rigid       = 0;

  std::vector<std::size_t> first; ///< [node * n_fields + f]: first unknown of field f at a node
  std::size_t n_nodal = 0;        ///< unknowns of all charts

  Numbering(std::vector<NodalChart> charts, std::size_t n_constraints, std::size_t n_rigid);

  std::size_t n_fields() const { return charts.size(); }
  std::size_t size() const { return n_nodal + n_constraints + n_rigid; }
  std::size_t n_unknowns_of(std::size_t field) const;
  /** First unknown of a field at a node. */
  std::size_t first_of(const std::size_t field, const std::size_t node) const
  {
    return first[node * n_fields() + field];
  }
  /** Unknowns of a field at a node; 0 if the field is not part of the system. */
  unsigned int count(const std::size_t field, const std::size_t node) const
  {
    return charts[field].nodes.empty() ? 0 : charts[field].nodes[node].count;
  }
  /** Calls visit(unknown, column, is_mesh_equation) for each unknown of a field that moves a node: the node's own, then
   * those of its carriers. */
  template <typename Visit>
  void for_all_columns(const std::size_t field, const std::size_t node, const Visit &visit) const
  {
    const NodalChart &chart = charts[field];
    if (chart.nodes.empty())
      return;
    const NodalChart::Node &own = chart.nodes[node];
    for (unsigned int a = 0; a < own.count; ++a)
      visit(first_of(field, node) + a,
            Vector3<double>(own.columns[3 * a], own.columns[3 * a + 1], own.columns[3 * a + 2]), own.mesh_equation[a]);
    if (chart.carriers.empty())
      return;
    for (const NodalChart::Carrier &carrier : chart.carriers[node])
    {
      const NodalChart::Node &other = chart.nodes[carrier.node];
      for (unsigned int a = 0; a < other.count; ++a)
        visit(first_of(field, carrier.node) + a,
              Vector3<double>(carrier.share[0] * other.columns[3 * a], carrier.share[1] * other.columns[3 * a + 1],
                              carrier.share[2] * other.columns[3 * a + 2]),
              other.mesh_equation[a]);
    }
  }
};

/**
 * The linear system of one Newton step, bordered by constraints and rigid motions:
 *
 *     [ K    A    R    ] [ du      ]     [ r       ]
 *     [ A^T -1/c  0    ] [ dlambda ] = - [ g - g_0 - lambda/c ]
 *     [ R^T  0   -1/rho] [ mu      ]     [ 0       ]
 *
 * Direct solvers take the dense rows as they are. mu is zero at a solution (for a symmetric matrix; see
 * set_rigid_motion): the rigid rows make it regular. Each process holds the contributions of its own cells; residuals
 * are complete on every process after finish().
 */
class BorderedSystem
{
public:
  BorderedSystem(const SurfaceDiscretization &discretization, Numbering numbering, const Communicator &communicator);

  const Numbering &numbering() const { return unknowns; }
  /** Other directions for the same numbers of unknowns: pattern and analysis stay. */
  void set_charts(std::vector<NodalChart> charts) { unknowns.charts = std::move(charts); }

  void set_chart(const std::size_t field, NodalChart chart) { unknowns.charts[field] = std::move(chart); }

  void begin();
  /** Adds matrix and residual of a cell. `mesh`: the mesh energy's contribution, which mesh equations take instead of
   * the physics (null: nothing). */
  void add_cell(const Cell &cell, const Element &physics, const std::vector<std::vector<double>> &constraint_gradients,
                const Element *mesh);
  /** The same without the matrix. */
  void add_cell_residual(const Cell &cell, const Element &physics,
                         const std::vector<std::vector<double>> &constraint_gradients, const Element *mesh);
  /**
   * Room in the pattern for elements that couple nodes of several cells. A coupling that is met for the first time
   * means a new pattern (and a new analysis by the linear solver); known ones stay. Before begin().
   */
  void make_room(const std::vector<ContactElement> &elements);
  /** Adds matrix and residual of such an element of the position. */
  void add_pair(const ContactElement &element);
  /** Border: value -1/c on the diagonal of constraint k and its residual. */
  void set_constraint(std::size_t k, double compliance, double residual);
  /** Border row of a rigid motion: `direction` is a nodal vector field (already weighted), on the diagonal -1/rho. Its
   * reaction so far times the direction is part of the residual. */
  void set_rigid_motion(std::size_t k, const NodalVectors &direction, double inverse_rho, double reaction);
  /** Sums residuals over the processes and writes the constraints' rows into the border. */
  void finish();

  const SparseMatrix &matrix() const { return sparse; }
  const std::vector<double> &residual() const { return right; }
  /** Euclidean norms of the nodal residual and of the sum of the absolute contributions of cells to it. */
  double residual_norm() const;
  double contribution_norm() const;
  /** The gradient of constraint k with respect to all nodal unknowns. */
  const std::vector<double> &constraint_gradient(const std::size_t k) const { return constraint_rows[k]; }

  /** Adds values[i] to the diagonal entry of each nodal unknown i, on the first process only (the sum counts). */
  void add_to_diagonal(const std::vector<double> &values, double factor);

  /** Multiplies nodal vectors of field f by Z^T. */
  void restrict_vector(std::size_t field, const NodalVectors &vector, std::vector<double> &unknowns) const;
  /** values += factor Z u: displacements of nodes, to first order where these stay on bodies or the unit sphere. */
  void add_columns(const std::vector<double> &u, double factor, std::size_t field, NodalVectors &values) const;
  /** x_f += factor Z u; unit vectors are normalised afterwards, nodes on bodies go to the closest point.
   * Throws SolveError where there is none. */
  void prolongate(const std::vector<double> &u, double factor, std::size_t field, NodalVectors &values) const;

private:
  void make_pattern();
  int place_of(int row, int column) const;
  void write_border(std::size_t row, const std::vector<double> &values);
  /** A column of the cell's Z: how an unknown of the list moves a node. */
  struct CellColumn
  {
    std::size_t local = 0; ///< place of the unknown in cell_list
    Vector3<double> along;
    bool mesh_equation = false;
  };
  void project(const Cell &cell, const Element &physics, const Element *mesh);
  void curve(const Cell &cell, const Element &physics, const Element *mesh);
  void cell_unknowns(const Cell &cell, std::size_t n_fields);

  const SurfaceDiscretization &discretization;
  const Communicator &communicator;
  Numbering unknowns;
  SparseMatrix sparse;
  std::vector<double> right, contributions;
  std::vector<std::vector<double>> constraint_rows;
  std::vector<bool> mesh_row; ///< of nodal unknowns

  std::vector<std::size_t> scatter_start;       ///< of each own cell in `scatter`
  std::vector<int> scatter;                     ///< positions in sparse.values; -1: not stored (upper triangle)
  std::vector<int> diagonal;                    ///< position of each diagonal entry
  std::set<std::vector<std::size_t>> couplings; ///< nodes of elements for which there is room
  std::vector<int> cell_list;                   ///< unknowns of one cell, each once
  std::vector<CellColumn> cell_columns;         ///< its Z, node after node, field after field
  std::vector<std::size_t> first_cell_column;   ///< [i * n_fields + f]
  std::vector<int> place_in_list;               ///< of each unknown; -1: not in it
  std::vector<double> projected, row_times_Z;
};
} // namespace pellicle

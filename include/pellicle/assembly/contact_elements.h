// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/contraction.h>
#include <pellicle/assembly/slave_points.h>
#include <pellicle/kinematics/dense_matrix.h>
#include <pellicle/potentials/potential.h>

#include <cstddef>
#include <vector>

namespace pellicle
{
/**
 * Contribution of the points of one slave cell (or edge) that touch one master cell, in plain R^3. Rows as in Element
 * with one field: component c of node number I in `nodes` is row c * nodes.size() + I. A node may occur twice where a
 * surface touches itself.
 */
struct ContactElement
{
  std::vector<std::size_t> nodes; ///< of the slave cell, then of the master cell
  Element derivatives;            ///< gradient; matrix with rows of the variation, columns of the linearisation
};

/** What contact adds to the equations of the position. */
struct ContactElements
{
  double energy        = 0.;
  std::size_t n_active = 0;             ///< points that touch
  std::vector<ContactElement> elements; ///< none if only the value was asked for
};

/**
 * Sums what points add to elements, one for each pair of a slave cell and a master cell. Rows of a point are those of
 * ClosestPoint (x, then master nodes); x = sum_I N_I x_I brings them to the nodes of the slave cell.
 */
class ContactElementSums
{
public:
  /** `order`: value makes no elements, gradient no matrices. */
  ContactElementSums(const SlavePoints &slave, const SurfaceCells &master, Order order);

  /** What follows is of a point of this pair; N_I = shapes[I]. Cells of the slave come one after the other. */
  void select(std::size_t slave_cell, std::size_t master_cell, const double *shapes);

  /** A point's row in terms of the pair's nodes: N_I times the part of x, then that of master nodes. */
  std::vector<double> at_nodes(const std::vector<double> &row) const;

  // In terms of the pair's nodes:
  void add_gradient(double factor, const std::vector<double> &row);
  void add_outer(double factor, const std::vector<double> &u, const std::vector<double> &v); ///< matrix += factor u v^T
  // In terms of a point:
  void add_matrix(double factor, const DenseMatrix &of_point);

  bool wants(const Order least) const { return order >= least; }
  std::size_t n_nodes() const { return slave.n_local() + master.n_local(); }
  ContactElements sums;

private:
  ContactElement &current() { return sums.elements[selected]; }

  const SlavePoints &slave;
  const SurfaceCells &master;
  Order order;
  std::vector<std::size_t> master_cells; ///< by element
  std::size_t slave_cell = 0, first_of_slave_cell = 0, selected = 0;
  const double *shapes = nullptr;
};
} // namespace pellicle

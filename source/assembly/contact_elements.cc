// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/contact_elements.h>

namespace pellicle
{
ContactElementSums::ContactElementSums(const SlavePoints &slave, const SurfaceCells &master, const Order order)
    : slave(slave)
    , master(master)
    , order(order)
{
}

void ContactElementSums::select(const std::size_t slave_cell_, const std::size_t master_cell, const double *shapes_)
{
  shapes = shapes_;
  if (!wants(Order::gradient))
    return;
  if (slave_cell_ != slave_cell)
    first_of_slave_cell = sums.elements.size();
  slave_cell = slave_cell_;
  for (selected = first_of_slave_cell; selected < sums.elements.size(); ++selected)
    if (master_cells[selected] == master_cell)
      return;

  master_cells.push_back(master_cell);
  ContactElement element;
  element.nodes.assign(slave.nodes(slave_cell), slave.nodes(slave_cell) + slave.n_local());
  element.nodes.insert(element.nodes.end(), master.nodes(master_cell), master.nodes(master_cell) + master.n_local());
  const unsigned int n_rows  = 3 * n_nodes();
  element.derivatives.n_rows = n_rows;
  element.derivatives.gradient.assign(n_rows, 0.);
  if (wants(Order::hessian))
    element.derivatives.matrix.assign(std::size_t(n_rows) * n_rows, 0.);
  sums.elements.push_back(std::move(element));
}

std::vector<double> ContactElementSums::at_nodes(const std::vector<double> &row) const
{
  const std::size_t n = n_nodes(), n_slave = slave.n_local(), n_master = master.n_local();
  std::vector<double> result(3 * n);
  for (unsigned int c = 0; c < 3; ++c)
  {
    const double *const of_component = row.data() + c * (1 + n_master);
    for (std::size_t I = 0; I < n_slave; ++I)
      result[c * n + I] = shapes[I] * of_component[0];
    for (std::size_t K = 0; K < n_master; ++K)
      result[c * n + n_slave + K] = of_component[1 + K];
  }
  return result;
}

void ContactElementSums::add_gradient(const double factor, const std::vector<double> &row)
{
  std::vector<double> &gradient = current().derivatives.gradient;
  for (std::size_t i = 0; i < gradient.size(); ++i)
    gradient[i] += factor * row[i];
}

void ContactElementSums::add_outer(const double factor, const std::vector<double> &u, const std::vector<double> &v)
{
  std::vector<double> &matrix = current().derivatives.matrix;
  for (std::size_t i = 0; i < u.size(); ++i)
    for (std::size_t j = 0; j < v.size(); ++j)
      matrix[i * v.size() + j] += factor * u[i] * v[j];
}

// Columns first: each row of the point becomes one in terms of nodes, then rows are distributed.
void ContactElementSums::add_matrix(const double factor, const DenseMatrix &of_point)
{
  const std::size_t n = n_nodes(), n_slave = slave.n_local(), n_master = master.n_local(), n_rows = 3 * n;
  std::vector<double> &matrix = current().derivatives.matrix;
  const auto add_row          = [&](const std::size_t row, const double weight, const std::vector<double> &values)
  {
    for (std::size_t j = 0; j < n_rows; ++j)
      matrix[row * n_rows + j] += weight * values[j];
  };
  for (unsigned int c = 0; c < 3; ++c)
    for (std::size_t j = 0; j < 1 + n_master; ++j)
    {
      const auto begin                 = of_point.entries.begin() + (c * (1 + n_master) + j) * of_point.n_rows;
      const std::vector<double> values = at_nodes({begin, begin + of_point.n_rows});
      if (j > 0)
        add_row(c * n + n_slave + j - 1, factor, values);
      else
        for (std::size_t I = 0; I < n_slave; ++I)
          add_row(c * n + I, factor * shapes[I], values);
    }
}
} // namespace pellicle

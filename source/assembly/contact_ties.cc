// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/contact_ties.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/point_walk.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

namespace pellicle
{
namespace
{
Vector3<double> interpolate(const double *shapes, const std::size_t *nodes, const std::size_t n,
                            const NodalVectors &positions)
{
  Vector3<double> x;
  for (std::size_t i = 0; i < n; ++i)
    for (unsigned int c = 0; c < 3; ++c)
      x[c] += shapes[i] * positions[3 * nodes[i] + c];
  return x;
}

/** [v; -M_K v], a row over the slave point and the master's nodes. */
std::vector<double> row_along(const Vector3<double> &v, const std::vector<double> &shapes)
{
  MasterPoint master;
  master.values = shapes;
  return relative_row(v, master);
}
} // namespace

ContactTies::ContactTies(const SurfaceCells &slave_cells, SurfaceCells master_cells, const NodalVectors &positions,
                         const double penalty, const SearchLimits &limits, std::string name)
    : ContactTies(SlavePoints(slave_cells, positions, slave_cells.degree + 1), std::move(master_cells), positions,
                  penalty, limits, std::move(name))
{
}

ContactTies::ContactTies(SlavePoints slave_points, SurfaceCells master_cells, const NodalVectors &positions,
                         const double penalty, const SearchLimits &limits, std::string name)
    : own_name(std::move(name))
    , slave(std::move(slave_points))
    , master(std::move(master_cells))
    , penalty(penalty)
{
  if (!(penalty > 0.))
    throw UserError("The penalty of a tie is " + std::to_string(penalty) + "; it must be > 0.");
  ContactSearch search(master, limits);
  search.update(positions);
  for_all_cells(slave.tables, slave.cell_nodes, positions, 3,
                [&](const WalkCell &cell)
                {
                  for (unsigned int q = 0; q < cell.tables.n_points; ++q)
                  {
                    const auto partner = search.closest(cell[q][0], cross(cell[q][1], cell[q][2]));
                    if (partner)
                      ties.push_back({cell.number, q, partner->cell, partner->at.xi,
                                      master_point(search.shape(partner->cell), partner->at).values, Vector3<double>(),
                                      Vector3<double>()});
                  }
                });
}

Vector3<double> ContactTies::gap(const TiedPoint &tie, const NodalVectors &positions) const
{
  return interpolate(slave.shapes(tie.q), slave.nodes(tie.slave_cell), slave.n_local(), positions) -
         interpolate(tie.shapes.data(), master.nodes(tie.master_cell), master.n_local(), positions);
}

ContactElements ContactTies::evaluate(const NodalVectors &positions, const Order order)
{
  ContactElementSums sums(slave, master, order);
  for (TiedPoint &tie : ties)
  {
    if (!slave.is_own(tie.slave_cell))
      continue;
    ++sums.sums.n_active;
    const Vector3<double> g = gap(tie, positions);
    const double area       = slave.reference_areas[tie.slave_cell * slave.tables.n_points + tie.q];
    tie.traction            = tie.multiplier - penalty * g;
    sums.sums.energy += area * (0.5 * penalty * dot(g, g) - dot(tie.multiplier, g));
    if (!sums.wants(Order::gradient))
      continue;
    sums.select(tie.slave_cell, tie.master_cell, slave.shapes(tie.q));
    sums.add_gradient(area, sums.at_nodes(row_along(-1. * tie.traction, tie.shapes)));
    if (sums.wants(Order::hessian))
    {
      DenseMatrix matrix(3 * (1 + master.n_local()));
      for (const Vector3<double> &axis :
           {Vector3<double>(1., 0., 0.), Vector3<double>(0., 1., 0.), Vector3<double>(0., 0., 1.)})
      {
        const std::vector<double> row = row_along(axis, tie.shapes);
        matrix.add_outer(penalty, row, row);
      }
      sums.add_matrix(area, matrix);
    }
  }
  return std::move(sums.sums);
}

MultiplierChange ContactTies::pending() const
{
  MultiplierChange change;
  for (const TiedPoint &tie : ties)
  {
    change.largest_change   = std::max(change.largest_change, norm(tie.traction - tie.multiplier));
    change.largest_traction = std::max(change.largest_traction, norm(tie.traction));
  }
  return change;
}

MultiplierChange ContactTies::augment()
{
  const MultiplierChange change = pending();
  for (TiedPoint &tie : ties)
    tie.multiplier = tie.traction;
  return change;
}

std::vector<double> ContactTies::memory() const
{
  std::vector<double> list;
  for (const TiedPoint &tie : ties)
    for (unsigned int c = 0; c < 3; ++c)
      list.push_back(slave.is_own(tie.slave_cell) ? tie.multiplier[c] : 0.);
  return list;
}

void ContactTies::recall(const std::vector<double> &memory)
{
  for (std::size_t i = 0; i < ties.size(); ++i)
    ties[i].multiplier = {memory[3 * i], memory[3 * i + 1], memory[3 * i + 2]};
}

std::vector<std::size_t> ContactTies::material_nodes() const
{
  std::set<std::size_t> nodes;
  for (const TiedPoint &tie : ties)
  {
    nodes.insert(slave.nodes(tie.slave_cell), slave.nodes(tie.slave_cell) + slave.n_local());
    nodes.insert(master.nodes(tie.master_cell), master.nodes(tie.master_cell) + master.n_local());
  }
  return {nodes.begin(), nodes.end()};
}
} // namespace pellicle

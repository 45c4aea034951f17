// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/slave_points.h>
#include <pellicle/discretization/point_walk.h>

#include <tuple>

namespace pellicle
{
SlavePoints::SlavePoints(const SurfaceCells &slave, const NodalVectors &reference, const unsigned int n_gauss)
    : cell_nodes(slave.cell_nodes)
    , tables(make_surface_tables(slave.degree, n_gauss))
    , end_own(slave.size())
{
  for_all_points(tables, cell_nodes, reference, 3,
                 [this](const WalkPoint &point) { reference_areas.push_back(point.area()); });
}

SlavePoints::SlavePoints(const EdgeLoop &slave, const NodalVectors &reference)
    : cell_nodes(slave.cell_nodes)
    , tables(slave.tables)
    , on_line(true)
    , end_own(slave.n_cells)
{
  for_all_points(tables, cell_nodes, reference, 2,
                 [this](const WalkPoint &point) { reference_areas.push_back(point.weight * norm(point[1])); });
}

void SlavePoints::distribute(const Communicator &communicator)
{
  std::tie(first_own, end_own) = communicator.own_range(n_cells());
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/slave_points.h>
#include <pellicle/discretization/point_walk.h>

#include <utility>

namespace pellicle
{
SlavePoints::SlavePoints(SurfaceCells slave, const NodalVectors &reference, const unsigned int n_gauss)
    : cells(std::move(slave))
    , tables(make_surface_tables(cells.degree, n_gauss))
{
  for_all_points(tables, cells.cell_nodes, reference, 3,
                 [this](const WalkPoint &point) { reference_areas.push_back(point.area()); });
}
} // namespace pellicle

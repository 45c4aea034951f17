// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/discretization/point_walk.h>
#include <pellicle/models/region_measures.h>

#include <algorithm>

namespace pellicle
{
std::vector<RegionMeasures> measure_regions(const SurfaceDiscretization &surface, const NodalVectors &positions,
                                            const LiquidPressure &pressure)
{
  std::vector<RegionMeasures> regions(std::max<std::size_t>(1, surface.region_names.size()));
  for_all_cells(surface.tables, surface.cell_nodes, positions, 3,
                [&](const WalkCell &cell)
                {
                  auto &region = regions[surface.cell_region.empty() ? 0 : surface.cell_region[cell.number]];
                  for (unsigned int q = 0; q < surface.tables.n_points; ++q)
                  {
                    const Vector3<double> dA = cell[q].weight * cross(cell[q][1], cell[q][2]);
                    region.area += norm(dA);
                    region.volume += dot(cell[q][0], dA) / 3.;
                    region.push += pressure(cell[q][0]) * dA[2];
                  }
                });
  return regions;
}
} // namespace pellicle

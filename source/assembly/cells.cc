// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/cells.h>

namespace pellicle
{
std::vector<Cell> own_cells(const SurfaceDiscretization &discretization, const Communicator &communicator)
{
  std::vector<Cell> cells;
  const auto append = [&](const std::size_t set, const std::size_t n_cells, const std::vector<std::size_t> &cell_nodes)
  {
    const std::size_t n_nodes = tables_of(discretization, set).n_nodes;
    const auto [first, last]  = communicator.own_range(n_cells);
    for (std::size_t c = first; c < last; ++c)
      cells.push_back({set, c, cells.size(), cell_nodes.data() + c * n_nodes, n_nodes});
  };
  append(0, discretization.n_cells, discretization.cell_nodes);
  for (std::size_t e = 0; e < discretization.edges.size(); ++e)
    append(1 + e, discretization.edges[e].n_cells, discretization.edges[e].cell_nodes);
  return cells;
}

const ShapeTables &tables_of(const SurfaceDiscretization &discretization, const std::size_t set)
{
  return set == 0 ? discretization.tables : discretization.edges[set - 1].tables;
}
} // namespace pellicle

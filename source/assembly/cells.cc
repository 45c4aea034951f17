// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/cells.h>
#include <pellicle/base/exceptions.h>

#include <algorithm>

namespace pellicle
{
namespace
{
template <typename Part>
std::size_t index_of(const std::vector<Part> &parts, const std::string &name)
{
  const auto found = std::find_if(parts.begin(), parts.end(), [&](const Part &part) { return part.name == name; });
  PELLICLE_ASSERT(found != parts.end(), "a potential acts on an edge loop or a body that this discretization lacks");
  return static_cast<std::size_t>(found - parts.begin());
}
} // namespace

std::size_t n_sets(const SurfaceDiscretization &discretization)
{
  return 1 + discretization.edges.size() + discretization.bulks.size();
}

std::size_t set_of(const SurfaceDiscretization &discretization, const Where &where)
{
  switch (where.part)
  {
  case Where::Part::edge:
    return 1 + index_of(discretization.edges, where.name);
  case Where::Part::bulk:
    return 1 + discretization.edges.size() + index_of(discretization.bulks, where.name);
  default:
    return 0;
  }
}

std::vector<Cell> own_cells(const SurfaceDiscretization &discretization, const Communicator &communicator)
{
  std::vector<Cell> cells;
  std::size_t set   = 0;
  const auto append = [&](const std::size_t n_cells, const std::vector<std::size_t> &cell_nodes)
  {
    const std::size_t n_nodes = tables_of(discretization, set).n_nodes;
    const auto [first, last]  = communicator.own_range(n_cells);
    for (std::size_t c = first; c < last; ++c)
      cells.push_back({set, c, cells.size(), cell_nodes.data() + c * n_nodes, n_nodes});
    ++set;
  };
  append(discretization.n_cells, discretization.cell_nodes);
  for (const EdgeLoop &loop : discretization.edges)
    append(loop.n_cells, loop.cell_nodes);
  for (const BulkPart &body : discretization.bulks)
    append(body.n_cells, body.cell_nodes);
  return cells;
}

std::size_t n_cells_of(const SurfaceDiscretization &discretization, const std::size_t set)
{
  const std::size_t n_edges = discretization.edges.size();
  return set == 0         ? discretization.n_cells
         : set <= n_edges ? discretization.edges[set - 1].n_cells
                          : discretization.bulks[set - 1 - n_edges].n_cells;
}

const ShapeTables &tables_of(const SurfaceDiscretization &discretization, const std::size_t set)
{
  const std::size_t n_edges = discretization.edges.size();
  return set == 0         ? discretization.tables
         : set <= n_edges ? discretization.edges[set - 1].tables
                          : discretization.bulks[set - 1 - n_edges].tables;
}
} // namespace pellicle

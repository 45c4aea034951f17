// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>

#include <array>
#include <cstddef>
#include <vector>

namespace pellicle
{
/** One of two partners in contact: cells of one or several surfaces, on the nodes of one vector of positions. */
struct SurfaceCells
{
  unsigned int degree = 1;
  std::vector<std::size_t> cell_nodes; ///< [c * n_local() + i], i lexicographic
  /** [c]: sides of the cell, numbered as in CellSide, that no other of these cells shares. */
  std::vector<std::array<bool, 4>> rim_side;
  /** [c]: vertices at which rim sides meet; vertex v at (v % 2, v / 2). */
  std::vector<std::array<bool, 4>> rim_vertex;

  std::size_t n_local() const { return std::size_t(degree + 1) * (degree + 1); }
  std::size_t size() const { return rim_side.size(); }
  const std::size_t *nodes(const std::size_t c) const { return cell_nodes.data() + c * n_local(); }
};

/**
 * The given cells of a surface in space (none given: all of them). `first_node` is added to the numbers of nodes, for
 * surfaces that share a vector of positions. Nodes that are twins count as one when sides are compared. Asserts that it
 * is no meridian.
 */
SurfaceCells surface_cells(const SurfaceDiscretization &surface, const std::vector<std::size_t> &cells = {},
                           std::size_t first_node = 0);
} // namespace pellicle

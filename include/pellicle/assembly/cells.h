// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/communicator.h>
#include <pellicle/discretization/surface_discretization.h>

#include <cstddef>
#include <vector>

namespace pellicle
{
/** A cell of the surface, or of one of its edge loops. */
struct Cell
{
  std::size_t set   = 0; ///< 0: the surface; 1 + e: edge loop e
  std::size_t index = 0; ///< within its set
  std::size_t own   = 0; ///< running number among the cells of this process, all sets together
  const std::size_t *nodes;
  std::size_t n_nodes = 0;
};

/** All cells of this process: those of the surface first, then those of the edge loops. */
std::vector<Cell> own_cells(const SurfaceDiscretization &discretization, const Communicator &communicator);

/** Shape tables of a set of cells: the surface's (0) or those of edge loop set - 1. */
const ShapeTables &tables_of(const SurfaceDiscretization &discretization, std::size_t set);
} // namespace pellicle

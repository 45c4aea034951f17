// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/communicator.h>
#include <pellicle/discretization/surface_discretization.h>
#include <pellicle/potentials/potential.h>

#include <cstddef>
#include <vector>

namespace pellicle
{
/** A cell of the surface, of one of its edge loops, or of a body. */
struct Cell
{
  std::size_t set   = 0; ///< 0: the surface; 1 + e: edge loop e; 1 + n_edges + b: body b
  std::size_t index = 0; ///< within its set
  std::size_t own   = 0; ///< running number among the cells of this process, all sets together
  const std::size_t *nodes;
  std::size_t n_nodes = 0;
};

/** Number of sets of cells. */
std::size_t n_sets(const SurfaceDiscretization &discretization);

/** The set on which a potential acts. Asserts that the discretization has it. */
std::size_t set_of(const SurfaceDiscretization &discretization, const Where &where);

/** Number of cells in a set, of all processes. */
std::size_t n_cells_of(const SurfaceDiscretization &discretization, std::size_t set);

/** All cells of this process, set by set. */
std::vector<Cell> own_cells(const SurfaceDiscretization &discretization, const Communicator &communicator);

/** Shape tables of a set of cells. */
const ShapeTables &tables_of(const SurfaceDiscretization &discretization, std::size_t set);
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/cells.h>
#include <pellicle/potentials/effect.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pellicle
{
/** A term as one loop over cells meets it. */
struct LoopTerm
{
  enum class Kind
  {
    energy,
    constraint,
    dissipation
  };
  Kind kind = Kind::energy;
  std::string name;
  std::string region;              ///< on whose cells alone it acts; empty: on all
  std::vector<std::string> fields; ///< that it reads
};

/** A set of cells that the assembler visits, with all that acts there. */
struct CellLoop
{
  std::string over; ///< "surface", "edge NAME" or "body NAME"
  std::size_t n_cells  = 0;
  std::size_t n_points = 0; ///< quadrature points of all its cells
  std::vector<LoopTerm> terms;
};

/**
 * What the lists of a scene make the assembler visit, in the order of Cell::set. A set on which nothing acts is not in
 * it. A constraint that is an integral over several sets is a term of each of them.
 */
std::vector<CellLoop> cell_loops(const SurfaceDiscretization &discretization, const PotentialSet &set);

/** Calls of potentials in one pass over all these cells, as AssemblyCounters counts them. */
std::size_t potential_calls(const std::vector<CellLoop> &loops, const SurfaceDiscretization &discretization);

/** "energy", "constraint" or "dissipation". */
const char *kind_name(LoopTerm::Kind kind);
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>

namespace pellicle
{
/** Whether the cells of a surface keep their orientation when it is joined to another one. */
enum class JoinedSide
{
  as_it_is,
  turned_round
};

/**
 * Appends the cells of a surface one of whose rims is at the place of a line of the first surface, node on node: the
 * rim's nodes become those of the line. A meridian that is turned round is run through from its end.
 *
 * Places of a meridian's cells are those of a further patch (which runs with the cells); in space there are none any
 * more. Returns the new number of each node. Regions and edge loops are up to the caller.
 */
std::vector<std::size_t> append_at_line(SurfaceDiscretization &first, const EdgeLoop &line,
                                        const SurfaceDiscretization &second, const EdgeLoop &rim, JoinedSide side);
} // namespace pellicle

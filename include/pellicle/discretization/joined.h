// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>

#include <array>
#include <string>

namespace pellicle
{
/**
 * Two discretizations of one kind and degree as one, which share no node: a drop and a block to put it on. Nodes,
 * cells, edge loops and bodies of the second come after those of the first. Surfaces with cells on both sides become
 * regions of the given names. Rigid motions are left out: neither part moves freely when they are held by each other.
 *
 * Throws UserError for different kinds or degrees, and for edge loops or bodies of the same name.
 */
SurfaceDiscretization joined(const SurfaceDiscretization &first, const SurfaceDiscretization &second,
                             const std::array<std::string, 2> &regions);

/** The bodies alone, whose surface is looked after by somebody else (contact, another surface on the same nodes). */
SurfaceDiscretization without_surface(SurfaceDiscretization discretization);
} // namespace pellicle

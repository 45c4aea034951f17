// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>

#include <string>

namespace pellicle
{
/** Name of the loop on the far side of a line along which a surface is split. */
std::string far_side(const std::string &line);

/**
 * The same surface with two nodes instead of one everywhere on a line, so that fields can jump there: the cells of the
 * regions other than 0 get the copies, which are the last nodes. The loop of that name keeps to the copies; a new one,
 * far_side(line), runs in the same direction along the originals. Asserts that there is such a loop.
 */
SurfaceDiscretization split_along(SurfaceDiscretization surface, const std::string &line);
} // namespace pellicle

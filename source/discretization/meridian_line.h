// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/refinement.h>
#include <pellicle/discretization/surface_discretization.h>

#include <functional>

namespace pellicle
{
/** Line cells one after the other, nodes at point(t), t from 0 to n_cells, y left out; all may move in the half plane.
 * They are n_cells of length 1 in t, of which those at the places `cut` are halved, and neighbours that would be more
 * than twice as long. Gauss tables; no rigid motion yet. */
SurfaceDiscretization meridian_line(unsigned int degree, std::size_t n_cells, const std::vector<CellPlace> &cut,
                                    bool mirror, const std::function<Vector3<double>(double)> &point);

/** The node is a pole: r = 0, and it moves along z only. */
void put_on_axis(SurfaceDiscretization &meridian, std::size_t node);
/** The node is on the mirror plane: z = 0, and it moves along r only. */
void put_on_mirror(SurfaceDiscretization &meridian, std::size_t node);
/** Translation along z leaves the energy unchanged. */
void free_along_axis(SurfaceDiscretization &meridian);
} // namespace pellicle

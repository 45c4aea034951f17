// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>

#include <functional>

namespace pellicle
{
/** Line cells one after the other, nodes at point(t), t from 0 to n_cells (whole at vertices), y left out; all may move
 * in the half plane. Gauss tables; no rigid motion yet. */
SurfaceDiscretization meridian_line(unsigned int degree, std::size_t n_cells, bool mirror,
                                    const std::function<Vector3<double>(double)> &point);

/** The node is a pole: r = 0, and it moves along z only. */
void put_on_axis(SurfaceDiscretization &meridian, std::size_t node);
/** The node is on the mirror plane: z = 0, and it moves along r only. */
void put_on_mirror(SurfaceDiscretization &meridian, std::size_t node);
/** Translation along z leaves the energy unchanged. */
void free_along_axis(SurfaceDiscretization &meridian);
} // namespace pellicle

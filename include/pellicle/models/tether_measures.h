// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>

#include <string>
#include <utility>
#include <vector>

namespace pellicle
{
/**
 * Of a surface with an edge loop "tip": `length`, the height of the tip above the ring, and on a meridian
 * `mid_height_radius`, the radius at half that height (of the outermost crossing; nothing while the tip is in the plane
 * of the ring). Empty without a tip.
 */
std::vector<std::pair<std::string, double>> tether_measures(const SurfaceDiscretization &discretization,
                                                            const NodalVectors &positions);
} // namespace pellicle

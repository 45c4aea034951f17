// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>

#include <optional>

namespace pellicle
{
/** Radius of the narrowest neck of a meridian: the smallest radius at which r has a local minimum between the ends;
 * none on a shape without necks, and on surfaces in space. */
std::optional<double> neck_radius(const SurfaceDiscretization &discretization, const NodalVectors &positions);
} // namespace pellicle

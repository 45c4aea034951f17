// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>

#include <string>

namespace pellicle
{
/**
 * The closed surface made of two open ones with one rim each at the same place, for example a cap and the disc below
 * it. Normals of `lower`, which point to the same side as those of `upper` there, are turned round. Nodes of `upper`
 * keep their numbers; its rim becomes an inner line (is_rim false) that keeps its name. Regions: 0 `upper_name`, 1
 * `lower_name`. On meridians `upper` comes first and `lower` is run through from its rim to the axis.
 */
SurfaceDiscretization closed_at_rim(const SurfaceDiscretization &upper, const SurfaceDiscretization &lower,
                                    const std::string &upper_name, const std::string &lower_name);
} // namespace pellicle

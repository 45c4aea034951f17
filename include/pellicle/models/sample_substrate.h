// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/models/surface_sample.h>

namespace pellicle
{
class SurfaceModel;

/** The substrate of a drop and, if there is one, the upper plate, as far as they are near the drop: one disc of each
 * chart's coordinates. The user's units. */
SurfaceSample sample_substrate(const SurfaceModel &model);
} // namespace pellicle

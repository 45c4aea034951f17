// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>

namespace pellicle
{
/** Noise: at every node a vector with components that are uniform in [-amplitude, amplitude], projected to the
 * directions that symmetry admits there. The same on every machine. */
NodalVectors random_vectors(const SurfaceDiscretization &surface, double amplitude, int seed);
} // namespace pellicle

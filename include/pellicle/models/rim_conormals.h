// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/start_shapes.h>

#include <vector>

namespace pellicle
{
/**
 * Outward unit conormals of the start shape at the quadrature points of an edge loop. All rims are circles about the z
 * axis, so they are exact: cos b e_r + sin b e_z.
 */
std::vector<Vector3<double>> start_conormals(const SurfaceDiscretization &discretization, const EdgeLoop &loop,
                                             const StartShape &shape);
} // namespace pellicle

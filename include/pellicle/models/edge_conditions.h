// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/nodal_conditions.h>
#include <pellicle/discretization/start_shapes.h>
#include <pellicle/potentials/effect.h>

#include <vector>

namespace pellicle
{
/**
 * What the edges of a scene ask of the nodes: the place of clamped and hinged rims is held; the moment vanishes on free
 * and hinged rims without Gaussian modulus; conormals are unknowns on those with one. The tip of a tether moves as one
 * body along z.
 */
NodalConditions edge_conditions(const SurfaceDiscretization &discretization, const SceneTargets &targets);

/**
 * Outward unit conormals of the start shape at the quadrature points of an edge loop. All rims are circles about the z
 * axis, so they are exact: cos b e_r + sin b e_z.
 */
std::vector<Vector3<double>> start_conormals(const SurfaceDiscretization &discretization, const EdgeLoop &loop,
                                             const StartShape &shape);
} // namespace pellicle

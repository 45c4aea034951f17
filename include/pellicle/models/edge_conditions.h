// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/nodal_conditions.h>
#include <pellicle/discretization/surface_discretization.h>
#include <pellicle/potentials/effect.h>

namespace pellicle
{
/**
 * What the edges of a scene ask of the nodes: the place of clamped and hinged rims is held; the moment vanishes on free
 * and hinged rims without Gaussian modulus; conormals are unknowns on those with one. The tip of a tether moves as one
 * body along z.
 */
NodalConditions edge_conditions(const SurfaceDiscretization &discretization, const SceneTargets &targets);
} // namespace pellicle

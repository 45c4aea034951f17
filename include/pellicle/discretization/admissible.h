// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>

namespace pellicle
{
/** Directions in which vectors at a node may change: all three where the mesh lists none. */
AdmissibleDirections admissible_at(const SurfaceDiscretization &discretization, std::size_t node);

/** Projection on the directions, sum of (v . e) e: on a plane of symmetry, what a vector has in common with its mirror
 * image. */
Vector3<double> admissible_part(const AdmissibleDirections &directions, const Vector3<double> &v);

/** Whether vectors may change along a coordinate: not at every node of a meridian's end, or of a plane of symmetry. */
bool admits(const AdmissibleDirections &directions, unsigned int component);
} // namespace pellicle

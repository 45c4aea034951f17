// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/nodal_conditions.h>
#include <pellicle/discretization/shell_shapes.h>
#include <pellicle/potentials/shell/shell_targets.h>

#include <vector>

namespace pellicle
{
/**
 * What holds a shell: planes of symmetry keep displacements and changes of the director from leaving them; edges of a
 * plate and the curved ends of a roof are simply supported, "hard": along its edges a plate moves neither up nor along
 * the edge and its director does not lean along the edge; a roof rests on diaphragms, stiff in their plane, that leave
 * displacements along the axis. Of a hemisphere, which could move along its axis, one point of the equator keeps its
 * height.
 *
 * The shape is that of `surface`, in its units of length.
 */
NodalConditions shell_supports(const ShellShape &shape, const SurfaceDiscretization &surface);

/**
 * Points at which a shell may be loaded, in the units of the shape, in the order of their names "load point a", "load
 * point b": the middle of a plate, down; two opposite points of a cylinder, half-way between its ends, outwards; the
 * middles of the straight edges of a roof, down; on the equator of a hemisphere two points outwards (a) and, between
 * them, two points inwards (b); two opposite points of a sphere, outwards.
 */
std::vector<LoadPoint> shell_load_points(const ShellShape &shape);

/** How many of the whole shell's points a load point stands for. */
double shell_load_copies(const ShellShape &shape);
} // namespace pellicle

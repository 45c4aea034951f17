// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>

#include <vector>

namespace pellicle
{
/**
 * How the mesh follows the contact line over the material: node I of undeformed place X_I stands for the material point
 * X_I + s w_I nu_I, where s is the number of its leader, a node of the line.
 *
 * Each node with w_I > 0 is on the meridian plane of its leader; nu_I is the unit vector in that plane away from the
 * axis. All other nodes have w_I = 0, nu_I = 0 and lead themselves; so do the nodes of the line, with w_I = 1.
 */
struct LineShift
{
  std::vector<std::size_t> leader;
  NodalVectors direction; ///< nu
  std::vector<double> weight;
};

/**
 * The shift of a ridge (see ridge_mesh.h): a rigid translation near the line, where the fields are singular and a mesh
 * that is stretched would pin the line. w = w_r(r) w_z(z), each factor 1 up to a distance of 0.35 ring radii from the
 * line where there is room, and twice continuously differentiable down to 0 before the axis (in space: at the cells
 * around it that follow no meridian planes), the cells at the outer edge and the bottom. Where there is less room, the
 * rigid part gives way to the decay, down to a quarter of the room: Jacobians stay positive for s from -0.25 to 0.3
 * ring radii on substrates at least as thick as the ring's radius and twice as wide.
 */
LineShift line_shift(const SurfaceDiscretization &ridge);

/** The factor of a shift at a distance from the line, 0 from `reach` on. */
double shift_cutoff(double distance, double reach, double ring_radius);
} // namespace pellicle

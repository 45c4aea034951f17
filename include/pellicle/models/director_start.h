// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>

#include <string>
#include <vector>

namespace pellicle
{
/** Names of the start fields of directors. */
const std::vector<std::string> &director_start_names();

/**
 * Unit directors at the nodes of a surface with nodal normals n:
 *
 * | name         | O                                                                                       |
 * |--------------|-----------------------------------------------------------------------------------------|
 * | normal       | n                                                                                       |
 * | turned       | Q n, Q the rotation about z by `angle`                                                  |
 * | towards z    | n cos(angle s) + t sin(angle s), t s = (I - n n) e_z: on a sphere a mode l = 1           |
 * | meridional   | t, in the plane of the surface (e_z where that plane is horizontal)                      |
 * | azimuthal    | e_z x n/|e_z x n|, in the plane of the surface (n where that plane is horizontal)        |
 *
 * On a meridian only directors in its plane are possible. Throws UserError for a name that is not known, and for
 * others on a meridian.
 */
NodalVectors start_directors(const SurfaceDiscretization &surface, const std::string &name, double angle);

/** Adds to each component of each director a random number in [-amplitude, amplitude], as far as symmetry admits it,
 * and normalises. */
void add_director_noise(const SurfaceDiscretization &surface, double amplitude, int seed, NodalVectors &directors);
} // namespace pellicle

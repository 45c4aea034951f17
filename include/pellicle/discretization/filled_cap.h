// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>

namespace pellicle
{
/**
 * A drop on the plane z = 0: the spherical cap of cap() with its rim "rim", and the liquid below it as a body "liquid"
 * whose outer nodes are those of the cap. Faces of the body: "cap", "base" (whose nodes stay in the plane) and, where
 * it is described in the half plane, "axis".
 *
 * Inside, a block on the base is wrapped in shells of cells up to the cap: no cell is flattened at the rim, where a
 * single one has the contact angle, nor where the cap is smooth. 3 * 4^r quadrilaterals, revolved, or 16 * 8^r
 * hexahedra. The body's 2k Gauss points a direction integrate volume and its first moments exactly, so that no force
 * acts on inner nodes under uniform pressure and gravity.
 *
 * Throws UserError for an angle outside (0, pi), and for degrees below 1 or above 5 (hexahedra: 3).
 */
SurfaceDiscretization filled_cap(double angle, double area, unsigned int degree, unsigned int refinements, bool axial);
} // namespace pellicle

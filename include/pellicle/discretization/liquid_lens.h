// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>

namespace pellicle
{
/** A drop of liquid that floats on another one: two spherical caps and the flat surface outside, which meet in a
 * circle. */
struct LensShape
{
  double radius       = 1.;  ///< a, of the circle
  double upper_angle  = 0.5; ///< between the upper cap and the plane of the circle, inside the drop; radians in (0, pi)
  double lower_angle  = 0.5; ///< the same of the lower cap
  double outer_radius = 3.;  ///< of the flat surface's rim
};

/** Regions of a lens, in the order of their cells, and its lines. */
constexpr const char *lens_upper_region = "upper cap";
constexpr const char *lens_lower_region = "lower cap";
constexpr const char *lens_outer_region = "outer surface";
constexpr const char *lens_line         = "contact line";
constexpr const char *lens_rim          = "rim";

/**
 * Three surfaces that share the nodes of a circle in z = 0, about the z axis. Normals of both caps point out of the
 * drop, that of the flat surface is e_z. The line, a junction, has the upper cap on its left; the rim is where the
 * surface ends. A meridian runs from the pole to the line, on to the lower pole, and from the line to the rim. 2 * 2^r
 * cells from either pole to the line (see cap()), 4 * 2^r from there to the rim, graded so as to begin as large as the
 * cap's.
 *
 * No rigid motions: the rim is meant to be held. Throws UserError as cap() and annulus() do.
 */
SurfaceDiscretization liquid_lens(const LensShape &shape, unsigned int degree, unsigned int refinements, bool axial);
} // namespace pellicle

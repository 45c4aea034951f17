// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>

namespace pellicle
{
/** Size and shape of a discretized surface, by the quadrature of its own tables. */
struct SurfaceQuality
{
  double area            = 0.;
  double volume          = 0.; ///< integral of x.n/3; without meaning on an open surface
  double cell_area_ratio = 1.; ///< largest over smallest cell area
  /** Smallest over all points of J/(|a_1| |a_2|), the sine of the angle between the parameter lines: 1 is rectangular.
   */
  double min_cell_quality = 1.;
  double largest_aspect = 1.; ///< largest over all points of surfaces of max(|a_1|/|a_2|, |a_2|/|a_1|); 1 on a meridian
};

/** Of a surface with the given nodal positions. */
SurfaceQuality surface_quality(const SurfaceDiscretization &surface, const NodalVectors &positions);

/**
 * Throws UserError unless the start shape can be computed with: finite positions, positive volume if it is closed, J
 * well above zero at every quadrature point, and r > 0 between the poles of a meridian. `remedy` ends the message.
 */
void check_start_positions(const SurfaceDiscretization &surface, const std::string &remedy);

/** Squared distance of neighbouring nodes on the start shape, at every quadrature point: a cell's area over k^2, on a
 * meridian (length/k)^2. */
std::vector<double> squared_node_distances(const SurfaceDiscretization &surface);

/**
 * Euler characteristic vertices - edges + cells: 2 for a closed surface without handles, two less for every handle and
 * one less for every rim. A meridian stands for a surface without handles.
 */
int euler_characteristic(const SurfaceDiscretization &surface);
} // namespace pellicle

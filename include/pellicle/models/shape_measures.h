// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>

namespace pellicle
{
/**
 * Numbers that describe the shape of a closed surface, in powers of the unit of the positions. All are those of the
 * whole body, also where only a meridian or the upper half of one is there. The axis is the parallel to z through the
 * centroid of area.
 */
struct ShapeMeasures
{
  double area           = 0.;
  double volume         = 0.;
  double reduced_volume = 0.; ///< 3 V/(4 pi (A/4 pi)^(3/2)): 1 for a sphere

  double height            = 0.; ///< extent in z
  double equatorial_radius = 0.; ///< largest distance from the axis
  double axis_thickness    = 0.; ///< length of the axis inside the surface; nan where it only grazes the surface

  double min_cell_quality = 1.; ///< smallest J/(|a_1| |a_2|) at the quadrature points; 1 on a meridian
  double cell_area_ratio  = 1.; ///< largest over smallest cell area
  double gauss_bonnet     = 0.; ///< integral of K over 2 pi, cell by cell: 2 for a sphere, 0 for a torus

  Vector3<double> centroid; ///< of area
};

/**
 * Measures of a surface with the given nodal positions. Integrals are by the quadrature of the surface's tables;
 * height, radius and thickness are those of the piecewise polynomial surface, to round-off, not of its nodes.
 */
ShapeMeasures measure_shape(const SurfaceDiscretization &discretization, const NodalVectors &positions);
} // namespace pellicle

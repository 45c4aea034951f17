// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>

namespace pellicle
{
/**
 * A drop on a soft substrate, undeformed: the substrate fills z in [-thickness, 0], the drop is a spherical cap on the
 * circle (the ring) of radius `ring_radius` about the z axis in z = 0. Lengths are absolute.
 */
struct RidgeShape
{
  double ring_radius  = 1.;
  double cap_volume   = 1.;
  double half_width   = 2.;  ///< of the substrate: the cylinder's radius, or half the edge of the block's square
  double thickness    = 1.;  ///< of the substrate
  double cell_size    = .05; ///< h_min, of the substrate's cells at the ring
  double growth       = 1.5; ///< greatest factor between neighbours
  double coarsest     = .25; ///< greatest size of a cell over its distance from the ring, or over the ring's radius
  unsigned int degree = 2;   ///< of all cells
};

/**
 * The meridian of a ridge: quadrilaterals of degree 1 to 5 in the substrate. Upright lines are graded towards r =
 * ring_radius from both sides; the others are graded towards z = 0 below the contact line and fan out from there, so
 * that at the axis and at the outer edge the uppermost cell is as high as `coarsest`, or a quarter of the ring's
 * radius.
 *
 * Regions of the surface: "liquid gas", the cap from the pole to the ring; "solid liquid", from the ring to the axis,
 * n = -e_z, so that both together bound the liquid; "solid gas", from the ring to the side, n = e_z. The line
 * "contact line" is the end of the cap, a junction. The body "substrate" (see cylinder()) has the faces "side",
 * "bottom" and "top", whose nodes are those of the two solid regions. No rim, no rigid motion.
 *
 * Throws UserError unless 0 < ring_radius < half_width, volume and thickness are positive, and cell_size is between
 * 1e-6 and `coarsest` ring radii and no larger than half of what the substrate measures from the ring; for
 * growth outside [1.01, 3], coarsest outside [0.01, 0.5] and other degrees.
 */
SurfaceDiscretization axial_ridge(const RidgeShape &shape);

/** What else a ridge in space is made of. */
struct RidgePlanShape
{
  enum class Outline
  {
    block,   ///< square
    cylinder ///< circle
  };
  Outline outline       = Outline::block;
  unsigned int n_around = 16;    ///< cells around in the whole of the ring, everywhere; a multiple of 8
  bool half             = false; ///< only y >= 0, cut off by a plane of symmetry
};

/**
 * The same in space: hexahedra of degree 1 to 3. Seen from above, a core around the axis is wrapped in rings of cells
 * that are graded towards the contact line from both sides and become square, along meridian planes, towards the sides
 * of a block; all nodes outside the core are on the meridian planes of the contact line's nodes. The cap is the part
 * within the line with coarser rings, lifted. Nodes are exactly on the circles, the square and the sphere.
 *
 * Regions, line and body as in axial_ridge(); the line runs counterclockwise. Faces of a block: "left" and "right" (x),
 * "front" and "back" (y), and "side", all of these. With `half` the nodes in y = 0, which is no face, stay in that
 * plane; the line is open and runs from x > 0 to x < 0; all quadrature weights are doubled, so that integrals are those
 * of the whole. Throws UserError as axial_ridge() does, and for other numbers of cells around.
 */
SurfaceDiscretization ridge_in_space(const RidgeShape &shape, const RidgePlanShape &plan);

/** Polar angle of the rim of the spherical cap of the given volume on a circle: pi/2 for a hemisphere. */
double cap_angle(double volume, double ring_radius);
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/smooth_shape.h>
#include <pellicle/discretization/surface_discretization.h>

namespace pellicle
{
/**
 * Nodes on a smooth closed shape by way of the cube projected on the sphere: 6 * 4^r cells. Vertices are middles of
 * great circles, refinement after refinement; the other nodes of a cell are spherical means of its own vertices, so
 * that edges are great circles run through at constant speed. The interpolation error is then along the surface to
 * leading order, which curvature of order k needs (a map that is smooth over a whole face of the cube loses half an
 * order, for its normal errors do not cancel at the cube's edges).
 */
SurfaceDiscretization on_cube_sphere(const SmoothShape &shape, unsigned int degree, unsigned int refinements);

/** Meridian of an axisymmetric shape: 4 * 2^r cells of equal polar angle of the sphere, from pole to pole; with
 * `mirror` 2 * 2^r, from the north pole to z = 0. */
SurfaceDiscretization on_meridian(const SmoothShape &shape, unsigned int degree, unsigned int refinements, bool mirror);

/** Torus about z of area 4 pi^2 R r: 4 * 2^r cells round the tube, and as many the long way as make them about square.
 * Throws UserError unless R/r > 1. */
SurfaceDiscretization torus(double ratio, double area, unsigned int degree, unsigned int refinements);

/** Facets of a Gmsh file, oriented, rounded, each cut into 4^r cells, scaled so that the rounded surface has the given
 * area. */
SurfaceDiscretization from_file(const std::string &file, double area, unsigned int degree, unsigned int refinements);
} // namespace pellicle

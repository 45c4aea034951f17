// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/refinement.h>
#include <pellicle/discretization/smooth_shape.h>
#include <pellicle/discretization/surface_discretization.h>

namespace pellicle
{
// Numbers of cells are those of uniform refinement, r times.

/**
 * Nodes on a smooth closed shape by way of the cube projected on the sphere: 6 * 4^r cells. Vertices are middles of
 * great circles, refinement after refinement; the other nodes of a cell are spherical means of its own vertices, so
 * that edges are great circles run through at constant speed. The interpolation error is then along the surface to
 * leading order, which curvature of order k needs (a map that is smooth over a whole face of the cube loses half an
 * order, for its normal errors do not cancel at the cube's edges).
 */
SurfaceDiscretization on_cube_sphere(const SmoothShape &shape, unsigned int degree, const Refinement &refinement);

/** Meridian of an axisymmetric shape: 4 * 2^r cells of equal polar angle of the sphere, from pole to pole; with
 * `mirror` 2 * 2^r, from the north pole to z = 0. */
SurfaceDiscretization on_meridian(const SmoothShape &shape, unsigned int degree, const Refinement &refinement,
                                  bool mirror);

/** Torus about z of area 4 pi^2 R r: 4 * 2^r cells round the tube, and as many the long way as make them about square.
 * Throws UserError unless R/r > 1. */
SurfaceDiscretization torus(double ratio, double area, unsigned int degree, const Refinement &refinement);

/**
 * Spherical cap of the given area, pole up, rim in z = 0 and named "rim"; `angle` is the polar angle of the rim, in (0,
 * pi). n points away from the sphere's centre. 12 * 4^r cells, 2 * 2^r from pole to rim (see BalancedDisc); as many on
 * a meridian. Throws UserError for an angle outside the range.
 *
 * With `growth` > 0 cells are smaller towards the rim: their size grows with the polar distance from it as
 * 1 + growth (distance in radians).
 */
SurfaceDiscretization cap(double angle, double area, unsigned int degree, const Refinement &refinement, bool axial,
                          double growth = 0.);

/** The limit of a cap for angle 0: flat disc in z = 0, n = e_z. */
SurfaceDiscretization disc(double area, unsigned int degree, const Refinement &refinement, bool axial);

/**
 * Circular cylinder about z, centred on the origin, n radially outward; `ratio` is length over radius. Rims: "upper
 * rim", "lower rim". Meridian: 2 * 2^r cells from the top down; surface: at least 4 * 2^r around and about square.
 * Throws UserError unless 1e-3 < ratio < 1e3.
 */
SurfaceDiscretization tube(double ratio, double area, unsigned int degree, const Refinement &refinement, bool axial);

/** Flat ring in z = 0, and the cells on it. Lengths are absolute. */
struct AnnulusShape
{
  double inner_radius   = 0.;
  double outer_radius   = 0.;
  double smallest       = 0.; ///< size of the cells at the inner rim on the mesh as refined; 0: not graded
  double smallest_outer = 0.; ///< the same at the outer rim
  unsigned int n_radial = 8;  ///< cells between the rims on the coarsest mesh, at least 4
  unsigned int n_around = 8;  ///< cells around on the coarsest mesh, at least 8
};

/**
 * Annulus with n = e_z and rims "tip" (inner) and "ring" (outer). n_radial * 2^r cells between the rims, their sizes in
 * geometric progression; a meridian runs from tip to ring. Throws UserError for radii out of order, too few cells, and
 * smallest cells that are larger than equal ones or ask for neighbours that differ by more than a factor of 3.
 */
SurfaceDiscretization annulus(const AnnulusShape &ring, unsigned int degree, const Refinement &refinement, bool axial);

/** Flat disc about the origin with two circular holes, centred on (distance/2, 0) and (-distance/2, 0). */
struct DiscWithTwoHoles
{
  double hole_radius  = 0.;
  double distance     = 0.; ///< of the centres of the holes
  double outer_radius = 0.;
  double smallest     = 0.; ///< size of the cells at the holes on the mesh as refined, if rays are long; 0: not graded
};

/**
 * Disc with n = e_z and rims "right hole", "left hole" and "ring". Cells lie on straight rays from the holes to the rim
 * or to the line x = 0; both halves have 6 * 2^r cells along a ray and 16 * 2^r around the hole. Throws UserError for
 * holes that touch each other or the rim.
 */
SurfaceDiscretization disc_with_two_holes(const DiscWithTwoHoles &disc, unsigned int degree,
                                          const Refinement &refinement);

/**
 * A closed shape whose part around the north pole of the sphere that it is a map of, z > 0, is region "domain" with the
 * given fraction of the (smooth) shape's area, and the rest "membrane". The line between, "domain boundary", is made of
 * edges of cells and has the domain on its left.
 *
 * Meridian: 4 * 2^r cells, at least 2^r on either side of the line. Surface: a disc of 12 cells (see BalancedDisc)
 * around either pole, and as many rings of 8 cells between them as make cells about square, each refined to 4^r.
 * Throws UserError unless 0 < area_fraction < 1.
 */
SurfaceDiscretization with_polar_region(const SmoothShape &shape, double area_fraction, unsigned int degree,
                                        const Refinement &refinement, bool axial);

/** Facets of a Gmsh file, oriented, rounded, each cut into 4^r cells, scaled so that the rounded surface has the given
 * area. */
SurfaceDiscretization from_file(const std::string &file, double area, unsigned int degree,
                                const Refinement &refinement);
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>

#include <string>
#include <vector>

namespace pellicle
{
/**
 * Ends of n cells on [from, to]: n + 1 ascending numbers. Sizes grow geometrically from `first` at the beginning and
 * from `last` at the end; 0: no grading there (both 0: equal cells). Throws UserError for sizes larger than equal
 * cells.
 */
std::vector<double> cell_ends(double from, double to, unsigned int n_cells, double first = 0., double last = 0.);

/** Ends of the cells in the three directions, ascending; see cell_ends(). */
struct BlockShape
{
  std::vector<double> x, y, z;
};

/**
 * Rectangular block of hexahedra of degree 1 to 3. The surface is its top face, n = e_z, with the rim "rim"; the body
 * has the faces "left" and "right" (x), "front" and "back" (y), "bottom" and "top" (z). Throws UserError for ends that
 * do not ascend and for other degrees.
 */
SurfaceDiscretization block(const std::string &name, const BlockShape &shape, unsigned int degree);

/** Ends of the cells along r >= 0 and z, ascending. */
struct CylinderShape
{
  std::vector<double> r, z;
};

/**
 * Circular cylinder about z, of quadrilaterals of degree 1 to 5 in the half plane (first coordinate upwards, second
 * outwards), hollow if r begins above 0. The surface is the meridian of its top face, n = e_z, outwards from the axis,
 * with the rim "rim" (and "inner rim"); the body has the faces "side" (and "inner side"), "bottom" and "top". Throws
 * UserError as block() does.
 */
SurfaceDiscretization cylinder(const std::string &name, const CylinderShape &shape, unsigned int degree);

/** Takes the unit vector `normal` from the directions in which a node may move: a plane of symmetry, a wall along which
 * it slides. */
void keep_on_plane(SurfaceDiscretization &discretization, std::size_t node, const Vector3<double> &normal);
void keep_on_plane(SurfaceDiscretization &discretization, const std::vector<std::size_t> &nodes,
                   const Vector3<double> &normal);

/**
 * Gives every cell of a body its own polynomials of total degree k - 1 for a pressure, Legendre products in the
 * coordinates of the cell. With positions of degree k >= 2 the pair Q_k/P_{k-1} is inf-sup stable (Stenberg 1984;
 * Boffi & Gastaldi 2002), and volume is kept cell by cell.
 */
void add_pressure_nodes(SurfaceDiscretization &discretization, std::size_t body);
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>

#include <functional>

namespace pellicle
{
/** Node i of a side of a cell, in the direction that has the cell on its left. */
std::size_t side_node(const SurfaceDiscretization &surface, const CellSide &side, std::size_t i);

/** A circle about the z axis, at the first or last node of a cell of a meridian; the surface (the region) is the cell's
 * side of it. */
EdgeLoop circle_loop(const SurfaceDiscretization &meridian, const std::string &name, std::size_t cell,
                     bool at_end_of_cell, bool is_rim);

/**
 * The lines at which a surface of quadrilaterals ends, each in the direction that has the surface on its left, named by
 * the caller from their first node's position. They begin at the first of their cells.
 */
std::vector<EdgeLoop> find_rims(const SurfaceDiscretization &surface,
                                const std::function<std::string(const Vector3<double> &)> &name);

/** The lines around the region of the given number (see cell_region) where other cells continue it; is_rim = false. A
 * line that ends on a mirror plane is not closed: it begins at its first node. */
std::vector<EdgeLoop> find_region_boundary(const SurfaceDiscretization &surface, unsigned int region,
                                           const std::string &name);

/** Whether a node lies on a line, for all nodes. */
std::vector<bool> nodes_of_edges(const SurfaceDiscretization &surface);

/** Length of the line, 2 pi r on a meridian. */
double loop_length(const EdgeLoop &loop, const NodalVectors &positions);

/** |x,1| at the quadrature points of a line, edge after edge: length per unit of the parameter. */
std::vector<double> line_elements(const EdgeLoop &loop, const NodalVectors &positions);

/**
 * Outward unit conormals nu = t x n of the surface (the region) on the left of a line, at its quadrature points:
 * result[c * loop.tables.n_points + q] at point q of edge c. Tangent t and normal n are those of the cell on the left,
 * so that nu is in the plane of that cell; nu = x_,1/|x_,1| at the end of a meridian, minus that at its beginning.
 *
 * Of a start shape they are off by O(h^k). As data of a clamp, exact conormals of the smooth shape are better where
 * they are known: with these ones the mean curvature of a cap loses half an order in the cells at the rim.
 */
std::vector<Vector3<double>> conormals(const SurfaceDiscretization &surface, const EdgeLoop &loop,
                                       const NodalVectors &positions);
} // namespace pellicle

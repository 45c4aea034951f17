// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>

#include <vector>

namespace pellicle
{
/**
 * Curvatures at the nodes of a surface of degree k: continuous functions of degree k, computed without second
 * derivatives across cells.
 *
 * The vector h = -2 H n (H the mean curvature of the conventions, -1/R on a sphere, so that h = (2/R) n there) solves
 *
 *     integral of h . y dA = integral of a^ab x_,a . y_,b dA   for all y of degree k,
 *
 * which is the surface Laplacian of the position, integrated by parts (G. Dziuk, Numer. Math. 58, 603-611, 1991). It
 * sees the kinks between cells; its error is of order k in L2.
 */
struct NodalCurvature
{
  NodalVectors curvature_vector;    ///< h at the nodes, 1/length
  std::vector<double> mean_outward; ///< projection of h . n/2, n the cells' normal: half the trace, +1/R on a sphere
  std::vector<double> gauss;        ///< projection of the K of every cell by itself, 1/length^2; of order k - 1
};

/** Of a surface with the given nodal positions. On a meridian h respects the poles (radial part 0) and the mirror plane
 * (axial part 0). */
NodalCurvature nodal_curvature(const SurfaceDiscretization &discretization, const NodalVectors &positions);

/** Integral of h . n/2 over the surface, n the cells' own normal: 4 pi R on a sphere. */
double integrated_mean_curvature(const SurfaceDiscretization &discretization, const NodalVectors &positions,
                                 const NodalVectors &curvature_vector);
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/nodal_conditions.h>

namespace pellicle
{
/**
 * Unit directions d_I transversal to a surface: its normals n_I far from the lines that stay on bodies, and at such a
 * line the direction m across it and along the body. Between, d = n + b, b the solution of
 *
 *     - l^2 Laplace b + b = 0,    b = m - n on the line,
 *
 * with l a fraction of the surface's size.
 *
 * Why not the normals everywhere: the line's nodes move, and are tested, along m, which has a tangential part. If only
 * they had, that part would fall to zero within one cell, and the solution of the dual problem (on which quantities
 * like the contact radius depend) would be approximated to first order there: the contact radius converges at order k
 * + 1. With a smooth field of directions it converges at order 2k.
 */
NodalVectors directions_towards_bodies(const FieldConditions &conditions, const SurfaceDiscretization &discretization,
                                       const NodalVectors &positions, const NodalVectors &normals);
} // namespace pellicle

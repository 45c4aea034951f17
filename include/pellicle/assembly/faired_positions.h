// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>

namespace pellicle
{
/**
 * Nodal positions without what is rough in them: two implicit steps of diffusion over the reference surface,
 *
 *     (M + tau D) x_new = M x,    tau = A/n (on a meridian A/n^2), A the area of the reference,
 *
 * n the number of nodes, M the lumped mass and D the Dirichlet form of the reference (dirichlet_forms()), component by
 * component. Displacements that alternate from node to node shrink to 1/100 and less, shapes of the size of the surface
 * by tau l(l + 1)/R^2 each time, a few per cent. A start shape need not be kept more exactly than that: this is for
 * starts that Newton's method finds no way from.
 *
 * @param reference nodal positions of a well-spread surface with the same cells.
 */
NodalVectors faired_positions(const SurfaceDiscretization &discretization, const NodalVectors &reference,
                              const NodalVectors &positions);
} // namespace pellicle

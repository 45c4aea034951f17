// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/bordered_system.h>

namespace pellicle
{
/**
 * L2 mass of displacements in a chart, u^T M u = integral of |sum_I N_I Z_I u_I|^2 dA, for the unknowns of the position
 * (field 0); rows of all other unknowns are zero. Symmetric, lower triangle, of the size of the whole numbering;
 * complete on every process.
 */
SparseMatrix position_mass(const SurfaceDiscretization &discretization, const NodalVectors &positions,
                           const Numbering &numbering);
} // namespace pellicle

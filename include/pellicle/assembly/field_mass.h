// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/bordered_system.h>

namespace pellicle
{
/**
 * L2 mass of changes of a field in a chart, u^T M u = integral of |sum_I N_I Z_I u_I|^2 dA, Z with the shares of
 * nodes that are carried, for its own unknowns; rows
 * of all other unknowns are zero. Symmetric, lower triangle, of the size of the whole numbering; complete on every
 * process.
 */
SparseMatrix field_mass(const SurfaceDiscretization &discretization, const NodalVectors &positions,
                        const Numbering &numbering, std::size_t field);
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>

#include <Eigen/SparseCore>

#include <array>
#include <functional>
#include <vector>

namespace pellicle
{
/**
 * Entries of the Dirichlet form of each of the three components of a displacement v of the nodes,
 *
 *     integral of A^ab v,a v,b dA,
 *
 * A the metric of the given positions; entries at the same place add up. On a meridian the component along r gains
 * v^2/r^2, the derivative along phi. Cells without a node that `counts` are left out.
 */
std::array<std::vector<Eigen::Triplet<double>>, 3> dirichlet_forms(const SurfaceDiscretization &discretization,
                                                                   const NodalVectors &positions,
                                                                   const std::function<bool(std::size_t node)> &counts);
} // namespace pellicle

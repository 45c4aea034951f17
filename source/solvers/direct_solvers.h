// SPDX-License-Identifier: LGPL-2.1-or-later
// What the factory of linear_solver.cc knows of the two direct solvers.
#pragma once

#include <pellicle/solvers/linear_solver.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace pellicle::internal
{
/** Throws std::logic_error unless MPI is initialised. */
std::unique_ptr<LinearSolver> make_mumps_solver();

std::unique_ptr<LinearSolver> make_umfpack_solver();

/**
 * A pivot smaller than this times the matrix (scaled to entries of order one) counts as zero. Round-off of size eps in
 * an eigenvalue whose eigenvector is spread over all n unknowns shows as n eps in the last pivot; on singular
 * Laplacians less than a thirtieth of that was measured.
 */
inline double null_pivot_threshold(const int n)
{
  return std::max(1e-14, 0.1 * n * std::numeric_limits<double>::epsilon());
}

/** Whether all values are finite numbers. A factorisation does not say so itself: it returns nonsense. */
inline bool all_finite(const SparseMatrix &matrix)
{
  return std::all_of(matrix.values.begin(), matrix.values.end(), [](const double v) { return std::isfinite(v); });
}

constexpr auto not_finite_message = "The matrix of the linear system has entries that are not finite numbers: the "
                                    "state or a parameter it was assembled from is out of range.";

constexpr auto usual_cause = "The usual cause is a free motion or a redundant constraint.";
} // namespace pellicle::internal

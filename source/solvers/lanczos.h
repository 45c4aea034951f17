// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <vector>

namespace pellicle::internal
{
/** The operator A^-1 M, symmetric in the inner product of M. */
struct LanczosOperator
{
  int size           = 0;
  int n_eigenvectors = 0;                                          ///< upper bound of its rank
  std::function<void(const double *x, double *result)> mass;       ///< M x
  std::function<void(std::vector<double> &right_hand_side)> solve; ///< replaces b by A^-1 b
};

struct LanczosResult
{
  bool converged = false;
  std::vector<double> values;               ///< approximate eigenvalues, descending, at least the n largest
  std::vector<std::vector<double>> vectors; ///< of the n largest, if converged; M-normalised
};

/**
 * The n largest eigenvalues of A^-1 M, all expected positive, and their vectors, by Lanczos' method with implicit
 * restarts. The start vector is always the same. Throws SolveError when the operator has fewer than n + 1 eigenvectors
 * with mass.
 */
LanczosResult lanczos(const LanczosOperator &map, int n, int max_restarts);
} // namespace pellicle::internal

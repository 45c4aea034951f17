// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/communicator.h>
#include <pellicle/base/sparse_matrix.h>

#include <vector>

namespace pellicle::internal
{
/**
 * The matrices K - s M for varying s, in one pattern, so that they are analysed once. K is distributed (the sum over
 * the processes counts), M complete on every process: the first process subtracts it.
 */
class ShiftedPencil
{
public:
  ShiftedPencil(const SparseMatrix &K, const SparseMatrix &M);

  /** This process's share of K - shift M; valid until the next call. */
  const SparseMatrix &at(double shift);

  int size() const { return M.size; }
  /** Rows of M that are not zero: no pencil has more finite eigenvalues. */
  int n_massive() const;
  /** result = M x, both of full length. */
  void apply_mass(const double *x, double *result) const;
  /** Residual of an eigenpair, relative as documented at eigenpair_tolerance. Collective. */
  double relative_residual(double value, const std::vector<double> &vector) const;

private:
  const SparseMatrix &K, &M;
  Communicator communicator;
  SparseMatrix shifted;
  std::vector<double> stiffness, mass; ///< this process's share of either, in the pattern of `shifted`
};
} // namespace pellicle::internal

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/sparse_matrix.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pellicle
{
/** Signs of the pivots of a symmetric factorisation: by Sylvester's law the signs of the eigenvalues. */
struct Inertia
{
  int positive = 0;
  int negative = 0;
  int zero     = 0;
};

/** How near to singular a factorised matrix is. */
struct Conditioning
{
  /** mumps: of the componentwise condition number | |A^-1| (|A| |x| + |b|) | / |x|, maximum norm, for x = (1, ..., 1)
   * and b = A x (Arioli, Demmel and Duff, SIAM J. Matrix Anal. Appl. 10, 1989): relative errors of entries grow by at
   * most so much. It does not depend on the scaling of the rows. umfpack: the largest over the smallest pivot. */
  double condition_estimate = 0.;
  double smallest_pivot     = 0.; ///< absolute values, of the matrix as the solver scales it (entries of order one)
  double largest_pivot      = 0.;
};

/**
 * Direct solver for sparse systems. The symbolic analysis is made at the first factorisation and kept while the pattern
 * stays the same (same size, same number of entries, same row_start and columns); a new pattern is analysed anew.
 */
class LinearSolver
{
public:
  virtual ~LinearSolver() = default;

  /** Factorises the matrix (with several processes: the sum of all processes' matrices). Throws SolveError when it is
   * singular to working precision or memory runs out; the message names the cause in the solver's terms. */
  virtual void factorize(const SparseMatrix &matrix) = 0;

  /** Replaces the right-hand side (complete and equal on every process) by the solution (complete on every process). */
  virtual void solve(std::vector<double> &right_hand_side) const = 0;

  /** Signs of the pivots, where the solver knows them (LDL^T of a symmetric matrix). */
  virtual std::optional<Inertia> inertia() const = 0;

  /** Of the last factorisation, that of the given matrix, at the price of a few solutions; none where the solver cannot
   * tell. */
  virtual std::optional<Conditioning> conditioning(const SparseMatrix & /*matrix*/) const { return std::nullopt; }

  virtual std::string name() const = 0;
};

/** Names of the solvers: "mumps", "umfpack". */
const std::vector<std::string> &linear_solver_names();

/** Throws UserError for an unknown name (with near matches) and for UMFPACK with more than one MPI process. */
std::unique_ptr<LinearSolver> make_linear_solver(const std::string &name);

/** Threads of the BLAS that the factorisation uses (OpenBLAS: at run time; another BLAS: no effect). Returns whether it
 * could be set. */
bool set_blas_threads(int n);
} // namespace pellicle

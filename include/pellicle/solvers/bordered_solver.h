// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/communicator.h>
#include <pellicle/solvers/linear_solver.h>

#include <optional>
#include <string>
#include <vector>

namespace pellicle
{
/** One more column and row around a square matrix K: [K, column; row^T, corner]. Complete on every process. */
struct Border
{
  std::vector<double> column, row;
  double corner = 0.;
};

/**
 * Solves bordered systems with the factors of the inner matrix alone, which keeps its sparsity, symmetry and inertia:
 *
 *     [K    b] [x]   [f]      K v = b,  K y = f,
 *     [c^T  d] [q] = [g]      q = (g - c.y)/(d - c.v),  x = y - q v.
 *
 * The bordered matrix is regular at a fold, K is not, and nearby the elimination loses as many digits as K has lost.
 * One refinement with the true residual brings them back (Govaerts and Pryce, "Block elimination with one refinement
 * solves bordered linear systems accurately", BIT 30, 1990). K itself must be factorised: SolveError exactly at the
 * fold.
 */
class BorderedSolver : public LinearSolver
{
public:
  /** Keeps references to both; the border may change between factorisations. */
  BorderedSolver(LinearSolver &inner, const Border &border);

  /** Takes the inner matrix K, of which it keeps a reference until the next call. */
  void factorize(const SparseMatrix &matrix) override;
  /** (f, g) in, (x, q) out: one entry longer than K. */
  void solve(std::vector<double> &right_hand_side) const override;
  /** Of the inner matrix. */
  std::optional<Inertia> inertia() const override;
  std::string name() const override;

private:
  void eliminate(std::vector<double> &right_hand_side) const;

  LinearSolver &inner;
  const Border &border;
  const SparseMatrix *matrix = nullptr;
  std::vector<double> inner_column; ///< K^-1 b
  Communicator communicator;
};
} // namespace pellicle

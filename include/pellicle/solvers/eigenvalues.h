// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/sparse_matrix.h>
#include <pellicle/solvers/linear_solver.h>

#include <vector>

namespace pellicle
{
struct Eigenpairs
{
  std::vector<double> values;               ///< ascending, multiple ones as often as they occur; unit of K over M
  std::vector<std::vector<double>> vectors; ///< [i][unknown] of full length, u_i . M u_j = delta_ij, sign arbitrary

  int n_factorizations = 0; ///< what the computation cost
  int n_solves         = 0;
};

/** Largest relative residual of an eigenpair: |K u - mu M u| over | |K| |u| + |mu| |M| |u| |, Euclidean norms of the
 * vectors of entrywise absolute values; with several processes |K| is the sum of the processes' |K|. */
constexpr double eigenpair_tolerance = 1e-10;

/**
 * The n algebraically lowest finite eigenvalues of K u = mu M u with eigenvectors. Unknowns without mass (internal
 * fields, multipliers, gauge rows) have no dynamics of their own: their rows are constraints, so that mu are the
 * eigenvalues of the second variation with internal fields eliminated, on the subspace that the border leaves. A border
 * row with -1/c on the diagonal is a penalty c instead, and its direction has an eigenvalue of its own.
 *
 * Lanczos' method on (K - s M)^-1 M in the inner product of M (Ericsson, Ruhe: The spectral transformation Lanczos
 * method, Math. Comp. 35 (1980) 1251; restarts by ARPACK). Sylvester's law says for any s how many eigenvalues lie
 * below it: negative pivots of K - s M, less n_expected_negative. The shift starts at -scale and goes down until none
 * does. At the end the number below the largest eigenvalue found (by a millionth of its distance from s, more if
 * eigenvalues crowd there) is compared with what was found; if a copy of a multiple eigenvalue is missing, it is
 * searched for in the complement of the others. Zero eigenvalues of K (rigid motions) need no care.
 * The cost is one factorisation more than it takes to find the shift, and some 2 n + 20 solves.
 *
 * Every process calls it and gets the same result.
 *
 * @param K       symmetric; with several processes the sum of all processes' matrices
 * @param M       symmetric positive semi-definite of the same size, complete and equal on every process
 * @param solver  must know the inertia of symmetric matrices; it is left with a factorisation of some K - s M
 * @param n_expected_negative  negative eigenvalues that internal fields, constraints and gauge rows contribute
 * @param n       at least 1, less than the number of finite eigenvalues
 * @param scale   positive: size expected of the lowest eigenvalues. A bad guess costs factorisations, not accuracy.
 *
 * Throws SolveError if the solver has no inertia, if K - s M is singular for every shift tried, if the count of
 * negative eigenvalues never comes down to n_expected_negative or lies below it, if Lanczos' method does not converge,
 * if fewer than n eigenvalues exist, and if an eigenpair's residual exceeds eigenpair_tolerance.
 */
Eigenpairs lowest_eigenpairs(const SparseMatrix &K, const SparseMatrix &M, LinearSolver &solver,
                             int n_expected_negative, unsigned int n, double scale);
} // namespace pellicle

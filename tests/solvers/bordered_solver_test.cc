// SPDX-License-Identifier: LGPL-2.1-or-later
// Bordered systems, with one MPI process and (second ctest entry) with two.
#include "synthetic_matrices.h"

#include <pellicle/solvers/bordered_solver.h>

#include "../mpi_environment.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace pellicle;
using namespace pellicle::synthetic;

/** Fills right-hand side and solution of a bordered system; matrix: complete. */
void expect_solves(LinearSolver &inner, const SparseMatrix &matrix, const SparseMatrix &share, const Border &border,
                   const double tolerance)
{
  const int n                        = matrix.size;
  const std::vector<double> solution = random_vector(n + 1, 5);
  const std::vector<double> state(solution.begin(), solution.end() - 1);
  std::vector<double> right_hand_side = product(matrix, state);
  double last                         = border.corner * solution[n];
  for (int i = 0; i < n; ++i)
  {
    right_hand_side[i] += border.column[i] * solution[n];
    last += border.row[i] * solution[i];
  }
  right_hand_side.push_back(last);

  BorderedSolver solver(inner, border);
  solver.factorize(share);
  EXPECT_EQ(solver.inertia().has_value(), inner.inertia().has_value());
  solver.solve(right_hand_side);
  for (int i = 0; i <= n; ++i)
    ASSERT_NEAR(right_hand_side[i], solution[i], tolerance) << "unknown " << i;
}

std::vector<std::string> solvers_for_this_run()
{
  int n_processes = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &n_processes);
  return n_processes == 1 ? linear_solver_names() : std::vector<std::string>{"mumps"};
}

TEST(BorderedSolver, SolvesWithBorderOfAnyKind)
{
  int rank = 0, n_processes = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &n_processes);
  const SparseMatrix matrix = saddle_matrix(3, 2), share = saddle_matrix(3, 2, 1, rank, n_processes);
  const Border border{random_vector(matrix.size, 2), random_vector(matrix.size, 3), 0.7};
  for (const std::string &name : solvers_for_this_run())
    expect_solves(*make_linear_solver(name), matrix, share, border, 1e-10);
}

// H D H with a reflection H = 1 - 2 q q^T: eigenvalues D, the first of which is nearly zero. Elimination alone loses
// eight to ten digits.
TEST(BorderedSolver, IsAccurateNextToAFold)
{
  const int n           = 30;
  std::vector<double> q = random_vector(n, 7);
  double length         = 0.;
  for (const double qi : q)
    length += qi * qi;
  for (double &qi : q)
    qi /= std::sqrt(length);
  int rank = 0, n_processes = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &n_processes);
  for (const double small : {1e-8, -1e-10})
    for (const MatrixSymmetry symmetry : {MatrixSymmetry::symmetric, MatrixSymmetry::general})
    {
      MatrixBuilder whole(symmetry, n), share(symmetry, n);
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
        {
          double entry = 0.;
          for (int k = 0; k < n; ++k)
            entry += ((i == k) - 2. * q[i] * q[k]) * (k == 0 ? small : 1. + k) * ((k == j) - 2. * q[k] * q[j]);
          whole.add(i, j, entry);
          share.add(i, j, (i + j) % n_processes == rank ? entry : 0.);
        }
      const Border border{random_vector(n, 2), random_vector(n, 3), 0.1};
      for (const std::string &name : solvers_for_this_run())
        expect_solves(*make_linear_solver(name), whole.matrix(), share.matrix(), border, 1e-11);
    }
}
} // namespace

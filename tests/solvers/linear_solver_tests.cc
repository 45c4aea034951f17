// SPDX-License-Identifier: LGPL-2.1-or-later
// The direct solvers, with one MPI process and (second ctest entry) with two.
#include <pellicle/base/exceptions.h>
#include <pellicle/solvers/linear_solver.h>

#include "expect_user_error.h"
#include "synthetic_matrices.h"

#include <gtest/gtest.h>
#include <mpi.h>

#include <cmath>
#include <limits>

using namespace pellicle;
using namespace pellicle::synthetic;

namespace
{
std::string message_before_mpi_init;

int mpi_rank()
{
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}
int mpi_size()
{
  int size = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  return size;
}

/** This process's share of a matrix: diagonal entries are sums of equal parts of all processes, the others belong to
 * one process each. */
SparseMatrix share(const SparseMatrix &matrix)
{
  MatrixBuilder builder(matrix.symmetry, matrix.size);
  for (int i = 0; i < matrix.size; ++i)
    for (int k = matrix.row_start[i]; k < matrix.row_start[i + 1]; ++k)
      if (const int j = matrix.columns[k]; i == j)
        builder.add(i, j, matrix.values[k] / mpi_size());
      else if ((i + j) % mpi_size() == mpi_rank())
        builder.add(i, j, matrix.values[k]);
  return builder.matrix();
}

std::vector<std::string> solvers_for_this_run()
{
  return mpi_size() == 1 ? linear_solver_names() : std::vector<std::string>{"mumps"};
}

void expect_near(const std::vector<double> &a, const std::vector<double> &b, const double tolerance)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    ASSERT_NEAR(a[i], b[i], tolerance) << "unknown " << i;
}

/** Factorises the sum of the shares and checks the solution of a system whose solution is known. */
void expect_solves(LinearSolver &solver, const SparseMatrix &matrix, const double tolerance = 1e-10)
{
  const std::vector<double> solution = random_vector(matrix.size, 11);
  std::vector<double> x              = product(matrix, solution);
  solver.factorize(share(matrix));
  solver.solve(x);
  expect_near(x, solution, tolerance);
}

/** The message of the SolveError that factorize() throws, empty if it does not. */
std::string failure(LinearSolver &solver, const SparseMatrix &matrix)
{
  try
  {
    solver.factorize(share(matrix));
  }
  catch (const SolveError &error)
  {
    return error.what();
  }
  return "";
}

/** About `per_row` random entries a row beside a cycle and a diagonal of random sign with some zeros on it. */
SparseMatrix random_matrix(const MatrixSymmetry symmetry, const int size, const int per_row)
{
  std::mt19937 generator(5);
  std::uniform_int_distribution<int> index(0, size - 1);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  MatrixBuilder builder(symmetry, size);
  for (int i = 0; i < size; ++i)
  {
    builder.add(i, i, i % 5 == 0 ? 0. : 4. * uniform(generator));
    for (int k = 0; k < per_row; ++k)
    {
      const int j              = k == 0 ? (i + 1) % size : index(generator);
      const bool in_lower_half = symmetry == MatrixSymmetry::general || j <= i;
      builder.add(in_lower_half ? i : j, in_lower_half ? j : i, uniform(generator));
    }
  }
  return builder.matrix();
}

/** Graph Laplacian of a grid with random weights, plus `shift` on the diagonal: constants are its kernel when the shift
 * is 0. */
SparseMatrix laplacian(const int side, const double shift)
{
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> weight(0.5, 1.5);
  MatrixBuilder builder(MatrixSymmetry::symmetric, side * side);
  const auto connect = [&](const int i, const int j)
  {
    const double w = weight(generator);
    builder.add(i, i, w);
    builder.add(j, j, w);
    builder.add(j, i, -w);
  };
  for (int i = 0; i < side * side; ++i)
  {
    builder.add(i, i, shift);
    if (i % side + 1 < side)
      connect(i, i + 1);
    if (i + side < side * side)
      connect(i, i + side);
  }
  return builder.matrix();
}

/** L D L^T with a sparse random unit lower triangle: as many eigenvalues of either sign as D has entries. */
SparseMatrix congruent_to(const std::vector<double> &d)
{
  const int n = int(d.size());
  std::mt19937 generator(9);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  std::vector<std::vector<double>> lower(n, std::vector<double>(n, 0.));
  for (int i = 0; i < n; ++i)
  {
    lower[i][i] = 1.;
    for (int k = 0; k < 3 && i > 0; ++k)
      lower[i][std::uniform_int_distribution<int>(0, i - 1)(generator)] = uniform(generator);
  }
  MatrixBuilder builder(MatrixSymmetry::symmetric, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j <= i; ++j)
      for (int k = 0; k <= j; ++k)
        if (const double value = lower[i][k] * d[k] * lower[j][k]; value != 0.)
          builder.add(i, j, value);
  return builder.matrix();
}
} // namespace

// Random matrices are badly conditioned (up to 1e6 here), hence the wide tolerance of two tests.
TEST(LinearSolver, SolvesRandomSymmetricIndefiniteSystems)
{
  for (const std::string &name : solvers_for_this_run())
    expect_solves(*make_linear_solver(name), random_matrix(MatrixSymmetry::symmetric, 500, 3), 1e-8);
}

TEST(LinearSolver, SolvesRandomUnsymmetricSystems)
{
  for (const std::string &name : solvers_for_this_run())
    expect_solves(*make_linear_solver(name), random_matrix(MatrixSymmetry::general, 500, 4), 1e-8);
}

TEST(LinearSolver, SolvesBorderedSaddlePointSystems)
{
  const SparseMatrix matrix = saddle_matrix(6, 8);
  for (const std::string &name : solvers_for_this_run())
    expect_solves(*make_linear_solver(name), matrix, 1e-11);
}

TEST(LinearSolver, AddsTheContributionsOfAllProcesses)
{
  const SparseMatrix own = saddle_matrix(4, 3, 1, mpi_rank(), mpi_size()), whole = saddle_matrix(4, 3);
  const std::vector<double> solution = random_vector(whole.size, 2);
  std::vector<double> x              = product(whole, solution);
  const auto solver                  = make_linear_solver("mumps");
  solver->factorize(own);
  solver->solve(x);
  expect_near(x, solution, 1e-11);
}

TEST(LinearSolver, AProcessMayContributeNothing)
{
  const SparseMatrix whole = saddle_matrix(2, 1);
  MatrixBuilder nothing(whole.symmetry, whole.size);
  std::vector<double> x = product(whole, random_vector(whole.size, 2));
  const auto solver     = make_linear_solver("mumps");
  solver->factorize(mpi_rank() == mpi_size() - 1 ? whole : nothing.matrix());
  solver->solve(x);
  expect_near(x, random_vector(whole.size, 2), 1e-11);
}

TEST(LinearSolver, BackendsAgree)
{
  if (mpi_size() > 1)
    GTEST_SKIP() << "UMFPACK works with one process";
  const SparseMatrix matrix = saddle_matrix(4, 8);
  std::vector<double> x = random_vector(matrix.size, 4), y = x;
  for (auto [name, b] : {std::pair<const char *, std::vector<double> *>{"mumps", &x}, {"umfpack", &y}})
  {
    const auto solver = make_linear_solver(name);
    EXPECT_EQ(solver->name(), name);
    solver->factorize(matrix);
    solver->solve(*b);
  }
  expect_near(x, y, 1e-12);
}

TEST(LinearSolver, InertiaCountsTheSignsOfTheEigenvalues)
{
  const std::vector<double> d{3., -1., 2., -5., 0.1, 7., -0.2, 1., 1., 4., -1e-4, 2.}; // 8 positive, 4 negative
  const auto solver = make_linear_solver("mumps");
  EXPECT_FALSE(solver->inertia());
  solver->factorize(share(congruent_to(d)));
  const auto inertia = solver->inertia();
  ASSERT_TRUE(inertia);
  EXPECT_EQ(inertia->positive, 8);
  EXPECT_EQ(inertia->negative, 4);
  EXPECT_EQ(inertia->zero, 0);
}

TEST(LinearSolver, InertiaOfSaddlePointsCountsMomentsAndConstraints)
{
  const auto solver = make_linear_solver("mumps");
  solver->factorize(share(saddle_matrix(6, 8)));
  EXPECT_EQ(solver->inertia()->negative, 27 * 36 + 8);
  EXPECT_EQ(solver->inertia()->positive, 9 * 36);
  EXPECT_EQ(solver->inertia()->zero, 0);
}

TEST(LinearSolver, InertiaIsNotClaimedForGeneralMatrices)
{
  for (const std::string &name : solvers_for_this_run())
  {
    const auto solver = make_linear_solver(name);
    solver->factorize(share(random_matrix(MatrixSymmetry::general, 50, 4)));
    EXPECT_FALSE(solver->inertia()) << name;
  }
}

TEST(LinearSolver, SingularMatricesAreErrorsThatSaySo)
{
  MatrixBuilder empty_row(MatrixSymmetry::symmetric, 3);
  empty_row.add(0, 0, 1.);
  empty_row.add(1, 1, -1.);
  for (const std::string &name : solvers_for_this_run())
  {
    const auto solver = make_linear_solver(name);
    for (const int side : {10, 40, 120})
      EXPECT_NE(failure(*solver, laplacian(side, 0.)).find("singular"), std::string::npos) << name << " " << side;
    EXPECT_NE(failure(*solver, empty_row.matrix()).find("singular"), std::string::npos) << name;
    EXPECT_EQ(failure(*solver, laplacian(40, 1e-10)), "") << name; // condition number 1e11
    expect_solves(*solver, laplacian(10, 1.));                     // usable after an error
  }
}

TEST(LinearSolver, NullPivotsAreCountedApart)
{
  const auto solver = make_linear_solver("mumps");
  EXPECT_NE(failure(*solver, laplacian(40, 0.)), "");
  ASSERT_TRUE(solver->inertia());
  EXPECT_EQ(solver->inertia()->positive, 1599);
  EXPECT_EQ(solver->inertia()->negative, 0);
  EXPECT_EQ(solver->inertia()->zero, 1);
}

TEST(LinearSolver, EntriesThatAreNotFiniteAreErrors)
{
  SparseMatrix matrix = laplacian(5, 1.);
  if (mpi_rank() == 0)
    matrix.values[7] = std::numeric_limits<double>::quiet_NaN();
  for (const std::string &name : solvers_for_this_run())
  {
    const auto solver = make_linear_solver(name);
    EXPECT_THROW(solver->factorize(matrix), SolveError) << name; // on every process
    expect_solves(*solver, laplacian(5, 1.));
  }
}

TEST(LinearSolver, FollowsNewValuesAndNewPatterns)
{
  for (const std::string &name : solvers_for_this_run())
  {
    SCOPED_TRACE(name);
    const auto solver = make_linear_solver(name);
    expect_solves(*solver, saddle_matrix(3, 2, 1));
    expect_solves(*solver, saddle_matrix(3, 2, 2)); // same pattern
    expect_solves(*solver, saddle_matrix(3, 3, 2)); // one more row
    SparseMatrix moved = laplacian(6, 1.);
    expect_solves(*solver, moved);
    // As many entries in as many rows, one of them elsewhere.
    const int last_but_one = int(moved.columns.size()) - 2;
    moved.columns[last_but_one] -= 3;
    std::sort(moved.columns.begin() + moved.row_start[35], moved.columns.end());
    expect_solves(*solver, moved);
    expect_solves(*solver, random_matrix(MatrixSymmetry::general, 36, 5));
  }
}

TEST(LinearSolver, LeavesTheMatrixAndOtherRightHandSidesAlone)
{
  const SparseMatrix matrix = share(saddle_matrix(3, 2)), copy = matrix;
  for (const std::string &name : solvers_for_this_run())
  {
    const auto solver = make_linear_solver(name);
    solver->factorize(matrix);
    std::vector<double> first = random_vector(matrix.size, 1), second = random_vector(matrix.size, 2), again = first;
    solver->solve(first);
    solver->solve(second);
    solver->solve(again);
    expect_near(first, again, 1e-13); // with several processes MUMPS sums in the order of arrival
    EXPECT_EQ(matrix.values, copy.values) << name;
  }
}

/** Rows (1, a), (0, 1): with x = (1, 1) and b = A x, |A^-1| (|A| |x| + |b|) = (2 + 4 a, 2). */
TEST(LinearSolver, ConditioningOfAKnownMatrix)
{
  const double a = 1e5;
  MatrixBuilder builder(MatrixSymmetry::general, 2);
  builder.add(0, 0, 1. / mpi_size());
  builder.add(1, 1, 1. / mpi_size());
  builder.add(0, 1, a / mpi_size());
  const SparseMatrix matrix = builder.matrix();
  const auto solver         = make_linear_solver("mumps");
  solver->factorize(matrix);
  const std::optional<Conditioning> found = solver->conditioning(matrix);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->condition_estimate, 2. + 4. * a, 1e-6 * a);
  EXPECT_GT(found->smallest_pivot, 0.);
  EXPECT_LE(found->smallest_pivot, found->largest_pivot);

  std::vector<double> solution{1. + a, 1.};
  solver->solve(solution);
  expect_near(solution, {1., 1.}, 1e-10);
}

/** A symmetric matrix is stored by its lower half; multiples of the identity are as well-conditioned as can be: 2 by
 * the measure of MUMPS, which adds |b| to |A| |x|, 1 by that of UMFPACK. */
TEST(LinearSolver, ConditioningDoesNotSeeTheScaleOfSymmetricMatrices)
{
  MatrixBuilder builder(MatrixSymmetry::symmetric, 3);
  for (int i = 0; i < 3; ++i)
    builder.add(i, i, 1e-7 / mpi_size());
  const SparseMatrix matrix = builder.matrix();
  for (const std::string &name : solvers_for_this_run())
  {
    const auto solver = make_linear_solver(name);
    solver->factorize(matrix);
    EXPECT_NEAR(solver->conditioning(matrix).value().condition_estimate, name == "mumps" ? 2. : 1., 1e-6) << name;
  }
}

TEST(LinearSolver, UnknownNamesAreTheUsersMistake)
{
  EXPECT_USER_ERROR(make_linear_solver("mump"), "'mump'", "'mumps'");
}

TEST(LinearSolver, UmfpackRefusesSeveralProcesses)
{
  if (mpi_size() == 1)
    EXPECT_EQ(make_linear_solver("umfpack")->name(), "umfpack");
  else
    EXPECT_THROW(make_linear_solver("umfpack"), UserError);
}

TEST(LinearSolver, MumpsWantsMpiInitialisedFirst)
{
  EXPECT_NE(message_before_mpi_init.find("MPI_Init"), std::string::npos) << message_before_mpi_init;
}

int main(int argc, char **argv)
{
  try
  {
    make_linear_solver("mumps");
  }
  catch (const std::logic_error &error)
  {
    message_before_mpi_init = error.what();
  }
  MPI_Init(&argc, &argv);
  testing::InitGoogleTest(&argc, argv);
  const int result = RUN_ALL_TESTS();
  MPI_Finalize();
  return result;
}

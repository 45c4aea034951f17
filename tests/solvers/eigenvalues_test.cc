// SPDX-License-Identifier: LGPL-2.1-or-later
// Lowest eigenvalues of matrices with known spectra; some tests also with two MPI processes (second ctest entry).
#include <pellicle/base/constants.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/solvers/eigenvalues.h>

#include "../mpi_environment.h"
#include "synthetic_matrices.h"

#include <gtest/gtest.h>
#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace pellicle;
using namespace pellicle::synthetic;

namespace
{
struct Pencil
{
  MatrixBuilder K, M;
  int n_expected_negative = 0;

  explicit Pencil(const int size)
      : K(MatrixSymmetry::symmetric, size)
      , M(MatrixSymmetry::symmetric, size)
  {
  }
  void add_mass(const int first, const int n, const double mass = 1.)
  {
    for (int i = first; i < first + n; ++i)
      M.add(i, i, mass);
  }
};

/** This process's share of a matrix: every other entry. */
SparseMatrix share(const SparseMatrix &matrix)
{
  int rank = 0, size = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  MatrixBuilder builder(matrix.symmetry, matrix.size);
  for (int i = 0; i < matrix.size; ++i)
    for (int k = matrix.row_start[i]; k < matrix.row_start[i + 1]; ++k)
      if (k % size == rank)
        builder.add(i, matrix.columns[k], matrix.values[k]);
  return builder.matrix();
}

/** Lowest eigenvalues, after checks of what holds for any matrix: order, orthonormality, residuals. */
Eigenpairs lowest(const Pencil &pencil, const unsigned int n, const double scale)
{
  const SparseMatrix K = pencil.K.matrix(), M = pencil.M.matrix();
  const auto solver  = make_linear_solver("mumps");
  const auto pairs   = lowest_eigenpairs(share(K), M, *solver, pencil.n_expected_negative, n, scale);
  const auto largest = *std::max_element(K.values.begin(), K.values.end(),
                                         [](const double a, const double b) { return std::abs(a) < std::abs(b); });
  EXPECT_EQ(pairs.values.size(), n);
  EXPECT_EQ(pairs.vectors.size(), n);
  EXPECT_TRUE(std::is_sorted(pairs.values.begin(), pairs.values.end()));
  for (unsigned int i = 0; i < n; ++i)
  {
    const std::vector<double> Mu = product(M, pairs.vectors[i]), Ku = product(K, pairs.vectors[i]);
    for (unsigned int j = 0; j < n; ++j)
      EXPECT_NEAR(std::inner_product(Mu.begin(), Mu.end(), pairs.vectors[j].begin(), 0.), i == j ? 1. : 0., 1e-9)
          << i << " " << j;
    for (std::size_t k = 0; k < Mu.size(); ++k)
      EXPECT_NEAR(Ku[k], pairs.values[i] * Mu[k], 1e-9 * std::abs(largest)) << "vector " << i << " row " << k;
  }
  return pairs;
}

void expect_values(const Eigenpairs &pairs, std::vector<double> expected, const double tolerance)
{
  std::sort(expected.begin(), expected.end());
  for (std::size_t i = 0; i < pairs.values.size(); ++i)
    EXPECT_NEAR(pairs.values[i], expected[i], tolerance) << "eigenvalue " << i;
}

/** Springs of stiffness 1 in a row, nodes first, first + 1, ... */
void add_chain(Pencil &pencil, const int first, const int n)
{
  for (int i = first; i + 1 < first + n; ++i)
  {
    pencil.K.add(i, i, 1.);
    pencil.K.add(i + 1, i + 1, 1.);
    pencil.K.add(i + 1, i, -1.);
  }
}
/** The chain with both ends held by springs to the ground has 4 sin^2(k pi/(2 n + 2)), k = 1 ... n. */
void add_held_chain(Pencil &pencil, const int first, const int n)
{
  add_chain(pencil, first, n);
  pencil.K.add(first, first, 1.);
  pencil.K.add(first + n - 1, first + n - 1, 1.);
}
/** That chain with unit masses, and rows for constraints behind it. */
Pencil held_chain(const int n, const int n_constraints)
{
  Pencil pencil(n + n_constraints);
  add_held_chain(pencil, 0, n);
  pencil.add_mass(0, n);
  pencil.n_expected_negative = n_constraints;
  return pencil;
}
double held_eigenvalue(const int k, const int n)
{
  return 4. * std::pow(std::sin(k * pi / (2 * n + 2)), 2);
}
/** The free chain, k = 0 ... n - 1. */
double free_eigenvalue(const int k, const int n)
{
  return 4. * std::pow(std::sin(k * pi / (2 * n)), 2);
}
template <typename Function>
std::vector<double> spectrum(const int first, const int last, const Function &value)
{
  std::vector<double> values;
  for (int k = first; k <= last; ++k)
    values.push_back(value(k));
  return values;
}

std::string failure(const Pencil &pencil, const unsigned int n, const std::string &solver = "mumps")
{
  try
  {
    const auto linear_solver = make_linear_solver(solver);
    lowest_eigenpairs(share(pencil.K.matrix()), pencil.M.matrix(), *linear_solver, pencil.n_expected_negative, n, 1.);
  }
  catch (const SolveError &error)
  {
    return error.what();
  }
  return "";
}
void expect_failure(const Pencil &pencil, const unsigned int n, const std::string &part_of_message)
{
  const std::string message = failure(pencil, n);
  EXPECT_NE(message.find(part_of_message), std::string::npos) << message;
}
} // namespace

TEST(Eigenvalues, OfAChainOfSprings)
{
  const int n        = 300;
  const double m     = 0.1;
  const auto exactly = [&](const int k) { return held_eigenvalue(k, n) / m; };
  Pencil pencil(n);
  add_held_chain(pencil, 0, n);
  pencil.add_mass(0, n, m);
  const Eigenpairs pairs = lowest(pencil, 6, 1e-2);
  expect_values(pairs, spectrum(1, 6, exactly), 1e-11);
  // Mode k: sqrt(2/(m (n + 1))) sin(k pi (i + 1)/(n + 1)).
  for (int k = 1; k <= 6; ++k)
  {
    const std::vector<double> &u = pairs.vectors[k - 1];
    const double sign            = std::copysign(1., u[0]);
    for (int i = 0; i < n; ++i)
      EXPECT_NEAR(sign * u[i], std::sqrt(2. / (m * (n + 1))) * std::sin(k * pi * (i + 1) / (n + 1)), 1e-9);
  }
  EXPECT_EQ(pairs.n_factorizations, 2); // the shift and the count at the end
}

TEST(Eigenvalues, ZerosNeedNoCareAndAnyScaleWillDo)
{
  const int n = 300;
  Pencil pencil(n);
  add_chain(pencil, 0, n);
  pencil.add_mass(0, n);
  for (const double scale : {1e-12, 1e-6, 1e-3, 1., 1e3, 1e6})
  {
    SCOPED_TRACE(scale);
    const Eigenpairs pairs = lowest(pencil, 5, scale);
    expect_values(pairs, spectrum(0, 4, [](const int k) { return free_eigenvalue(k, n); }), 1e-12);
    EXPECT_LE(pairs.n_factorizations, 12);
    expect_values(lowest(pencil, 1, scale), {0.}, 1e-12);
  }
}

TEST(Eigenvalues, TheShiftGoesBelowNegativeOnes)
{
  const int n         = 200;
  const double offset = 0.5 * (held_eigenvalue(2, n) + held_eigenvalue(3, n)); // two below it
  Pencil pencil(n);
  add_held_chain(pencil, 0, n);
  for (int i = 0; i < n; ++i)
    pencil.K.add(i, i, -offset);
  pencil.add_mass(0, n);
  const Eigenpairs pairs = lowest(pencil, 4, 1e-7);
  expect_values(pairs, spectrum(1, 4, [&](const int k) { return held_eigenvalue(k, n) - offset; }), 1e-12);
  EXPECT_LT(pairs.values[1], 0.);
  EXPECT_GT(pairs.values[2], 0.);
}

TEST(Eigenvalues, ABorderRowRemovesAMode)
{
  const int n = 150;
  Pencil pencil(n + 1);
  add_chain(pencil, 0, n);
  pencil.add_mass(0, n);
  for (int i = 0; i < n; ++i)
    pencil.K.add(n, i, 1.); // the mean displacement is zero
  pencil.n_expected_negative = 1;
  const auto rigidly         = spectrum(1, 5, [](const int k) { return free_eigenvalue(k, n); });
  expect_values(lowest(pencil, 5, 1e-2), rigidly, 1e-12);

  // A penalty c instead lets the mode through, at c n.
  const double c = 0.5 * (rigidly[0] + rigidly[1]) / n;
  pencil.K.add(n, n, -1. / c);
  expect_values(lowest(pencil, 5, 1e-2), {rigidly[0], c * n, rigidly[1], rigidly[2], rigidly[3]}, 1e-12);
}

TEST(Eigenvalues, InternalFieldsAreEliminated)
{
  // [ D L; L -1 ] with the chain's matrix L has the Schur complement D + L^2.
  const int n    = 100;
  const double d = -0.003;
  Pencil pencil(2 * n), chain(n);
  add_held_chain(chain, 0, n);
  const SparseMatrix L = chain.K.matrix();
  for (int i = 0; i < n; ++i)
  {
    pencil.K.add(i, i, d);
    pencil.K.add(n + i, n + i, -1.);
    for (int k = L.row_start[i]; k < L.row_start[i + 1]; ++k)
    {
      pencil.K.add(n + i, L.columns[k], L.values[k]);
      if (L.columns[k] != i)
        pencil.K.add(n + L.columns[k], i, L.values[k]);
    }
  }
  pencil.add_mass(0, n);
  pencil.n_expected_negative = n;
  const auto exactly         = [&](const int k) { return d + std::pow(held_eigenvalue(k, n), 2); };
  expect_values(lowest(pencil, 8, 1e-4), spectrum(1, 8, exactly), 1e-12);
}

TEST(Eigenvalues, MultipleOnesAreAllFound)
{
  // Seven equal chains: every eigenvalue occurs seven times, and nothing but round-off connects the chains.
  const int n = 40, n_copies = 7;
  Pencil pencil(n * n_copies);
  for (int copy = 0; copy < n_copies; ++copy)
    add_held_chain(pencil, n * copy, n);
  pencil.add_mass(0, n * n_copies);
  std::vector<double> expected;
  for (int i = 0; i < 21; ++i)
    expected.push_back(held_eigenvalue(1 + i / n_copies, n));
  for (const unsigned int n_wanted : {1, 2, 5, 7, 8, 16})
  {
    SCOPED_TRACE(n_wanted);
    expect_values(lowest(pencil, n_wanted, 1e-2), expected, 1e-12);
  }
}

TEST(Eigenvalues, ARingHasPairs)
{
  const int n = 120;
  Pencil pencil(n);
  add_chain(pencil, 0, n);
  pencil.K.add(0, 0, 1.);
  pencil.K.add(n - 1, n - 1, 1.);
  pencil.K.add(n - 1, 0, -1.);
  pencil.add_mass(0, n);
  const auto exactly = [](const int k) { return 4. * std::pow(std::sin((k + 1) / 2 * pi / n), 2); };
  for (const unsigned int n_wanted : {2, 3, 8, 9})
    expect_values(lowest(pencil, n_wanted, 1e-2), spectrum(0, 9, exactly), 1e-12);
}

TEST(Eigenvalues, OneFewerThanThereAre)
{
  // Four unknowns with mass and as many internal ones: x^2 (k + 1)/2 + x P - P^2/2 gives k + 2.
  Pencil pencil(8);
  for (int k = 0; k < 4; ++k)
  {
    pencil.K.add(k, k, k + 1.);
    pencil.K.add(4 + k, k, 1.);
    pencil.K.add(4 + k, 4 + k, -1.);
  }
  pencil.add_mass(0, 4);
  pencil.n_expected_negative = 4;
  expect_values(lowest(pencil, 3, 1.), {2., 3., 4.}, 1e-12);
  expect_failure(pencil, 4, "only 4 finite eigenvalues");
}

TEST(Eigenvalues, ExactConstraintsLeaveFewer)
{
  // Mean and first moment are zero: 28 of 30 are left.
  Pencil pencil = held_chain(30, 2);
  for (int i = 0; i < 30; ++i)
  {
    pencil.K.add(30, i, std::sin(pi * (i + 1) / 31.)); // modes 1 and 2
    pencil.K.add(31, i, std::sin(2. * pi * (i + 1) / 31.));
  }
  expect_values(lowest(pencil, 27, 1.), spectrum(3, 30, [](const int k) { return held_eigenvalue(k, 30); }), 1e-11);
  expect_failure(pencil, 29, "only 28 finite eigenvalues");
  expect_failure(pencil, 30, "only 30 finite eigenvalues");
}

TEST(Eigenvalues, AWrongCountIsAnError)
{
  Pencil pencil = held_chain(10, 1);
  pencil.K.add(10, 10, -1.);
  pencil.n_expected_negative = 0;
  expect_failure(pencil, 2, "No shift lies below all eigenvalues: 1 are below -1e+12");
  pencil.n_expected_negative = 2;
  expect_failure(pencil, 2, "fewer than the 2 of internal fields");
}

TEST(Eigenvalues, ARedundantConstraintIsAnError)
{
  Pencil pencil = held_chain(10, 2);
  for (int i = 0; i < 10; ++i)
  {
    pencil.K.add(10, i, 1.);
    pencil.K.add(11, i, 2.);
  }
  expect_failure(pencil, 2, "redundant constraint");
}

TEST(Eigenvalues, WithoutInertiaNothingIsClaimed)
{
  Pencil pencil = held_chain(10, 0);
  EXPECT_NE(failure(pencil, 2, "umfpack").find("Use 'mumps'"), std::string::npos) << failure(pencil, 2, "umfpack");
}

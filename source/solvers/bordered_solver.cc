// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/solvers/bordered_solver.h>

#include <numeric>
#include <optional>

namespace pellicle
{
namespace
{
/** Of the vector b with the first entries of a. */
double dot(const std::vector<double> &a, const std::vector<double> &b)
{
  return std::inner_product(b.begin(), b.end(), a.begin(), 0.);
}
} // namespace

BorderedSolver::BorderedSolver(LinearSolver &inner, const Border &border)
    : inner(inner)
    , border(border)
{
}

void BorderedSolver::factorize(const SparseMatrix &new_matrix)
{
  PELLICLE_ASSERT(border.column.size() == std::size_t(new_matrix.size), "column of wrong size");
  PELLICLE_ASSERT(border.row.size() == std::size_t(new_matrix.size), "row of wrong size");
  inner.factorize(new_matrix);
  matrix       = &new_matrix;
  inner_column = border.column;
  inner.solve(inner_column);
}

void BorderedSolver::eliminate(std::vector<double> &right_hand_side) const
{
  const double g = right_hand_side.back();
  right_hand_side.pop_back();
  inner.solve(right_hand_side);
  const double q = (g - dot(right_hand_side, border.row)) / (border.corner - dot(inner_column, border.row));
  for (std::size_t i = 0; i < right_hand_side.size(); ++i)
    right_hand_side[i] -= q * inner_column[i];
  right_hand_side.push_back(q);
}

void BorderedSolver::solve(std::vector<double> &right_hand_side) const
{
  PELLICLE_ASSERT(matrix, "solve() without a factorisation");
  PELLICLE_ASSERT(right_hand_side.size() == std::size_t(matrix->size) + 1, "right-hand side of wrong size");
  std::vector<double> solution = right_hand_side;
  eliminate(solution);

  const double q = solution.back();
  std::vector<double> correction(solution.size(), 0.);
  add_product(*matrix, -1., solution, correction);
  communicator.sum(correction);
  for (std::size_t i = 0; i < border.column.size(); ++i)
    correction[i] += right_hand_side[i] - q * border.column[i];
  correction.back() = right_hand_side.back() - dot(solution, border.row) - border.corner * q;
  eliminate(correction);

  for (std::size_t i = 0; i < solution.size(); ++i)
    right_hand_side[i] = solution[i] + correction[i];
}

std::optional<Inertia> BorderedSolver::inertia() const
{
  return inner.inertia();
}

std::string BorderedSolver::name() const
{
  return inner.name();
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
// UMFPACK: sparse LU in one process. A symmetric matrix is expanded; the signs of its eigenvalues are not known here.
#include <pellicle/base/exceptions.h>
#include <pellicle/base/expanded_pattern.h>

#include "direct_solvers.h"

#include <umfpack.h>

#include <array>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace pellicle::internal
{
namespace
{
struct FreeSymbolic
{
  void operator()(void *symbolic) const { umfpack_di_free_symbolic(&symbolic); }
};
struct FreeNumeric
{
  void operator()(void *numeric) const { umfpack_di_free_numeric(&numeric); }
};

std::string cause(const int status)
{
  switch (status)
  {
  case UMFPACK_ERROR_out_of_memory:
    return "not enough memory for the factors";
  case UMFPACK_ERROR_invalid_matrix:
    return "the matrix is malformed";
  default:
    return "internal error";
  }
}

class UmfpackSolver : public LinearSolver
{
public:
  UmfpackSolver() { umfpack_di_defaults(control.data()); }

  void factorize(const SparseMatrix &matrix) override
  {
    PELLICLE_ASSERT(matrix.size > 0 && matrix.row_start.size() == std::size_t(matrix.size) + 1, "incomplete matrix");
    PELLICLE_ASSERT(matrix.columns.size() == matrix.values.size(), "incomplete matrix");
    numeric.reset();
    if (!all_finite(matrix))
      throw SolveError(not_finite_message);
    if (!is_analysed(matrix))
      analyse(matrix);

    values.resize(pattern->origin.size());
    for (std::size_t k = 0; k < values.size(); ++k)
      values[k] = matrix.values[pattern->origin[k]];
    std::array<double, UMFPACK_INFO> info;
    void *result     = nullptr;
    const int status = umfpack_di_numeric(pattern->row_start.data(), pattern->columns.data(), values.data(),
                                          symbolic.get(), &result, control.data(), info.data());
    std::unique_ptr<void, FreeNumeric> factors(result);
    if (status < 0)
      fail("factorisation", status);
    // UMFPACK_RCOND: smallest over largest pivot.
    if (status == UMFPACK_WARNING_singular_matrix || !(info[UMFPACK_RCOND] > null_pivot_threshold(matrix.size)))
    {
      std::ostringstream message;
      message << "The matrix of the linear system is singular to working precision: in UMFPACK the smallest of "
              << matrix.size << " pivots is " << info[UMFPACK_RCOND] << " times the largest. " << usual_cause;
      throw SolveError(message.str());
    }
    numeric = std::move(factors);
    pivots  = {info[UMFPACK_UMAX] / info[UMFPACK_UMIN], info[UMFPACK_UMIN], info[UMFPACK_UMAX]};
  }

  void solve(std::vector<double> &right_hand_side) const override
  {
    PELLICLE_ASSERT(numeric, "solve() without a factorisation");
    PELLICLE_ASSERT(right_hand_side.size() + 1 == pattern->row_start.size(), "right-hand side of wrong size");
    std::vector<double> solution(right_hand_side.size());
    // UMFPACK reads the arrays as columns, so that it has factorised the transpose of what is stored by rows.
    const int status =
        umfpack_di_solve(UMFPACK_At, pattern->row_start.data(), pattern->columns.data(), values.data(), solution.data(),
                         right_hand_side.data(), numeric.get(), control.data(), nullptr);
    if (status < 0)
      fail("solution", status);
    right_hand_side.swap(solution);
  }

  std::optional<Inertia> inertia() const override { return std::nullopt; }

  std::optional<Conditioning> conditioning(const SparseMatrix & /*matrix*/) const override { return pivots; }

  std::string name() const override { return "umfpack"; }

private:
  bool is_analysed(const SparseMatrix &matrix) const
  {
    return symbolic && analysed.symmetry == matrix.symmetry && analysed.size == matrix.size &&
           analysed.row_start == matrix.row_start && analysed.columns == matrix.columns;
  }

  void analyse(const SparseMatrix &matrix)
  {
    symbolic.reset();
    pattern.emplace(matrix);
    void *result     = nullptr;
    const int status = umfpack_di_symbolic(matrix.size, matrix.size, pattern->row_start.data(), pattern->columns.data(),
                                           nullptr, &result, control.data(), nullptr);
    if (status < 0)
      fail("analysis", status);
    symbolic.reset(result);
    analysed = {matrix.symmetry, matrix.size, matrix.row_start, matrix.columns, {}};
  }

  [[noreturn]] static void fail(const std::string &phase, const int status)
  {
    throw SolveError("UMFPACK failed in the " + phase + ": " + cause(status) + " (status " + std::to_string(status) +
                     ").");
  }

  std::array<double, UMFPACK_CONTROL> control;
  SparseMatrix analysed; ///< pattern only
  std::optional<ExpandedPattern> pattern;
  std::vector<double> values; ///< of the expanded pattern; solve() needs them for iterative refinement
  std::unique_ptr<void, FreeSymbolic> symbolic;
  std::unique_ptr<void, FreeNumeric> numeric;
  Conditioning pivots;
};
} // namespace

std::unique_ptr<LinearSolver> make_umfpack_solver()
{
  return std::make_unique<UmfpackSolver>();
}
} // namespace pellicle::internal

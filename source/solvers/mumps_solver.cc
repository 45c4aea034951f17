// SPDX-License-Identifier: LGPL-2.1-or-later
// MUMPS through its C interface: multifrontal LDL^T (symmetric) or LU (general), over all processes of MPI_COMM_WORLD.
// With several processes sums are made in the order in which messages arrive: results then repeat to round-off only.
#include <pellicle/base/exceptions.h>

#include "direct_solvers.h"

#include <dmumps_c.h>
#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace pellicle::internal
{
namespace
{
/** One MUMPS instance from initialisation to end. Calls are collective; control and info arrays have the manual's
 * indices. */
class MumpsInstance
{
public:
  explicit MumpsInstance(const MatrixSymmetry symmetry)
  {
    data.sym          = symmetry == MatrixSymmetry::symmetric ? 2 : 0;
    data.par          = 1; // the host works, too
    data.comm_fortran = MPI_Comm_c2f(MPI_COMM_WORLD);
    if (call(initialise) < 0)
      throw SolveError("MUMPS cannot be started (INFOG(1) = " + std::to_string(infog(1)) + ").");
    for (const int stream : {1, 2, 3})
      icntl(stream) = -1; // no messages: errors come as exceptions
    icntl(4)  = 0;
    icntl(7)  = 6; // QAMD, a minimum degree ordering that sets nearly dense rows (constraints) aside
    icntl(13) = 1; // the root is factorised by one process, so that its negative pivots are counted, too
    icntl(24) = 1; // null pivots are found, not divided by
    MPI_Comm_size(MPI_COMM_WORLD, &n_processes);
    // Several processes: each passes entries of its own, also at the analysis, and entries at the same place are added.
    // One process passes them all at once, which saves a redistribution as long as a quarter of a factorisation.
    icntl(18) = n_processes > 1 ? 3 : 0;
    icntl(28) = 1; // sequential analysis
    if (scales_itself())
      icntl(8) = -1; // MUMPS takes what it is given
  }
  ~MumpsInstance()
  {
    int finalised = 0;
    MPI_Finalized(&finalised);
    if (!finalised)
      call(end);
  }
  MumpsInstance(const MumpsInstance &)            = delete;
  MumpsInstance &operator=(const MumpsInstance &) = delete;

  static constexpr int initialise = -1, end = -2, analyse = 1, factorise = 2, solve = 3;

  /** Returns INFOG(1): negative for errors, the same on all processes. */
  int call(const int job)
  {
    data.job = job;
    dmumps_c(&data);
    return infog(1);
  }

  int &icntl(const int i) { return data.icntl[i - 1]; }
  double &cntl(const int i) { return data.cntl[i - 1]; }
  int infog(const int i) const { return data.infog[i - 1]; }
  double rinfog(const int i) const { return data.rinfog[i - 1]; }

  /** Entries of the pattern, counted from 1; they must stay where they are. */
  void set_pattern(std::vector<int> &rows, std::vector<int> &columns)
  {
    (n_processes > 1 ? data.nnz_loc : data.nnz) = MUMPS_INT8(rows.size());
    (n_processes > 1 ? data.irn_loc : data.irn) = rows.data();
    (n_processes > 1 ? data.jcn_loc : data.jcn) = columns.data();
  }
  /** MUMPS reads the values in the calls that follow and does not change them. */
  void set_values(const double *values)
  {
    (n_processes > 1 ? data.a_loc : data.a) = const_cast<double *>(values);
    if (scales_itself() && values != nullptr)
      scale();
  }

  DMUMPS_STRUC_C data{};
  int n_processes = 1;

private:
  bool scales_itself() const { return n_processes == 1 && data.sym == 0; }

  /**
   * Divides rows and columns by the square roots of their largest entries, in one pass over the matrix. MUMPS's own
   * iterated scaling takes a fifth of the LU factorisations of vesicles and is no more accurate there. LDL^T needs it:
   * with this one, shells postpone so many pivots that they take twice as long.
   */
  void scale()
  {
    row_scale.assign(static_cast<std::size_t>(data.n), 0.);
    column_scale.assign(static_cast<std::size_t>(data.n), 0.);
    for (MUMPS_INT8 k = 0; k < data.nnz; ++k)
    {
      double &row = row_scale[data.irn[k] - 1], &column = column_scale[data.jcn[k] - 1];
      row    = std::max(row, std::abs(data.a[k]));
      column = std::max(column, std::abs(data.a[k]));
    }
    for (std::vector<double> *const scale : {&row_scale, &column_scale})
      for (double &s : *scale)
        s = s > 0. ? 1. / std::sqrt(s) : 1.;
    data.rowsca = row_scale.data();
    data.colsca = column_scale.data();
  }

  std::vector<double> row_scale, column_scale;
};

/** The error in words; MUMPS puts more detail, such as a size, in INFOG(2). */
std::string cause(const int error, const int detail)
{
  switch (error)
  {
  case -5:
  case -7:
  case -13:
    return "not enough memory for the factors";
  case -6:
    return "the matrix is singular in structure (structural rank " + std::to_string(detail) + ")";
  case -8:
  case -9:
  case -17:
  case -20:
    return "the work space stayed too small although it was enlarged several times";
  case -10:
    return "the matrix is singular";
  default:
    return "internal error";
  }
}

[[noreturn]] void fail(const MumpsInstance &mumps, const std::string &phase)
{
  const int error = mumps.infog(1), detail = mumps.infog(2);
  throw SolveError("MUMPS failed in the " + phase + ": " + cause(error, detail) +
                   " (INFOG(1) = " + std::to_string(error) + ", INFOG(2) = " + std::to_string(detail) + ").");
}

class MumpsSolver : public LinearSolver
{
public:
  MumpsSolver()
  {
    int initialised = 0;
    MPI_Initialized(&initialised);
    if (!initialised)
      throw std::logic_error("The linear solver 'mumps' is made before MPI_Init was called.");
  }

  void factorize(const SparseMatrix &matrix) override
  {
    PELLICLE_ASSERT(matrix.size > 0 && matrix.row_start.size() == std::size_t(matrix.size) + 1, "incomplete matrix");
    PELLICLE_ASSERT(matrix.columns.size() == matrix.values.size(), "incomplete matrix");
    factorised = false;
    pivots.reset();

    // Whether to analyse anew is decided together: all processes have to make the same calls.
    int agreed[2] = {is_analysed(matrix), all_finite(matrix)};
    MPI_Allreduce(MPI_IN_PLACE, agreed, 2, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
    if (!agreed[1])
      throw SolveError(not_finite_message);
    if (!agreed[0])
      analyse(matrix);

    mumps->set_values(matrix.values.data());
    factorise_with_growing_work_space();
    mumps->set_values(nullptr);

    const int n_null = mumps->infog(28);
    if (symmetry == MatrixSymmetry::symmetric)
      pivots = Inertia{matrix.size - mumps->infog(12) - n_null, mumps->infog(12), n_null};
    if (n_null > 0)
      throw SolveError("The matrix of the linear system is singular to working precision: MUMPS found " +
                       std::to_string(n_null) + (n_null > 1 ? " null pivots" : " null pivot") + " among " +
                       std::to_string(matrix.size) + ". " + usual_cause);
    factorised = true;
  }

  void solve(std::vector<double> &right_hand_side) const override
  {
    PELLICLE_ASSERT(factorised, "solve() without a factorisation");
    PELLICLE_ASSERT(right_hand_side.size() == std::size_t(mumps->data.n), "right-hand side of wrong size");
    mumps->data.rhs = right_hand_side.data(); // read and overwritten on the host only
    if (mumps->call(MumpsInstance::solve) < 0)
      fail(*mumps, "solution");
    MPI_Bcast(right_hand_side.data(), int(right_hand_side.size()), MPI_DOUBLE, 0, MPI_COMM_WORLD);
  }

  std::optional<Inertia> inertia() const override { return pivots; }

  // The right-hand side A (1, ..., 1) makes the error analysis one of A itself, whatever is solved for.
  std::optional<Conditioning> conditioning(const SparseMatrix &matrix) const override
  {
    PELLICLE_ASSERT(factorised && is_analysed(matrix), "of the matrix that was factorised last");
    std::vector<double> row_sums(std::size_t(matrix.size), 0.);
    add_product(matrix, 1., std::vector<double>(std::size_t(matrix.size), 1.), row_sums);
    MPI_Allreduce(MPI_IN_PLACE, row_sums.data(), matrix.size, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    mumps->set_values(matrix.values.data());
    mumps->icntl(11) = 1; // condition numbers, too
    mumps->data.rhs  = row_sums.data();
    const int status = mumps->call(MumpsInstance::solve);
    mumps->icntl(11) = 0;
    mumps->set_values(nullptr);
    if (status < 0)
      fail(*mumps, "error analysis");
    return Conditioning{std::max(mumps->rinfog(10), mumps->rinfog(11)), mumps->rinfog(19), mumps->rinfog(21)};
  }

  std::string name() const override { return "mumps"; }

private:
  /** Whether this process's share of the pattern is the analysed one. */
  bool is_analysed(const SparseMatrix &matrix) const
  {
    if (!mumps || symmetry != matrix.symmetry || mumps->data.n != matrix.size || rows.size() != matrix.columns.size())
      return false;
    for (int i = 0; i < matrix.size; ++i)
      for (int k = matrix.row_start[i]; k < matrix.row_start[i + 1]; ++k)
        if (rows[k] != i + 1 || columns[k] != matrix.columns[k] + 1)
          return false;
    return true;
  }

  void analyse(const SparseMatrix &matrix)
  {
    mumps.reset(); // first, for its memory
    rows.resize(matrix.columns.size());
    columns.resize(matrix.columns.size());
    for (int i = 0; i < matrix.size; ++i)
      for (int k = matrix.row_start[i]; k < matrix.row_start[i + 1]; ++k)
      {
        PELLICLE_ASSERT(matrix.symmetry == MatrixSymmetry::general || matrix.columns[k] <= i,
                        "entry above the diagonal");
        rows[k]    = i + 1;
        columns[k] = matrix.columns[k] + 1;
      }
    symmetry         = matrix.symmetry;
    auto instance    = std::make_unique<MumpsInstance>(symmetry);
    instance->data.n = matrix.size;
    instance->set_pattern(rows, columns);
    instance->cntl(3) = null_pivot_threshold(matrix.size);
    if (instance->call(MumpsInstance::analyse) < 0)
      fail(*instance, "analysis");
    mumps = std::move(instance);
  }

  /** Postponed pivots need more room than the analysis foresaw: ICNTL(14), the spare per cent, is then doubled. */
  void factorise_with_growing_work_space()
  {
    constexpr int n_attempts = 10; // delayed pivots can make the factors of a meridian a hundred times as large
    for (int attempt = 0; attempt < n_attempts; ++attempt)
    {
      if (mumps->call(MumpsInstance::factorise) >= 0)
        return;
      const int error      = mumps->infog(1);
      const bool too_small = error == -8 || error == -9 || error == -17 || error == -20;
      if (!too_small)
        break;
      mumps->icntl(14) = 2 * std::max(mumps->icntl(14), 20);
    }
    fail(*mumps, "factorisation");
  }

  std::unique_ptr<MumpsInstance> mumps;
  MatrixSymmetry symmetry = MatrixSymmetry::symmetric;
  std::vector<int> rows, columns; ///< of the analysed pattern, counted from 1
  bool factorised = false;
  std::optional<Inertia> pivots; ///< known also when factorize() ends with null pivots
};
} // namespace

std::unique_ptr<LinearSolver> make_mumps_solver()
{
  return std::make_unique<MumpsSolver>();
}
} // namespace pellicle::internal

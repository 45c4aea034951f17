// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/cell_loops.h>
#include <pellicle/base/archive.h>
#include <pellicle/solvers/linear_solver.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pellicle
{
/** How a run ended. */
enum class RunStatus
{
  converged,
  failed,        ///< did not converge
  refused,       ///< would not go on, for a reason given in the message
  target_not_met ///< solved, but not as accurately as was asked for
};

/** Size of the linear system that was solved. */
struct UnknownCounts
{
  std::size_t total = 0;
  std::vector<std::pair<std::string, std::size_t>> blocks; ///< name of the block, number of its unknowns
  /** Of the matrix that the first process holds, both triangles; 0: nothing has been solved. */
  std::size_t matrix_entries = 0;
};

/** What Newton's method did in the whole run. */
struct NewtonCounts
{
  int steps                      = 0; ///< load or time steps
  int iterations                 = 0; ///< accepted ones, all steps together
  int rejected                   = 0; ///< trials that were not accepted
  double final_relative_residual = std::numeric_limits<double>::quiet_NaN();
};

/** Wall-clock seconds. */
struct RunSeconds
{
  double total        = 0.; ///< from entering main
  double assembly     = 0.;
  double linear_solve = 0.;
  double output       = 0.;
};

/** Spectrum of the second variation on the admissible variations. */
struct StabilityCounts
{
  int negative_eigenvalues = 0;
  std::vector<double> lowest; ///< in the user's units, ascending
};

/** The matrix of the last equilibrium, when that was asked for. */
struct LinearSolverReport
{
  std::string name;
  Conditioning conditioning;
  std::optional<int> negative_pivots; ///< of a symmetric factorisation

  void exchange(Archive &archive) { archive | name | conditioning | negative_pivots; }
};

/** Everything that summary.json says about a run. */
struct RunResult
{
  /** What has come together on the way; the rest is known at the end only. */
  void exchange(Archive &archive) { archive | status | message | warnings | newton | quantities; }

  std::string application;
  RunStatus status = RunStatus::failed;
  std::string message; ///< what failed and what to try; empty after a converged run
  std::vector<std::string> effects;
  std::vector<std::string> analyses;
  std::vector<std::string> warnings;
  std::size_t n_cells = 0; ///< of the surface (ridge: of the bulk)
  unsigned int degree = 0;
  std::vector<CellLoop> loops; ///< what the assembler visits for the listed effects
  UnknownCounts unknowns;
  NewtonCounts newton;
  RunSeconds seconds;
  std::optional<LinearSolverReport> linear_solver;        ///< when asked for
  std::optional<StabilityCounts> stability;               ///< when analysed
  std::vector<std::pair<std::string, double>> quantities; ///< name, value in the user's units
};
} // namespace pellicle

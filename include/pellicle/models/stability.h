// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/archive.h>
#include <pellicle/base/parameters.h>
#include <pellicle/models/surface_problem.h>
#include <pellicle/solvers/linear_solver.h>

#include <optional>
#include <string>
#include <vector>

namespace pellicle
{
/** Section "Stability". */
struct StabilityParameters
{
  int eigenvalues           = 6;
  bool follow_unstable_mode = false;

  void bind(ParameterSection &section);
};

/**
 * Second variation of the energy at an equilibrium, on the variations that constraints and edges allow: normal
 * displacements (tangential ones are a gauge), or all displacements where potentials act tangentially. On a surface
 * that is held directors take the place of displacements. Internal units.
 *
 * mu and u solve K u = mu M u with M the L2 mass of the displacement: the second variation of the energy along a mode
 * of unit L2 norm is mu.
 */
struct Stability
{
  int negative_eigenvalues = 0;
  std::vector<double> lowest;      ///< ascending
  std::vector<NodalVectors> modes; ///< nodal displacements that belong to `lowest`, largest component positive
  std::size_t field = 0;           ///< whose changes the modes are
  std::string failure;             ///< why there are no eigenvalues, if they were asked for and not found

  void exchange(Archive &archive) { archive | negative_eigenvalues | lowest | modes | field | failure; }
};

/**
 * Counts the negative eigenvalues by the inertia of the matrix, and finds the lowest `n_eigenvalues` (0: none). Leaves
 * the problem at the same state in the normal-graph chart (or the material one). None if the linear solver does not
 * know the inertia.
 */
std::optional<Stability> analyse_stability(SurfaceProblem &problem, LinearSolver &solver, unsigned int n_eigenvalues);
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/assembler.h>
#include <pellicle/assembly/bordered_system.h>
#include <pellicle/assembly/nodal_conditions.h>
#include <pellicle/base/timing.h>
#include <pellicle/solvers/linear_solver.h>

#include <memory>
#include <string>
#include <vector>

namespace pellicle
{
/**
 * Solves for the internal fields at given independent fields and multipliers, by their own block of equations from the
 * sum of all potentials that declare them (contract 6). A density quadratic in the internal field (the moment) takes
 * one solve; others iterate.
 */
class InternalElimination
{
public:
  InternalElimination(const SurfaceDiscretization &discretization, const FieldLayout &layout, const PotentialSet &set,
                      const NodalConditions &conditions, const FieldValues &start, const Communicator &communicator,
                      const std::string &linear_solver, Timing &timing);

  /** Whether there is anything to eliminate. */
  bool empty() const { return n_unknowns == 0; }

  /**
   * Replaces the internal fields in `values` by the solution. Returns false if the equations could not be solved
   * (singular, not finite, no convergence in ten iterations).
   */
  bool solve(const PotentialSet &set, const std::vector<double> &multipliers, FieldValues &values);

  /** Negative eigenvalues of the internal fields' own block at the last solve, at most the number of its unknowns; all
   * of them where the linear solver cannot tell. */
  int negative_eigenvalues() const;

  const AssemblyCounters &counters() const { return assembler.counters(); }

private:
  double relative_residual(const PotentialSet &set, const std::vector<double> &multipliers, const FieldValues &values,
                           Order order);

  std::vector<NodalChart> charts(const FieldValues &values) const;

  const SurfaceDiscretization &discretization;
  const FieldLayout &layout;
  const NodalConditions &conditions;
  Assembler assembler;
  BorderedSystem system;
  std::size_t n_unknowns;
  std::unique_ptr<LinearSolver> solver;
  Timing &timing;
};
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/observer.h>
#include <pellicle/base/timing.h>
#include <pellicle/models/surface_problem.h>
#include <pellicle/solvers/newton.h>

#include <optional>
#include <string>
#include <vector>

namespace pellicle
{
/** Result of one equilibrium solve. */
struct StepResult
{
  bool converged           = false;
  int iterations           = 0;
  int rejected             = 0;
  double relative_residual = 0.;
  std::string failure;
  std::vector<std::string> warnings;
};

/**
 * How an equilibrium is looked for: which charts Newton's method works in, one after the other, and how far constraints
 * are taken at once.
 *
 * A constraint on curvature that the state is far from is approached in steps: at first the equilibrium without it,
 * then targets on the way. Taken at once it fails, for area, volume and curvature of a nearly spherical shape are
 * almost dependent and the multipliers of the first Newton step are absurd.
 */
class EquilibriumSearch
{
public:
  /** Keeps references. mesh_reference: positions whose metric the ALE chart prefers; step: number for the reports. */
  EquilibriumSearch(const NewtonParameters &newton, SurfaceProblem &problem, LinearSolver &solver, Timing &timing,
                    const NodalVectors &mesh_reference, int step, Observer &observer);

  /** From the problem's present state, in the charts that the parameters name. On failure the problem is left at the
   * last iterate. Returns whether it converged. */
  bool run();
  /** The same in the charts that lead downhill: normal graph with drag, then polished. */
  bool descend();

  /** One undamped Newton step in the chart that comes first, for states close to equilibrium. False, and the state is
   * what it was, if the step would go beyond Newton/Step limit or to where the surface makes no sense. */
  bool take_one_step();

  /** Of the last solve; iterations and rejected trials of all of them. */
  const StepResult &result() const { return outcome; }
  /** Makes the search a failure for a reason that lies outside it. */
  void fail(const std::string &reason)
  {
    outcome.converged = false;
    outcome.failure   = reason;
  }
  void warn(const std::string &text) { outcome.warnings.push_back(text); }

private:
  bool in_charts(const std::string &charts);
  bool iterate(PositionChart chart, int max_iterations);
  void polish(const std::optional<SurfaceState> &start);
  bool from_faired_start(const SurfaceState &start);
  bool approach(const std::vector<std::size_t> &distant);

  const NewtonParameters &newton;
  SurfaceProblem &problem;
  LinearSolver &solver;
  Timing &timing;
  const NodalVectors &mesh_reference;
  const int step;
  Observer &observer;
  StepResult outcome;
};
} // namespace pellicle

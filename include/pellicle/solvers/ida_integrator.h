// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/solvers/implicit_system.h>
#include <pellicle/solvers/linear_solver.h>

#include <memory>
#include <vector>

namespace pellicle
{
/** Tolerances of the local error: |error of y_i| <= relative |y_i| + absolute, in the mean square. */
struct IdaTolerances
{
  double relative = 1e-6;
  double absolute = 1e-8;
};

/** What the integrator has done since it was made. */
struct IdaStatistics
{
  int steps          = 0;
  int residuals      = 0;
  int factorisations = 0;
  int last_order     = 0;
  double last_step   = 0.;
};

/**
 * IDAS of SUNDIALS: backward differentiation formulas of variable order (1 to 5) and step for systems of index 1
 * (Hindmarsh et al., ACM Trans. Math. Softw. 31, 2005), with the system's own tangent dF/dy + alpha dF/dy' and a direct
 * solver of ours. The dissipated power is integrated as a further variable under the same error control.
 *
 * Algebraic unknowns and the rates need not be consistent at the start: the constructor makes them so.
 */
class IdaIntegrator
{
public:
  /**
   * @param y           the differential unknowns at `time`, and a guess of the algebraic ones
   * @param first_time  > time: some time at which the solution will be wanted, for the scale of time
   * Keeps references to the system and the solver. Throws SolveError if it finds no consistent values.
   */
  IdaIntegrator(ImplicitSystem &system, LinearSolver &solver, const IdaTolerances &tolerances, double time,
                std::vector<double> y, double first_time);
  ~IdaIntegrator();

  /** Integrates to a later time. Throws SolveError with the time where it stopped, after which there is no going on. */
  void advance(double time);

  double time() const;
  const std::vector<double> &y() const;
  const std::vector<double> &rate() const;
  /** Integral of the dissipated power since the start. */
  double dissipated() const;
  IdaStatistics statistics() const;

private:
  class Implementation;
  std::unique_ptr<Implementation> implementation;
};
} // namespace pellicle

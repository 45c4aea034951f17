// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/solvers/equilibrium_problem.h>

#include <vector>

namespace pellicle
{
/**
 * An equilibrium problem R(x; p) = 0 with a number p that may be varied: a load, a coefficient, the target of a
 * constraint. What continuation needs to know of it.
 *
 * Directions are increments in a chart of the problem's own. The chart must stay the same from one begin_step() or
 * recall() to the next begin_step(): the tangent of a step refers to it.
 */
class ParametrisedProblem : public EquilibriumProblem
{
public:
  virtual double parameter() const = 0;
  /** Gives p another value at the same x and evaluates what depends on it. May throw SolveError. */
  virtual void set_parameter(double value) = 0;
  /** dR/dp at fixed x, at the linearised state; as long as a direction. Of a constraint g = p: -1 in its row. */
  virtual std::vector<double> residual_derivative() = 0;

  /**
   * Non-negative weights m_i of a direction's entries in the arc length ds^2 = sum_i m_i dx_i^2 + (dp/scale)^2. They
   * make the first sum dimensionless: for a surface of area A and length R, m = (area of the node)/(A R^2) for
   * displacements, and 0 for internal fields, multipliers and gauge rows.
   */
  virtual std::vector<double> weights() const = 0;
  /** The change of p that counts as much as displacements of the order of the length; > 0. */
  virtual double parameter_scale() const = 0;

  /** Called at a converged state before each step but the first: the moment to renew the chart. Returns whether
   * directions have changed their meaning; an old direction must still resemble the new one with the same entries. */
  virtual bool begin_step() = 0;

  /** Keeps state, parameter and chart, in place of what was kept before. */
  virtual void remember() = 0;
  /** Goes back to what was kept, as often as asked. The matrix and the residual need not be those of that state. */
  virtual void recall() = 0;
};
} // namespace pellicle

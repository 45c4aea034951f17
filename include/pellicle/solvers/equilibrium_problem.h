// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/sparse_matrix.h>

#include <vector>

namespace pellicle
{
/**
 * What Newton's method needs to know of a problem: stationary points of an energy under constraints, in unknowns whose
 * meaning is not its business. A direction holds nodal unknowns first, then increments of multipliers, then gauge rows.
 *
 * The merit of a state along a direction is the energy (internal fields eliminated) plus the constraint terms with the
 * multipliers that the full step would give, plus a quadratic penalty of the constraint violation: never the norm of
 * the residual, which leads to saddles.
 */
class EquilibriumProblem
{
public:
  virtual ~EquilibriumProblem() = default;

  /** Assembles matrix and residual at the current state. */
  virtual void linearize()                            = 0;
  virtual const SparseMatrix &matrix() const          = 0;
  virtual const std::vector<double> &residual() const = 0;

  /** Norm of the residual relative to the norm of the sum of the cells' absolute contributions to it. */
  virtual double relative_residual() const = 0;
  /** Largest violation of a constraint relative to its target. */
  virtual double constraint_violation() const = 0;

  /** Adds a drag (zeta/2)|x - x_n|^2 (weighted by area, x_n the current state) to the matrix; calls add up. */
  virtual void add_drag(double zeta) = 0;

  /** Whether the equations are the derivative of the merit (false for charts with mesh equations). */
  virtual bool is_variational() const = 0;
  /** Negative pivots of the matrix at a stable equilibrium: internal fields, constraints, gauge rows. */
  virtual int expected_negative_pivots() const = 0;

  /** Derivative of the merit along a direction, at the current state. */
  virtual double merit_slope(const std::vector<double> &direction) const = 0;
  /** Merit of the current state, with the multipliers of the full step along the direction. */
  virtual double merit(const std::vector<double> &direction) const = 0;
  /** Moves to current state + length * direction (a trial) and returns its merit; not finite if the trial makes no
   * sense. */
  virtual double try_step(const std::vector<double> &direction, double length) = 0;
  /** Makes the last trial the current state and takes over the full step's multipliers. */
  virtual void accept_trial() = 0;
  /** Largest displacement of a node along a direction, relative to the problem's length. */
  virtual double displacement(const std::vector<double> &direction) const = 0;

  /** Energy of the current state, for reports. */
  virtual double energy() const = 0;
};
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/sparse_matrix.h>

#include <cstddef>
#include <vector>

namespace pellicle
{
/**
 * A differential-algebraic system F(t, y, y') = 0 that dissipates: what an integrator needs to know of it. Unknowns
 * that occur without their rates are algebraic; the system is of index 1 if F can be solved for these and for the rates
 * of the others. Vectors are complete and equal on every process.
 */
class ImplicitSystem
{
public:
  virtual ~ImplicitSystem() = default;

  /** For each unknown whether its rate occurs. */
  virtual const std::vector<bool> &is_differential() const = 0;
  std::size_t size() const { return is_differential().size(); }

  /** F. Throws SolveError where it is not defined: the integrator then tries a shorter step. */
  virtual void residual(double time, const std::vector<double> &y, const std::vector<double> &rate,
                        std::vector<double> &result) = 0;
  /** dF/dy + alpha dF/dy', valid until the next call (each process holds its share of the sum). */
  virtual const SparseMatrix &tangent(double time, const std::vector<double> &y, const std::vector<double> &rate,
                                      double alpha) = 0;
  /** Energy dissipated per unit of time, >= 0; the integrator integrates it along with the unknowns. */
  virtual double dissipated_power(const std::vector<double> &y, const std::vector<double> &rate) = 0;
};
} // namespace pellicle

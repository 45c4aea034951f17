// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/solvers/bordered_solver.h>
#include <pellicle/solvers/parametrised_problem.h>

#include <vector>

namespace pellicle
{
/** Increment of state and parameter along a branch. */
struct Tangent
{
  std::vector<double> direction;
  double parameter = 0.;
};

/** The scalar product <a, b> = sum_i m_i a_i b_i + a_p b_p/scale^2 of a problem (ParametrisedProblem::weights). */
class ArcLengthMetric
{
public:
  explicit ArcLengthMetric(const ParametrisedProblem &problem);

  double product(const Tangent &a, const Tangent &b) const;
  double length(const Tangent &a) const;
  /** Scales to length one. Throws SolveError if the length is zero or not finite. */
  void normalize(Tangent &tangent) const;
  /** Row and corner of the equation <tangent, .> = 0; no column. */
  Border orthogonality(const Tangent &tangent) const;

private:
  std::vector<double> weights;
  double parameter_scale;
};

/**
 * The same equations without a merit: Newton's method takes full steps and converges to minima and saddles alike.
 * Unstable branches consist of the latter. Adds up the accepted steps, for who wants to know how far it went.
 */
class StationaryProblem : public EquilibriumProblem
{
public:
  explicit StationaryProblem(EquilibriumProblem &inner)
      : inner(inner)
  {
  }

  void linearize() override;
  const SparseMatrix &matrix() const override { return inner.matrix(); }
  const std::vector<double> &residual() const override { return inner.residual(); }
  double relative_residual() const override { return inner.relative_residual(); }
  double constraint_violation() const override { return inner.constraint_violation(); }
  void add_drag(const double zeta) override { inner.add_drag(zeta); }
  bool is_variational() const override { return false; }
  int expected_negative_pivots() const override { return inner.expected_negative_pivots(); }
  double merit_slope(const std::vector<double> &) const override { return 0.; }
  double merit(const std::vector<double> &) const override { return 0.; }
  /** Zero, or infinite if the trial makes no sense. */
  double try_step(const std::vector<double> &direction, double length) override;
  void accept_trial() override;
  double displacement(const std::vector<double> &direction) const override { return inner.displacement(direction); }
  double energy() const override { return inner.energy(); }

  /** Sum of the accepted steps since the first linearisation. */
  const std::vector<double> &moved() const { return accepted; }

private:
  EquilibriumProblem &inner;
  std::vector<double> trial, accepted;
};

/**
 * R(x; p) = 0 with p as one more unknown, on the plane <t, (x, p) - (x_1, p_1)> = 0 through the predicted point
 * (x_1, p_1) = (x_0, p_0) + length t (Keller, "Numerical solution of bifurcation and nonlinear eigenvalue problems",
 * 1977). Every increment is orthogonal to t, so that the residual of that last equation is zero throughout.
 *
 * matrix() is that of the problem alone, without the last row and column: to be solved by a BorderedSolver with
 * border(). Directions and residuals are one entry longer.
 */
class ArcLengthProblem : public StationaryProblem
{
public:
  /** Keeps references to all three. reach: the length of the correction beyond which it gives up, see accept_trial().
   */
  ArcLengthProblem(ParametrisedProblem &problem, const ArcLengthMetric &metric, const Tangent &tangent, double reach);

  /** Moves from the present state along the tangent; false (and still there) if that makes no sense. */
  bool predict(double length);

  const Border &border() const { return arc_border; }

  void linearize() override;
  const std::vector<double> &residual() const override { return extended_residual; }
  double try_step(const std::vector<double> &direction, double length) override;
  /**
   * Throws SolveError when the correction, from the predicted state on, is longer than the reach: the plane may meet
   * the branch again far away, and Newton's method may go there.
   */
  void accept_trial() override;
  /** The larger of the nodes' displacement and |dp|/scale: a state whose parameter moves is not at rest. */
  double displacement(const std::vector<double> &direction) const override;

private:
  void take_trial();

  ParametrisedProblem &problem;
  const ArcLengthMetric &metric;
  const Tangent &tangent;
  const double reach;
  Border arc_border;
  std::vector<double> extended_residual;
  double trial_parameter = 0., predicted_parameter = 0.;
};
} // namespace pellicle

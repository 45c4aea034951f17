// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace pellicle
{
/**
 * Books of a motion that only dissipates: the energy E and what has been dissipated since the start,
 * W = integral of 2D dt, D the dissipation potential, quadratic in the rates. dE/dt = -2D makes E(t) + W = E(0).
 */
class EnergyBalance
{
public:
  /** `scale`: magnitude of the energies of which E is the sum; round-off is relative to it. */
  explicit EnergyBalance(double energy, double scale = 0.);

  /**
   * A minimising step to energy E', whose length times D is `step_dissipation`: it is the minimum of E' + dt D, and not
   * moving would have cost E, hence the discrete energy law E' + dt D <= E. Books 2 dt D.
   *
   * Throws SolveError with the numbers if the law is violated by more than round-off: the step is no minimum.
   */
  void add_minimising_step(double energy, double step_dissipation);

  /** Where an integrator is that has added up W by itself. */
  void set(double energy, double dissipated);

  /** E. */
  double energy() const { return present; }
  /** W. */
  double dissipated() const { return work; }
  /** (E(t) - E(0) + W)/W: of the order of the step for minimising steps, within the tolerances for an integrator that
   * has them. Zero while nothing has moved. */
  double relative_error() const;

private:
  double start, present, scale;
  double work = 0.;
};
} // namespace pellicle

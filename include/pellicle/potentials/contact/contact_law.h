// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace pellicle
{
/**
 * Contact of a point without adhesion, g >= 0, t >= 0, g t = 0, by an augmented Lagrangian with the multiplier lambda
 * and the penalty eps (pressure/length):
 *
 *     energy    ([lambda - eps g]_+^2 - lambda^2)/(2 eps)        = -lambda g + eps g^2/2 in contact,
 *     pressure  t = [lambda - eps g]_+ = -d(energy)/dg,
 *     stiffness d2(energy)/dg2 = eps in contact, else 0,
 *
 * all per area. With lambda = 0 it is the penalty method. lambda <- t (update_multipliers) makes the law exact.
 */
struct ContactResponse
{
  double energy = 0., pressure = 0., stiffness = 0.;

  ContactResponse(const double gap, const double multiplier, const double penalty)
  {
    pressure = multiplier - penalty * gap;
    if (pressure > 0.)
    {
      energy    = (0.5 * penalty * gap - multiplier) * gap;
      stiffness = penalty;
    }
    else
    {
      pressure = 0.;
      energy   = -0.5 * multiplier * multiplier / penalty;
    }
  }
};

/** What update_multipliers() found. */
struct ContactUpdate
{
  /** Largest |min(g, lambda/eps)| with the old multipliers, a length: how far they and the gaps are from the law. */
  double violation     = 0.;
  std::size_t n_active = 0; ///< points with a pressure
};

/** Uzawa's step lambda <- [lambda - eps g]_+ at all points, from the gaps of an equilibrium with the old lambda. */
ContactUpdate update_multipliers(std::vector<double> &multipliers, const std::vector<double> &gaps, double penalty);
} // namespace pellicle

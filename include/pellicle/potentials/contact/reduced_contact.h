// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/kinematics/gap.h>

#include <array>

namespace pellicle
{
/** Inputs of reduced_contact(): x, x,1 and x,2, and the multiplier p of the point. */
constexpr unsigned int n_reduced_contact_inputs = 10;

/** r_i and K_ij = dr_i/dinput_j at [i * n_reduced_contact_inputs + j], per unit of parametric area. */
struct ReducedContact
{
  std::array<double, n_reduced_contact_inputs> residual{};
  std::array<double, n_reduced_contact_inputs * n_reduced_contact_inputs> tangent{};
};

/**
 * Contact in the reduced form (66) of Sauer 2014 with its exact linearisation (145), for comparison with RigidContact:
 * the change of area is left out of the residual, but the area is the current one,
 *
 *     r_x = -t n_p J,    r_p = (t - p) J/eps  (-g J in contact),    t = [p - eps g]_+.
 *
 * There is no energy with this gradient: K is not symmetric. In contact
 *
 *     K - K^T = -(t dg + g dp) (x) dJ + dJ (x) (t dg + g dp).
 */
ReducedContact reduced_contact(const RigidBody &body, const std::array<double, n_reduced_contact_inputs> &inputs,
                               double penalty);
} // namespace pellicle

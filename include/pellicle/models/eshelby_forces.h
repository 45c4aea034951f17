// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/line_shift.h>

#include <map>

namespace pellicle
{
class SurfaceProblem;

/** Name of the energy that a line dissipates; it is no part of the force that has to overcome it. */
constexpr const char *line_friction_energy = "line pinning";

/** Eshelby's force at a node of a contact line on a soft substrate. */
struct EshelbyForce
{
  double outwards = 0.; ///< -dE/ds_i of energies + multipliers . constraints, the friction left out
  double length   = 0.; ///< dA/ds_i, A the undeformed area inside the line's material points
  /** Per length of the line of material points; in space, of nodes that neighbours hold back, a mean around them. */
  double per_length() const { return outwards / length; }
};

/**
 * Eshelby's forces at the present state, with s_i the numbers of the line's nodes: X_I = X0_I + s_i w_I nu_I for all
 * nodes I that i leads. On a meridian dA/ds = 2 pi R. In a problem with the field "material position".
 */
std::map<std::size_t, EshelbyForce> eshelby_forces(const SurfaceProblem &problem, const EdgeLoop &line,
                                                   const LineShift &shift);
} // namespace pellicle

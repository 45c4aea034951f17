// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>
#include <pellicle/potentials/wetting/substrate_chart.h>

#include <cstddef>
#include <map>

namespace pellicle
{
class SurfaceProblem;

/** At a node I of a contact line, along the direction m across the line, tangential to the substrate and away from the
 * wetted base. */
struct LineForce
{
  double pull   = 0.; ///< d/dx_I . m of the liquid's energies and constraints: integral of gamma cos(theta) N_I ds
  double length = 0.; ///< dS/dx_I . m of the wetted area S: integral of N_I ds
  Vector3<double> across;
};

/** By node, at the problem's present state. pull = gamma cos(theta) length at every node is what an equilibrium with
 * the wetting energy -gamma cos(theta) S fulfils, to round-off. */
std::map<std::size_t, LineForce> line_forces(const SurfaceProblem &problem, const EdgeLoop &line,
                                             const SubstrateChart &substrate);
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/kinematics/vector3.h>
#include <pellicle/models/surface_problem.h>

#include <optional>

namespace pellicle
{
/**
 * The state of a problem on another mesh of the same scene: refined, in places or everywhere, or of another degree.
 * None if there is no way from one mesh to the other (MeshTransfer::is_possible()), or if the problems differ in fields
 * or constraints.
 *
 * - Fields take the values of the solved problem's polynomials. Where potentials refer to material points, it is the
 *   change since the start that is carried over, for the nodes of both meshes start at places of their own.
 * - A node keeps to the directions that symmetry and conditions leave it, seen from its place at the start, and to the
 *   body on which it stays. What is held stays where it started.
 * - Unit vectors are normalised, fields of edges are zero elsewhere, multipliers are copied, reactions of rigid motions
 *   are left out: they belong to a chart.
 *
 * @param to     as it was built: its present state is its start.
 * @param shift  of the origin of the second problem's coordinates in those of the first one.
 */
std::optional<SurfaceState> transferred_state(const SurfaceProblem &from, const SurfaceProblem &to,
                                              const Vector3<double> &shift);
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/function_of_place.h>
#include <pellicle/discretization/surface_discretization.h>
#include <pellicle/kinematics/vector3.h>

#include <vector>

namespace pellicle
{
/**
 * Motions of a drop over the height field z = H(x, y) that change neither the substrate nor the potential of the force:
 * shifts along grooves and planes, as far as they do not lift the drop, and the rotation about z or a plane's normal.
 * Found from the gradient of H at places up to `reach` from the origin (nothing is found where it is not finite).
 */
std::vector<RigidMotion> free_motions_over(const FunctionOfPlace &H, double reach, const Vector3<double> &force);
} // namespace pellicle

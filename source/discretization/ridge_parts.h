// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/ridge_mesh.h>

#include <vector>

namespace pellicle
{
/** A surface, and whether each of its cells is within the contact line. */
struct SurfacePart
{
  SurfaceDiscretization surface;
  std::vector<bool> within;
};

/** The top of the substrate of ridge_in_space(), in z = 0, n = e_z. */
SurfacePart ridge_top(const RidgeShape &shape, const RidgePlanShape &plan);

/**
 * The spherical cap: a disc whose distances from the axis become polar angles, with as many nodes on the contact line
 * as the top. The drop is smooth up to the line: its cells need not be as small there as the substrate's.
 */
SurfaceDiscretization ridge_cap(const RidgeShape &shape, const RidgePlanShape &plan);
} // namespace pellicle

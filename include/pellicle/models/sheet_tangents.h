// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>

#include <cstddef>
#include <map>

namespace pellicle
{
/**
 * Unit vectors at the nodes of a line, tangential to one sheet of the surface (one of its regions), orthogonal to the
 * line and pointing from the line into the sheet: the direction in which the sheet's tension pulls at the line. The
 * mean over the cells of the sheet that meet at the node along the line. They converge with the sheet's slope there,
 * order k on smooth sheets, slowly where a solid below has a singular corner.
 */
std::map<std::size_t, Vector3<double>> sheet_tangents(const SurfaceDiscretization &surface,
                                                      const NodalVectors &positions, const EdgeLoop &line,
                                                      unsigned int region);
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/models/cell_geometry.h>

#include <vector>

namespace pellicle
{
/** Where a line parallel to z passes through the surface. */
struct AxisCrossing
{
  double z      = 0.;
  int direction = 0; ///< +1 if the line, followed upwards, leaves the enclosed volume here, -1 if it enters
};

/**
 * All crossings of the line x = x_axis, y = y_axis with a surface (not a meridian), in ascending z. A crossing on an
 * edge or at a vertex counts once, however many cells meet there.
 */
std::vector<AxisCrossing> axis_crossings(const CellGeometry &geometry, double x_axis, double y_axis);

/** Length of the line inside the volume: sum of direction * z. Quiet nan if entries and exits are not equally many, as
 * where the line is tangent to the surface. */
double length_inside(const std::vector<AxisCrossing> &crossings);
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/models/surface_model.h>

namespace pellicle
{
/** Contact angles along a line in degrees, and the line's normal pull on its body. */
struct ContactLineMeasures
{
  double mean = 0., smallest = 0., largest = 0.;
  double normal_pull = 0.; ///< integral of gamma sin(theta) along the line, internal units
};

/**
 * gamma cos(theta) is the tangential force with which the liquid-gas surface and the liquid pull at a node of the line,
 * over the wetted area that moving it would gain (line_forces.h). It converges faster than the angle between the
 * surfaces, and where the line is free to move it is the wetting's angle exactly, where it slips with friction the
 * advancing or receding one.
 */
ContactLineMeasures measure_contact_line(const SurfaceModel &model, const EdgeLoop &line);
} // namespace pellicle

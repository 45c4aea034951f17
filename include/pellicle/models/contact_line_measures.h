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
 * Of the contact line of the given name. gamma cos(theta) is the force across the line, tangential to the body, with
 * which liquid-gas surface and liquid pull at it. It converges at twice the order of the angle between the surfaces,
 * and on lines that are free to move it is the wetting's angle exactly.
 */
ContactLineMeasures measure_contact_line(const SurfaceModel &model, const EdgeLoop &line);
} // namespace pellicle

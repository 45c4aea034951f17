// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/models/surface_scene.h>

#include <vector>

namespace pellicle
{
/**
 * Quantities of a drop, internal units: `contact_radius` (of the circle with the wetted area), `contact_angle_degrees`
 * with `_min` and `_max` in space, `apex_height` (largest z), `volume`, `liquid_gas_area`, `solid_liquid_area`,
 * `base_pressure_force` (z component of the liquid's push on the wetted base), `liquid_weight` (rho g V).
 *
 * The contact angle is that of the balance of forces at the line's nodes: gamma cos(theta) is the tangential force with
 * which the liquid-gas surface and the liquid pull at the line, over the wetted area that it would gain (line_forces.h).
 * It converges faster than the angle between the surfaces, and where the line is free to move it is the wetting's angle
 * exactly, where it slips with friction the advancing or receding one.
 */
std::vector<NamedQuantity> measure_droplet(const SurfaceModel &model);
} // namespace pellicle

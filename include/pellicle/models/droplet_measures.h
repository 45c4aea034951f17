// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/models/surface_scene.h>

#include <vector>

namespace pellicle
{
/**
 * Quantities of a drop, internal units: `apex_height` (largest z), `volume`, `liquid_weight` (rho g V),
 * `liquid_gas_area`, `solid_liquid_area`, `contact_radius` (of the circle with the wetted area of the substrate),
 * `base_pressure_force` (z component of the liquid's push on that area), with a contact line `contact_angle_degrees`
 * (in space also `_min` and `_max`), with an upper plate `plate_force` (positive: it pushes the plates apart).
 *
 * Without a contact line the substrate carries F, the sum of the nodal contact forces, and the wetted area is F/p, p
 * the pressure in the liquid there: the active nodes alone would tell it to one cell only.
 */
std::vector<NamedQuantity> measure_droplet(const SurfaceModel &model);
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/models/surface_model.h>

namespace pellicle
{
/**
 * Quantities of a drop on a soft substrate, internal units: volume, weight, areas; apex_height over the mean height
 * of the line (on a rigid plane the height over that), apex_elevation over the undeformed top; the line's place in
 * space and in the material; apparent contact angle (of the cap's tangent at the line with the horizontal); Neumann
 * angles of the three sheets by their tangents at the line, which converge slowly, for the solid has a singular corner
 * there; line_force_imbalance, the force of the solid on the line over gamma_LG, which vanishes with the cells where
 * Neumann's triangle closes; reaction of what holds the substrate.
 */
std::vector<NamedQuantity> measure_ridge(const SurfaceModel &model);
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/models/surface_model.h>

#include <string>

namespace pellicle
{
/** A reported quantity by its name, in the user's units. Asserts that the model reports it. */
double headline_of(const SurfaceModel &model, const std::string &quantity);

/**
 * The same for a state that is close to an equilibrium but does not fulfil its constraints yet. An energy E gains
 *
 *     sum over the constraints of lambda (g - g_0),
 *
 * and is then, by way of the Lagrangian's being stationary, that of the equilibrium up to the square of the distance.
 */
double headline_near(const SurfaceModel &model, const std::string &quantity);

/** What values of the quantity count as at least, in the user's units: a flat membrane has no bending energy, and no
 * error relative to it. */
double smallest_headline(const SurfaceScene &scene);
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/solids/body_pressure.h>
#include <pellicle/potentials/solids/volume_laws.h>

namespace pellicle
{
/**
 * p_f (1 - J) per reference volume with the pressure p_f. With a compliance 1/K > 0 the liquid is compressible,
 * p_f (1 - J) - p_f^2/(2 K): stationary at the pressure K (1 - J) of CompressibleLiquid, but cell by cell in the mean
 * only. A liquid at rest has one J everywhere; asked for at every quadrature point, that is more than cells near a
 * curved surface can do.
 *
 * Alone a liquid, without stiffness against shear (see ShearDrag); beside a neo-Hookean solid with lambda = 0, an
 * incompressible solid whose pressure is p_f. `IncompressibleLiquid{{compliance}, reference}`.
 */
using IncompressibleLiquid = OnGivenReference<BodyPressure<LinearVolumeLaw>>;
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/bulk_measures.h>
#include <pellicle/potentials/reference_metric.h>

#include <memory>
#include <vector>

namespace pellicle
{
/** Regions of the surface of a drop on a soft substrate, beside `liquid_gas_region`: the wetted and the dry part of the
 * substrate's top, and the body below. The wetted part has its normal downwards, out of the liquid. */
constexpr const char *solid_liquid_region = "solid liquid";
constexpr const char *solid_gas_region    = "solid gas";
constexpr const char *substrate_body      = "substrate";

/** Forces per undeformed length between which a contact line stays on its material points: with f = -dE/ds, s outwards
 * over the undeformed surface, it does so while -receding <= f <= advancing. 0 and 0: it is free; inf: never that way.
 */
struct LineThresholds
{
  double advancing = 0.;
  double receding  = 0.;
};

/** What the effects of a drop on a soft substrate take from the scene beside DropletTargets, internal units. */
struct RidgeTargets
{
  double solid_liquid_tension = 0.; ///< gamma_SL
  double solid_gas_tension    = 0.; ///< gamma_SG
  double young_modulus        = 1.; ///< E of small strains
  double poisson_ratio        = 0.; ///< nu in (-1, 1/2]; 1/2: incompressible
  /** Factor on all tensions, 0 to 1 along the load path (already in the tensions above and in that of the drop). */
  double load = 1.;
  /** Whether the contact line moves over the material, so that "material position" is a field with unknowns. */
  bool line_is_free         = false;
  LineThresholds thresholds = {}; ///< of a free line, from "free contact line"
  /** Bases of the undeformed substrate at its quadrature points, and metric of the undeformed surface at its own; null
   * while a scene is only checked. */
  std::shared_ptr<const std::vector<ReferenceBasis>> bulk_reference  = nullptr;
  std::shared_ptr<const std::vector<ReferenceMetric>> skin_reference = nullptr;
};
} // namespace pellicle

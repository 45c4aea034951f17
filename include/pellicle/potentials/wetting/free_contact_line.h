// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/effect.h>

namespace pellicle
{
/** Section "Free contact line", in the user's units. */
struct FreeContactLineParameters
{
  double advancing_threshold = 0.; ///< force/length
  double receding_threshold  = 0.;

  void bind(ParameterSection &section);
};

/**
 * The effect "free contact line": the line moves over the material of a soft substrate. It is in equilibrium where
 * Eshelby's force f = -dE/ds per undeformed length vanishes, s the distance by which the line has moved outwards over
 * the undeformed surface; with thresholds it stays on its material points while -receding <= f <= advancing
 * (LineThresholds), the hysteresis of soft solids.
 *
 * The densities of the other effects read the field "material position" (RidgeTargets::line_is_free); this one adds no
 * energy, and while Contact line/Motion = pinned it has no meaning. What follows from the thresholds is an active set
 * of the model.
 */
class FreeContactLineEffect : public Effect
{
public:
  FreeContactLineParameters parameters;

  const std::string &name() const override;
  std::string description() const override;
  void bind(ParameterSection &section) override { parameters.bind(section); }
  /** Throws UserError for a line that could never move. */
  void check() const override;
  void prepare(const Scales &scales, SceneTargets &targets) const override;
  /** Nothing; throws UserError in a scene without a soft substrate. */
  void contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const override;
};
} // namespace pellicle

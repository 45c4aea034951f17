// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/effect.h>

namespace pellicle
{
/** Section "Line pinning", in the user's units. */
struct LinePinningParameters
{
  double advancing_angle = 180.; ///< degrees
  double receding_angle  = 0.;   ///< degrees

  void bind(ParameterSection &section);
};

/**
 * The effect "line pinning": contact angle hysteresis. It tells the scene the angles between which the contact line
 * sticks; what follows from them is an active set of the model (models/line_pinning.h).
 */
class LinePinningEffect : public Effect
{
public:
  LinePinningParameters parameters;

  const std::string &name() const override;
  std::string description() const override;
  void bind(ParameterSection &section) override { parameters.bind(section); }
  /** Throws UserError unless there is a hysteresis. */
  void check() const override;
  void prepare(const Scales &scales, SceneTargets &targets) const override;
  /** Nothing: the friction depends on where the line sticks. */
  void contribute(const Scales & /*scales*/, const SceneTargets & /*targets*/, PotentialSet & /*set*/) const override {}
};
} // namespace pellicle

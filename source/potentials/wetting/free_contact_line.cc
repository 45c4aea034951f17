// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/potentials/wetting/free_contact_line.h>

#include <cmath>

namespace pellicle
{
void FreeContactLineParameters::bind(ParameterSection &section)
{
  section.number(
      "Advancing threshold", advancing_threshold, Range::non_negative().or_infinite(), dimensions::tension,
      "Outward force per undeformed length of the contact line (Eshelby's: minus the derivative of the energy "
      "by the material the line is bound to) beyond which it advances. 0: at any. inf: it never does.");
  section.number("Receding threshold", receding_threshold, Range::non_negative().or_infinite(), dimensions::tension,
                 "The same inwards, beyond which the line recedes.");
}

const std::string &FreeContactLineEffect::name() const
{
  static const std::string text = "free contact line";
  return text;
}

std::string FreeContactLineEffect::description() const
{
  return "The contact line moves over the material of a soft substrate until Eshelby's force on it vanishes, or is "
         "within Advancing threshold outwards and Receding threshold inwards.";
}

void FreeContactLineEffect::check() const
{
  if (std::isinf(parameters.advancing_threshold) && std::isinf(parameters.receding_threshold))
    throw UserError(
        "Free contact line/Advancing threshold and Receding threshold are both inf: the line can never move. "
        "Give one of them a finite value, or pin the line (Contact line/Motion = pinned, without 'free "
        "contact line' in Effects).");
}

void FreeContactLineEffect::prepare(const Scales &scales, SceneTargets &targets) const
{
  if (!targets.substrate)
    return;
  const FreeContactLineParameters internal = scaled(parameters, scales);
  targets.substrate->thresholds            = {internal.advancing_threshold, internal.receding_threshold};
}

void FreeContactLineEffect::contribute(const Scales & /*scales*/, const SceneTargets &targets,
                                       PotentialSet & /*set*/) const
{
  targets.soft_substrate();
}
} // namespace pellicle

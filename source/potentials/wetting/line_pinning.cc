// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/constants.h>
#include <pellicle/base/exact_text.h>
#include <pellicle/potentials/wetting/line_pinning.h>

namespace pellicle
{
void LinePinningParameters::bind(ParameterSection &section)
{
  section.number("Advancing angle", advancing_angle, Range::between(0., 180.), dimensions::none,
                 "Contact angle theta_A in degrees at which the line advances, at least Droplet/Contact angle. 180: it "
                 "never does.");
  section.number("Receding angle", receding_angle, Range::between(0., 180.), dimensions::none,
                 "Contact angle theta_R in degrees at which the line recedes, at most Droplet/Contact angle. 0: it "
                 "never does.");
}

const std::string &LinePinningEffect::name() const
{
  static const std::string text = "line pinning";
  return text;
}

std::string LinePinningEffect::description() const
{
  return "Contact angle hysteresis: the line sticks while theta_R < theta < theta_A; slip dissipates gamma "
         "|cos(theta_Y) - cos(theta)| per swept area, theta_Y of 'wetting'.";
}

void LinePinningEffect::check() const
{
  if (parameters.receding_angle >= parameters.advancing_angle)
    throw UserError("Line pinning/Receding angle = " + exact_text(parameters.receding_angle) +
                    " must be below Line pinning/Advancing angle = " + exact_text(parameters.advancing_angle) +
                    ". A line that does not stick needs no 'line pinning' in Effects.");
}

void LinePinningEffect::prepare(const Scales & /*scales*/, SceneTargets &targets) const
{
  if (targets.droplet)
    targets.droplet->pinning =
        PinningAngles{parameters.advancing_angle * pi / 180., parameters.receding_angle * pi / 180.};
}
} // namespace pellicle

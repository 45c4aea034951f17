// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/potentials/dissipations/director_friction.h>

namespace pellicle
{
void DirectorFrictionParameters::bind(ParameterSection &section)
{
  section.number("Friction", friction, Range::positive(), dimensions::friction,
                 "Friction eta of directors that turn: they dissipate eta |O_t|^2 per area and time.");
  section.choice(
      "Frame", frame, {"lab", "objective"},
      "What directors turn against. lab: a medium at rest, O_t at a material point. objective: the membrane, "
      "O_t - omega x O with omega its spin. The same if the surface is held.");
}

const std::string &DirectorFrictionEffect::name() const
{
  static const std::string text = "director friction";
  return text;
}

std::string DirectorFrictionEffect::description() const
{
  return "Friction of turning directors: dissipation potential (eta/2) |O_t|^2 per area, or (eta/2) |O_t - omega x "
         "O|^2 with the membrane's spin omega. A scene with it moves in time (section Time).";
}

void DirectorFrictionEffect::contribute(const Scales &scales, const SceneTargets & /*targets*/, PotentialSet &set) const
{
  const double friction = scaled(parameters, scales).friction;
  set.dissipations.push_back(parameters.frame == "lab" ? make_dissipation(name(), DirectorFrictionInLab{friction})
                                                       : make_dissipation(name(), ObjectiveDirectorFriction{friction}));
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exact_text.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/potentials/constraints/tether.h>
#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/energies/surface_tension.h>

namespace pellicle
{
void TetherParameters::bind(ParameterSection &section)
{
  section.choice(
      "Control", control, {"length", "force"},
      "What is given. length: Length. force: Force; the force that is needed first rises above the plateau 2 pi "
      "sqrt(2 kappa sigma), has a maximum there (a fold) and falls back.");
  section.number("Length", length, Range::any(), dimensions::length,
                 "Height L of the tip above the plane of the ring, for Control = length.");
  section.number("Force", force, Range::any(), dimensions::line_tension,
                 "Force on the tip for Control = force, positive outwards.");
  section.number("Ring radius", ring_radius, Range::positive(), dimensions::length,
                 "Radius of the outer ring, at which the membrane is clamped flat.");
  section.number("Tip radius", tip_radius, Range::positive(), dimensions::length,
                 "Radius of the tip, a rigid flat disc; the membrane is clamped flat at its rim and leaves it out. The "
                 "highest force of a pull depends on it.");
  section.number("Tension", tension, Range::positive(), dimensions::tension,
                 "Tension sigma of the membrane, in E = sigma A. The tube has the radius sqrt(kappa/(2 sigma)).");
}

namespace
{
/** Of the tip; while a scene is only checked any will do. */
double rim_length(const SceneTargets &targets)
{
  for (const SceneEdge &edge : targets.edges)
    if (edge.name == "tip" && edge.length > 0.)
      return edge.length;
  return 1.;
}
} // namespace

const std::string &TetherEffect::name() const
{
  static const std::string text = "tether";
  return text;
}

std::string TetherEffect::description() const
{
  return "A tube is pulled from a flat membrane under tension by a rigid tip, held at the height Tether/Length; its "
         "multiplier is the force.";
}

void TetherEffect::check() const
{
  if (parameters.tip_radius >= parameters.ring_radius)
    throw UserError("Tether/Tip radius = " + exact_text(parameters.tip_radius) +
                    " must be smaller than Tether/Ring radius = " + exact_text(parameters.ring_radius) + ".");
}

void TetherEffect::contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const
{
  if (!targets.has_bending())
    throw UserError("The effect 'tether' needs the bending energy, which gives the tube its radius: add 'helfrich "
                    "bending' to Effects.");
  const TetherParameters p = scaled(parameters, scales);
  set.energies.push_back(
      std::make_shared<DensityPotential<SurfaceTension>>("surface tension", SurfaceTension{p.tension}));
  set.prescribed.push_back({"tension", p.tension, dimensions::tension});
  const Where tip{Where::Part::edge, "tip"};
  if (p.control == "force")
  {
    set.energies.push_back(
        std::make_shared<DensityPotential<TipHeight>>("tip load", TipHeight{rim_length(targets), -p.force}, tip));
    set.prescribed.push_back({"force", p.force, dimensions::line_tension});
    return;
  }
  Constraint height;
  height.measure    = std::make_shared<DensityPotential<TipHeight>>(name(), TipHeight{rim_length(targets), 1.}, tip);
  height.target     = p.length;
  height.quantity   = "length";
  height.multiplier = "force";
  height.multiplier_sign = -1.;
  height.dimension       = dimensions::length;
  set.constraints.push_back(height);
}

std::vector<ParameterDerivative> TetherEffect::derivatives(const Scales &scales, const SceneTargets &targets) const
{
  const Where tip{Where::Part::edge, "tip"};
  ParameterDerivative control{"Tether/Length", nullptr, "length", 1. / scales.of(dimensions::length)};
  if (parameters.control == "force")
    control = {"Tether/Force",
               std::make_shared<DensityPotential<TipHeight>>(
                   name(), TipHeight{rim_length(targets), -1. / scales.of(dimensions::line_tension)}, tip),
               "", 0.};
  return {
      control,
      {"Tether/Tension",
       std::make_shared<DensityPotential<SurfaceTension>>(name(), SurfaceTension{1. / scales.of(dimensions::tension)}),
       "", 0.}};
}
} // namespace pellicle

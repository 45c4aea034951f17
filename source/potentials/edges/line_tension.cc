// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/edges/line_tension.h>

namespace pellicle
{
namespace
{
bool can_move(const SceneEdge &edge)
{
  return edge.support == EdgeSupport::free || edge.support == EdgeSupport::inner ||
         edge.support == EdgeSupport::on_body;
}
} // namespace

void LineTensionParameters::bind(ParameterSection &section)
{
  section.number(
      "Line tension", line_tension, Range::any(), dimensions::line_tension,
      "Line tension lambda in E = lambda times the length of free rims, contact lines and lines around regions. "
      "Positive: the line wants to be short.");
}

const std::string &LineTensionEffect::name() const
{
  static const std::string text = "line tension";
  return text;
}

std::string LineTensionEffect::description() const
{
  return "Energy lambda times the length of free rims, contact lines and the lines around regions.";
}

void LineTensionEffect::contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const
{
  const double lambda = scaled(parameters, scales).line_tension;
  bool found          = false;
  for (const SceneEdge &edge : targets.edges)
    if (can_move(edge))
    {
      found = true;
      set.energies.push_back(std::make_shared<DensityPotential<LineTension>>(name(), LineTension{lambda},
                                                                             Where{Where::Part::edge, edge.name}));
    }
  if (!found)
    throw UserError(
        "The effect 'line tension' needs a line that can move: an open start shape with Vesicle/Rim = free, "
        "a contact line, or the effect 'lipid domain'.");
}

std::vector<ParameterDerivative> LineTensionEffect::derivatives(const Scales &scales, const SceneTargets &targets) const
{
  std::vector<ParameterDerivative> list;
  for (const SceneEdge &edge : targets.edges)
    if (can_move(edge))
      list.push_back(
          {"Line tension/Line tension",
           std::make_shared<DensityPotential<LineTension>>(
               name(), LineTension{1. / scales.of(dimensions::line_tension)}, Where{Where::Part::edge, edge.name}),
           "", 0.});
  return list;
}
} // namespace pellicle

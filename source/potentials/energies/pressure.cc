// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/energies/pressure.h>

namespace pellicle
{
void PressureParameters::bind(ParameterSection &section)
{
  section.number(
      "Pressure", pressure, Range::any(), dimensions::pressure,
      "Prescribed pressure P, inside minus outside, in E = -P V. Positive: the enclosed volume wants to grow.");
}

const std::string &PressureEffect::name() const
{
  static const std::string text = "pressure";
  return text;
}

std::string PressureEffect::description() const
{
  return "Energy -P V of a prescribed pressure P (inside minus outside).";
}

void PressureEffect::contribute(const Scales &scales, const SceneTargets & /*targets*/, PotentialSet &set) const
{
  const double pressure = scaled(parameters, scales).pressure;
  set.energies.push_back(std::make_shared<DensityPotential<Pressure>>(name(), Pressure{pressure}));
  set.prescribed.push_back({"pressure", pressure, dimensions::pressure});
}

std::vector<ParameterDerivative> PressureEffect::derivatives(const Scales &scales,
                                                             const SceneTargets & /*targets*/) const
{
  return {{"Pressure/Pressure",
           std::make_shared<DensityPotential<Pressure>>(name(), Pressure{1. / scales.of(dimensions::pressure)}), "",
           0.}};
}
} // namespace pellicle

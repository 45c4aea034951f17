// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/director/tilt_energy.h>
#include <pellicle/potentials/effect.h>

namespace pellicle
{
/** Energy (k_n/2) (O . n)^2 per area of directors that leave the surface. In displacement form: loses accuracy for
 * k_n h^2/K above 1, h the distance of nodes and K the modulus of the gradient. */
struct NormalDirectorEnergy : DirectorPartsEnergy
{
  /** k_n, internal units. */
  explicit NormalDirectorEnergy(const double modulus) { form.beta[0][0] = -modulus; }
};

struct InPlaneDirectorsParameters
{
  double modulus = 100.;

  void bind(ParameterSection &section);
};

/** The effect "in-plane directors": directors that prefer to lie in the surface, as in a membrane of rods or of
 * molecules that tilt strongly. The energy is named "normal director". */
class InPlaneDirectorsEffect : public Effect
{
public:
  const std::string &name() const override;
  std::string description() const override;
  void bind(ParameterSection &section) override { parameters.bind(section); }
  /** By In-plane directors/Modulus. */
  std::vector<ParameterDerivative> derivatives(const Scales &scales, const SceneTargets &targets) const override;
  void contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const override;

  InPlaneDirectorsParameters parameters;
};
} // namespace pellicle

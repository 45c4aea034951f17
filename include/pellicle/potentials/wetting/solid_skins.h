// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/effect.h>

namespace pellicle
{
/** Section "Solid skins", in the user's units. */
struct SolidSkinsParameters
{
  double solid_liquid_modulus = 0.; ///< mu_s
  double solid_gas_modulus    = 0.;

  void bind(ParameterSection &section);
};

/**
 * The effect "solid skins": the surface energy of the substrate's top, by default gamma_SL per present area of the
 * wetted part and gamma_SG of the dry one (Tensions/Solid liquid, Tensions/Solid gas), (52) of Sauer 2014. Both act on
 * the body's own nodes.
 *
 * With a shear modulus mu_s the energy depends on strain (Shuttleworth's effect): per area of the undeformed surface
 *
 *     W = gamma J_s + (mu_s/2) (I1_s - 2 - 2 ln J_s),    J_s = l1 l2,  I1_s = l1^2 + l2^2,
 *
 * l1 and l2 the principal stretches, and the Cauchy stress of the surface is
 *
 *     Upsilon = gamma 1 + (mu_s/J_s) (B - 1),    T_1 = gamma + mu_s (l1^2 - 1)/(l1 l2),
 *
 * B = F F^T of the surface: gamma_E + d gamma_E/d epsilon of the energy gamma_E = W/J_s per present area. Under an
 * equal stretch in all directions Upsilon = gamma + mu_s (1 - 1/J_s). Unstretched it is gamma. The undeformed surface
 * is given where the contact line is pinned; where it is free, it is the field "material position", and the skins' own
 * force of Eshelby acts on the line (MovingSkin).
 */
class SolidSkinsEffect : public Effect
{
public:
  SolidSkinsParameters parameters;

  const std::string &name() const override;
  std::string description() const override;
  void bind(ParameterSection &section) override { parameters.bind(section); }
  std::optional<double> typical_energy(double length) const override;
  /** By both tensions. */
  std::vector<ParameterDerivative> derivatives(const Scales &scales, const SceneTargets &targets) const override;
  void contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const override;
};
} // namespace pellicle

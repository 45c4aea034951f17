// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/effect.h>
#include <pellicle/potentials/solids/neo_hookean_solid.h>

#include <string>

namespace pellicle
{
/** Section "Solid". */
struct SolidParameters
{
  std::string volumetric_law = "logarithmic";

  void bind(ParameterSection &section);
};

/**
 * The effect "solid": the soft substrate is a neo-Hookean solid (NeoHookeanSolid) with Young's modulus and Poisson's
 * ratio of the scene. From a Poisson ratio of `mixed_from` on its energy U(J) of changes of volume is in mixed form,
 * with a pressure of its own (BodyPressure); 1/2 is incompressible, J = 1 in the mean of each cell, for both laws.
 *
 * Where the contact line is free, the reference is the field "material position" (OnMovingReference); else it is given.
 */
class SolidEffect : public Effect
{
public:
  /** At nu = .45, lambda = 9 mu, the form in displacements alone has five times the error on the same cells, and at
   * .499 it is useless (tests/potentials/nearly_incompressible.cc). */
  static constexpr double mixed_from = 0.45;
  /** Whether the body needs pressure nodes (add_pressure_nodes()). */
  static bool uses_pressure(const double poisson_ratio) { return poisson_ratio >= mixed_from; }

  SolidParameters parameters;

  const std::string &name() const override;
  std::string description() const override;
  void bind(ParameterSection &section) override { parameters.bind(section); }
  /** By Substrate/Young modulus. */
  std::vector<ParameterDerivative> derivatives(const Scales &scales, const SceneTargets &targets) const override;
  void contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const override;

private:
  VolumetricLaw law() const;
};
} // namespace pellicle

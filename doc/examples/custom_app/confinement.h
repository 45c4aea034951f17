// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/effect.h>

namespace custom
{
/**
 * A membrane held near the plane z = 0, as by a light sheet:
 *
 *     E = integral of (k/2) z^2 dA.
 *
 * On a sphere of radius R about the origin E = (2 pi/3) k R^4.
 */
struct Confinement
{
  static constexpr std::array<pellicle::FieldUse, 1> fields{{{"position", pellicle::Derivatives::first}}};
  static constexpr bool reparametrisation_invariant = true;

  double stiffness = 1.; ///< k, internal units

  template <typename Number>
  Number density(const pellicle::PointInputs<Number, 1> &inputs, const pellicle::PointData & /*data*/) const
  {
    const pellicle::FieldAtPoint<Number> &x = inputs[0];
    const Number z                          = x.value()[2];
    const Number J                          = norm(cross(x.d1(), x.d2())); // dA = J du1 du2
    return 0.5 * stiffness * z * z * J;
  }
};

/** The effect "confinement": what a scene may list, with its section `Confinement`. */
class ConfinementEffect : public pellicle::Effect
{
public:
  const std::string &name() const override
  {
    static const std::string text = "confinement";
    return text;
  }

  std::string description() const override { return "Energy (k/2) z^2 per area, which holds the membrane near z = 0."; }

  void bind(pellicle::ParameterSection &section) override { parameters.bind(section); }

  void contribute(const pellicle::Scales &scales, const pellicle::SceneTargets & /*targets*/,
                  pellicle::PotentialSet &set) const override
  {
    const double stiffness = pellicle::scaled(parameters, scales).stiffness;
    set.energies.push_back(std::make_shared<pellicle::DensityPotential<Confinement>>(name(), Confinement{stiffness}));
  }

  struct Parameters
  {
    double stiffness = 1.;

    void bind(pellicle::ParameterSection &section)
    {
      section.number("Stiffness", stiffness, pellicle::Range::non_negative(), pellicle::Dimension{1, -4},
                     "Stiffness k of the confinement in (k/2) z^2 per area.");
    }
  };
  Parameters parameters;
};
} // namespace custom

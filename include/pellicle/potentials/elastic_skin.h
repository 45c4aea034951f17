// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/kinematics/automatic_differentiation.h>
#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/effect.h>
#include <pellicle/potentials/stretch_invariants.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace pellicle
{
/** J_ref W(T, s) of a law of elastic skins, per unit of parametric area. */
template <typename Law, typename Number, typename Reference>
Number skin_density(const Law &law, const FieldAtPoint<Number> &x, const BasicReferenceMetric<Reference> &A)
{
  const StretchInvariants<Number> stretch(x, A);
  return A.area_element() * law.energy(stretch.T, stretch.s);
}

/** Adds its derivatives by the position, the density's first field. */
template <typename Law>
void add_skin_derivatives(const Law &law, const FieldAtPoint<double> &x, const ReferenceMetric &A,
                          const PointDerivativeView &view)
{
  const StretchDerivatives stretch(x, A);
  using Number   = SecondOrder<2>;
  const Number W = law.energy(seed<Number>(0, stretch.T), seed<Number>(1, stretch.s));
  InvariantDerivatives dW;
  dW.T  = W.val().dx(0);
  dW.s  = W.val().dx(1);
  dW.TT = W.dx(0).dx(0);
  dW.Ts = W.dx(1).dx(0);
  dW.ss = W.dx(1).dx(1);
  stretch.add(dW, 0, view);
}

/**
 * In-plane elasticity E = integral of J_ref W(T, s) over the parameters, with the stretch invariants T and s relative
 * to a reference metric at every quadrature point. W is an energy per area of the reference; its Cauchy tension is
 *
 *     sigma^ab = (2/s) (dW/dT) A^ab + (dW/ds) a^ab,
 *
 * along the principal stretches T_1 = (l1/l2) 2 dW/dT + dW/ds; positive tensions pull. A law is a class with
 *
 *     static constexpr const char *name;             // of the effect
 *     static std::string description();
 *     template <typename Number>
 *     Number energy(const Number &T, const Number &s) const;   // W
 *     double modulus() const;                        // typical of the law, energy/length^2
 *     void bind(ParameterSection &section);          // its moduli
 *
 * The laws that ship have neither energy nor tension at the reference. Evaluating a skin without reference is a
 * mistake of the caller.
 */
template <typename Law>
struct ElasticSkin
{
  static constexpr std::array<FieldUse, 1> fields{{{"position", Derivatives::first, FieldRole::independent}}};
  static constexpr bool reparametrisation_invariant = false;

  Law law;                                                       ///< moduli in internal units
  std::shared_ptr<const std::vector<ReferenceMetric>> reference; ///< by PointData::index

  template <typename Number>
  Number density(const PointInputs<Number, 1> &inputs, const PointData &data) const
  {
    return skin_density(law, inputs[0], reference_at(data));
  }

  void add_derivatives(const PointInputs<double, 1> &inputs, const PointData &data,
                       const PointDerivativeView &view) const
  {
    add_skin_derivatives(law, inputs[0], reference_at(data), view);
  }

private:
  const ReferenceMetric &reference_at(const PointData &data) const
  {
    PELLICLE_ASSERT(reference && data.index < reference->size(), "an elastic skin needs its reference metric");
    return (*reference)[data.index];
  }
};

/** The effect of a law, named as the law is. */
template <typename Law>
class SkinEffect : public Effect
{
public:
  const std::string &name() const override
  {
    static const std::string text = Law::name;
    return text;
  }
  std::string description() const override { return Law::description(); }
  void bind(ParameterSection &section) override { law.bind(section); }
  std::optional<double> typical_energy(const double length) const override { return law.modulus() * length * length; }
  void contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const override
  {
    set.energies.push_back(std::make_shared<DensityPotential<ElasticSkin<Law>>>(
        name(), ElasticSkin<Law>{scaled(law, scales), targets.reference}));
  }

  Law law; ///< moduli in the user's units
};
} // namespace pellicle

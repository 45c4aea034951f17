// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/director/director_fields.h>
#include <pellicle/potentials/director/tangential_form.h>
#include <pellicle/potentials/effect.h>
#include <pellicle/potentials/potential.h>

namespace pellicle
{
/** Energy (k_n/2) (O . n)^2 per area of directors that leave the surface. In displacement form: loses accuracy for
 * k_n h^2/K above 1, h the distance of nodes and K the modulus of the gradient. */
struct NormalDirectorEnergy
{
  static constexpr std::array<FieldUse, 2> fields{
      {{"position", Derivatives::first, FieldRole::independent}, director_field(Derivatives::none)}};
  static constexpr bool reparametrisation_invariant = true;

  double modulus = 1.; ///< k_n, internal units

  template <typename Number>
  Number density(const PointInputs<Number, 2> &inputs, const PointData & /*data*/) const
  {
    return form().density(inputs[0], std::array<Vector3<Number>, 1>{inputs[1].value()});
  }

  void add_derivatives(const PointInputs<double, 2> &inputs, const PointData & /*data*/,
                       const PointDerivativeView &view) const
  {
    form().add_derivatives(inputs[0], {inputs[1].value()}, view);
  }

private:
  TangentialForm<1> form() const
  {
    TangentialForm<1> f;
    f.beta[0][0] = -modulus;
    return f;
  }
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

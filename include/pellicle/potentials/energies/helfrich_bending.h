// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/effect.h>
#include <pellicle/potentials/surface_measures.h>

namespace pellicle
{
/**
 * Helfrich bending in the position/moment form, first derivatives only: stationary (minimum in x, maximum in P) of the
 * integral of
 *
 *     a^ab x,a . P,b - C0 n . P - |P|^2/(2 kappa),
 *
 * whose maximum over P is (kappa/2)(2H + C0)^2 (with the trace of curvature -2H positive on a sphere: C0 > 0 favours
 * convex), attained at the moment P = kappa (-2H - C0) n. Energy of Helfrich 1973; (53)-(55) of Hu, Zhang & E 2007 with
 * the factor 1/2.
 *
 * | code          | symbol                                       |
 * |---------------|----------------------------------------------|
 * | x1, x2        | x,1  x,2                                     |
 * | P, P1, P2     | P  P,1  P,2                                  |
 * | S             | a22 x,1.P,1 - a12 (x,1.P,2 + x,2.P,1) + a11 x,2.P,2 = J^2 a^ab x,a.P,b |
 * | J, n          | J = |x,1 x x,2|, unit normal                 |
 */
struct HelfrichBending
{
  static constexpr std::array<FieldUse, 2> fields{
      {{"position", Derivatives::first, FieldRole::independent}, {"moment", Derivatives::first, FieldRole::internal}}};
  static constexpr bool reparametrisation_invariant = true;

  double kappa = 1.; ///< bending rigidity, internal units
  double C0    = 0.; ///< spontaneous curvature, internal units

  template <typename Number>
  Number density(const PointInputs<Number, 2> &inputs, const PointData & /*data*/) const
  {
    const Vector3<Number> &x1 = inputs[0].d1(), &x2 = inputs[0].d2();
    const Vector3<Number> &P = inputs[1].value(), &P1 = inputs[1].d1(), &P2 = inputs[1].d2();
    const Vector3<Number> N = cross(x1, x2);
    const Number J          = norm(N);
    const Number S = dot(x2, x2) * dot(x1, P1) - dot(x1, x2) * (dot(x1, P2) + dot(x2, P1)) + dot(x1, x1) * dot(x2, P2);
    return S / J - C0 * dot(N, P) - J * dot(P, P) / (2. * kappa);
  }

  void add_derivatives(const PointInputs<double, 2> &inputs, const PointData &data,
                       const PointDerivativeView &view) const;
};

/** factor times -n . P, the derivative of the bending energy with respect to C0. */
std::shared_ptr<const Potential> spontaneous_curvature_derivative(double factor, const Where &where);

struct HelfrichBendingParameters
{
  double bending_rigidity      = 1.;
  double spontaneous_curvature = 0.;

  void bind(ParameterSection &section);
};

/** The effect "helfrich bending". */
class HelfrichBendingEffect : public Effect
{
public:
  const std::string &name() const override;
  std::string description() const override;
  void bind(ParameterSection &section) override { parameters.bind(section); }
  std::optional<double> typical_energy(double length) const override;
  void prepare(const Scales &scales, SceneTargets &targets) const override;
  std::vector<ParameterDerivative> derivatives(const Scales &scales, const SceneTargets &targets) const override;
  void contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const override;

  HelfrichBendingParameters parameters;
};
} // namespace pellicle

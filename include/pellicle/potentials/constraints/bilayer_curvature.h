// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/constants.h>
#include <pellicle/potentials/effect.h>
#include <pellicle/potentials/surface_measures.h>

namespace pellicle
{
/**
 * Integrated mean curvature M, the integral of H_out = -H (4 pi R on a sphere), in the (x, P) form of the bending
 * energy, where curvature is known by way of the moment P alone.
 *
 * With h the outward trace of curvature, E = max over P of P . n (h - C0) - |P|^2/(2 kappa). Adding lambda h/2 moves
 * the maximum to P = kappa (h - C0) n + lambda n/2, and so
 *
 *     E + lambda M = max over P of  E(x, P) + lambda g(x, P) - (lambda^2/2) r(x),
 *     g = integral of (P . n/kappa + C0)/2,      r = integral of 1/(4 kappa),       M = g - lambda r.
 *
 * | code            | symbol              |
 * |-----------------|---------------------|
 * | BilayerCurvature| density of g         |
 * | BilayerSelfTerm | density of r         |
 *
 * (The bilayer-coupling model; Q as in Tu and Ou-Yang.)
 */
struct BilayerCurvature
{
  static constexpr std::array<FieldUse, 2> fields{
      {{"position", Derivatives::first, FieldRole::independent}, {"moment", Derivatives::none, FieldRole::internal}}};
  static constexpr bool reparametrisation_invariant = true;

  std::vector<BendingLaw> laws; ///< by region

  template <typename Number>
  Number density(const PointInputs<Number, 2> &inputs, const PointData &data) const
  {
    const BendingLaw &law        = laws[data.region];
    const Vector3<Number> normal = cross(inputs[0].d1(), inputs[0].d2()); // J n
    return 0.5 * (dot(inputs[1].value(), normal) / law.rigidity + law.spontaneous_curvature * norm(normal));
  }

  void add_derivatives(const PointInputs<double, 2> &inputs, const PointData &data,
                       const PointDerivativeView &view) const;
};

struct BilayerSelfTerm
{
  static constexpr std::array<FieldUse, 1> fields{{{"position", Derivatives::first, FieldRole::independent}}};
  static constexpr bool reparametrisation_invariant = true;

  std::vector<BendingLaw> laws; ///< by region

  template <typename Number>
  Number density(const PointInputs<Number, 1> &inputs, const PointData &data) const
  {
    return area_density(inputs[0]) / (4. * laws[data.region].rigidity);
  }

  void add_derivatives(const PointInputs<double, 1> &inputs, const PointData &data,
                       const PointDerivativeView &view) const
  {
    add_area_derivatives(inputs[0], 0, 1. / (4. * laws[data.region].rigidity), view);
  }
};

struct BilayerCouplingParameters
{
  double integrated_mean_curvature = 4. * pi;

  void bind(ParameterSection &section);
};

/** The effect "bilayer coupling": M = M0, multiplier Q of E + Q (M - M0). Throws UserError without bending. */
class BilayerCouplingEffect : public Effect
{
public:
  const std::string &name() const override;
  std::string description() const override;
  void bind(ParameterSection &section) override { parameters.bind(section); }
  std::vector<ParameterDerivative> derivatives(const Scales &scales, const SceneTargets &targets) const override;
  void contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const override;

  BilayerCouplingParameters parameters;
};

struct AreaDifferenceElasticityParameters
{
  double integrated_mean_curvature = 4. * pi;
  double stiffness                 = 1.;

  void bind(ParameterSection &section);
};

/** The effect "area difference elasticity": energy (kbar/2)(M - M0)^2; Q = kbar (M - M0). Throws UserError without
 * bending. */
class AreaDifferenceElasticityEffect : public Effect
{
public:
  const std::string &name() const override;
  std::string description() const override;
  void bind(ParameterSection &section) override { parameters.bind(section); }
  std::vector<ParameterDerivative> derivatives(const Scales &scales, const SceneTargets &targets) const override;
  void contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const override;

  AreaDifferenceElasticityParameters parameters;
};
} // namespace pellicle

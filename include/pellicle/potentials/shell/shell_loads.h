// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/function_of_place.h>
#include <pellicle/potentials/effect.h>
#include <pellicle/potentials/shell/cosserat_shell.h>

#include <memory>
#include <string>
#include <vector>

namespace pellicle
{
/** E = -integral of p f(X, Y) . (x - X) over the reference: a force per area of the reference that follows neither the
 * shell's rotation nor its stretch. */
struct DeadLoad
{
  static constexpr std::array<FieldUse, 1> fields{{{"position", Derivatives::none, FieldRole::independent}}};
  static constexpr bool reparametrisation_invariant = false;

  Vector3<double> force;                        ///< p, internal units
  std::shared_ptr<const FunctionOfPlace> shape; ///< f, of the place X, Y in internal units; null: 1
  ShellReferences reference;

  template <typename Number>
  Number density(const PointInputs<Number, 1> &inputs, const PointData &data) const
  {
    const ShellReference &D = reference_at(reference, data);
    const Vector3<double> p = (shape ? shape->at(D.place[0], D.place[1]).value : 1.) * D.area * force;
    return dot(p, D.place) - internal::times(p, inputs[0].value());
  }
};

struct DeadLoadParameters
{
  std::vector<double> force{0., 0., -1.};
  double scale = 1.;

  void bind(ParameterSection &section);
};

/** The effect "dead load". */
class DeadLoadEffect : public Effect
{
public:
  const std::string &name() const override;
  std::string description() const override;
  void bind(ParameterSection &section) override { parameters.bind(section); }
  void check() const override;
  std::vector<ParameterDerivative> derivatives(const Scales &scales, const SceneTargets &targets) const override;
  void contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const override;

  DeadLoadParameters parameters;

private:
  std::shared_ptr<const Potential> potential(const Scales &scales, const SceneTargets &targets, double factor) const;
};

/** E = -f . (x - X) at one point, times the weight of its loop. */
struct PointLoad
{
  static constexpr std::array<FieldUse, 1> fields{{{"position", Derivatives::none, FieldRole::independent}}};
  static constexpr bool reparametrisation_invariant = false;

  Vector3<double> force; ///< f, internal units
  Vector3<double> place; ///< X

  template <typename Number>
  Number density(const PointInputs<Number, 1> &inputs, const PointData & /*data*/) const
  {
    return dot(force, place) - internal::times(force, inputs[0].value());
  }
};

struct PointLoadParameters
{
  double force = 1.;

  void bind(ParameterSection &section);
};

/** The effect "point loads": forces of one size, where and in what directions the scene says. */
class PointLoadsEffect : public Effect
{
public:
  const std::string &name() const override;
  std::string description() const override;
  void bind(ParameterSection &section) override { parameters.bind(section); }
  std::vector<ParameterDerivative> derivatives(const Scales &scales, const SceneTargets &targets) const override;
  void contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const override;

  PointLoadParameters parameters;
};
} // namespace pellicle

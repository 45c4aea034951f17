// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/constants.h>
#include <pellicle/potentials/potential.h>
#include <pellicle/potentials/wetting/substrate_chart.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace pellicle
{
/** Abscissae and weights on [0, 1]. */
struct UnitRule
{
  std::vector<double> points, weights;
};

/** Gauss rule that integrates along the rays of a substrate's chart: to round-off for spheres up to 150 degrees from
 * the pole and for heights that vary on the scale of the drop. */
const UnitRule &ray_rule();
/** One point: exact for integrands that are constant. */
const UnitRule &middle_rule();

/**
 * Integral of f over the wetted base S of a substrate, as an integral along its line C:
 *
 *     integral of f(X, X,u x X,v) du dv = closed integral of ( integral_0^1 f(t u, t v) t dt ) (u dv - v du)
 *
 * (Poincare's lemma with rays from the chart's origin; D3 of the theory, without a privileged coordinate). It counts
 * parts of the base with the sign of their circulation, so the line need not go round the origin. C runs with the base
 * on its left, seen from the drop's side.
 *
 * `Integrand`: Number operator()(const PlaceOnSubstrate<Number> &) const, linear in the length of `area`.
 */
template <typename Chart, typename Integrand>
struct BaseIntegral
{
  static constexpr std::array<FieldUse, 1> fields{{{"position", Derivatives::first, FieldRole::independent}}};
  static constexpr bool reparametrisation_invariant = true;

  Chart chart;
  Integrand integrand;
  const UnitRule *rule = &ray_rule();

  /** Per unit of the line's parameter. */
  template <typename Number>
  Number along_line(const Vector3<Number> &x, const Vector3<Number> &dx) const
  {
    const std::array<Number, 2> w = chart.coordinates(x), dw = chart.differential(x, dx);
    Number sum = Number(0.);
    for (std::size_t q = 0; q < rule->points.size(); ++q)
    {
      const double t = rule->points[q];
      sum += rule->weights[q] * t * integrand(chart.at(Number(t * w[0]), Number(t * w[1])));
    }
    return sum * (w[0] * dw[1] - w[1] * dw[0]);
  }

  template <typename Number>
  Number density(const PointInputs<Number, 1> &inputs, const PointData & /*data*/) const
  {
    return along_line(inputs[0].value(), inputs[0].d1());
  }
};

/** cos(theta) of the equilibrium contact angle, the same everywhere or a function of place. */
struct ContactAngleCosine
{
  double everywhere = 0.;
  std::shared_ptr<const FunctionOfPlace> degrees; ///< theta(x, y) in degrees, internal coordinates; null: `everywhere`

  template <typename Number>
  Number operator()(const Number &x, const Number &y) const
  {
    if (!degrees)
      return Number(everywhere);
    using std::cos;
    return cos(Number(pi / 180. * FunctionAtPlace<Number>(*degrees, x, y).value));
  }
};

/** factor cos(theta) dA. */
struct WettingIntegrand
{
  double factor = 1.;
  ContactAngleCosine cosine;

  template <typename Number>
  Number operator()(const PlaceOnSubstrate<Number> &S) const
  {
    return factor * cosine(S.place[0], S.place[1]) * norm(S.area);
  }
};

/** dA: the wetted area. */
struct AreaIntegrand
{
  template <typename Number>
  Number operator()(const PlaceOnSubstrate<Number> &S) const
  {
    return norm(S.area);
  }
};

/** The base's share of the drop's volume, one third of the integral of x . n with n out of the drop. */
struct BaseVolumeIntegrand
{
  template <typename Number>
  Number operator()(const PlaceOnSubstrate<Number> &S) const
  {
    return -1. / 3. * dot(S.place, S.area);
  }
};

/** The base's share of the gravity energy -(1/4) integral of (f . x)(x . n), f = rho b: E3 of the theory. */
struct BaseGravityIntegrand
{
  Vector3<double> force;

  template <typename Number>
  Number operator()(const PlaceOnSubstrate<Number> &S) const
  {
    const Number depth = force[0] * S.place[0] + force[1] * S.place[1] + force[2] * S.place[2];
    return 0.25 * depth * dot(S.place, S.area);
  }
};

/** Wetting energy on the line of the given name. */
std::shared_ptr<const Potential> make_wetting(const std::string &name, const SubstrateChart &chart,
                                              const WettingIntegrand &integrand, const std::string &edge);
/** Null on a plane through the origin, which has no share. */
std::shared_ptr<const Potential> make_base_volume(const std::string &name, const SubstrateChart &chart,
                                                  const std::string &edge);
std::shared_ptr<const Potential> make_base_gravity(const std::string &name, const SubstrateChart &chart,
                                                   const Vector3<double> &force, const std::string &edge);
} // namespace pellicle

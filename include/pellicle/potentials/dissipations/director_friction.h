// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/director/director_fields.h>
#include <pellicle/potentials/effect.h>

#include <string>

namespace pellicle
{
/**
 * Friction of directors against a frame at rest, D = (eta/2) |O_t|^2 per area: (40) of Hu, Zhang & E 2007. O_t is the
 * rate at a material point. Not objective: a sphere with O = n that spins rigidly dissipates 2D = (8 pi/3) eta w^2 R^2.
 */
struct DirectorFrictionInLab
{
  static constexpr std::array<FieldUse, 2> fields{
      {{"position", Derivatives::first, FieldRole::independent}, director_field(Derivatives::none)}};
  static constexpr bool reparametrisation_invariant = false; // parameters stand for material points

  double friction = 1.; ///< eta, energy time/length^2

  template <typename Number>
  Number density(const PointInputs<Number, 2> &rates, const PointInputs<double, 2> &start,
                 const PointData & /*data*/) const
  {
    const Vector3<Number> &O_t = rates[1].value();
    return 0.5 * friction * norm(cross(start[0].d1(), start[0].d2())) * dot(O_t, O_t);
  }
};

/**
 * Friction of directors against the membrane, D = (eta/2) |O_t - omega x O|^2 per area, omega the material's spin: zero
 * in rigid motions. It also loads the membrane, since omega is a rate of the positions.
 *
 * | code     | symbol                                                             |
 * |----------|--------------------------------------------------------------------|
 * | v1, v2   | v,1 v,2, v = x_t at a material point                               |
 * | a1, a2   | a^1 a^2, the dual base                                             |
 * | n_t      | -(n . v,a) a^a                                                     |
 * | zeta     | (a_2 . v,1 - a_1 . v,2)/J, twice the spin about n                  |
 * | omega    | n x n_t + (zeta/2) n                                               |
 */
struct ObjectiveDirectorFriction
{
  static constexpr std::array<FieldUse, 2> fields{
      {{"position", Derivatives::first, FieldRole::independent}, director_field(Derivatives::none)}};
  static constexpr bool reparametrisation_invariant = false; // parameters stand for material points

  double friction = 1.; ///< eta, energy time/length^2

  template <typename Number>
  Number density(const PointInputs<Number, 2> &rates, const PointInputs<double, 2> &start,
                 const PointData & /*data*/) const
  {
    const Vector3<double> &x1 = start[0].d1(), &x2 = start[0].d2(), &O = start[1].value();
    const double J           = norm(cross(x1, x2));
    const Vector3<double> n  = (1. / J) * cross(x1, x2);
    const Vector3<double> a1 = (1. / J) * cross(x2, n), a2 = (1. / J) * cross(n, x1);
    const Vector3<Number> &v1 = rates[0].d1(), &v2 = rates[0].d2();
    const Number n_v1 = along(n, v1), n_v2 = along(n, v2);
    const Number half_zeta = (along(x2, v1) - along(x1, v2)) / (2. * J);
    // omega = -(n . v,a) n x a^a + (zeta/2) n, and (omega x O) is linear in it
    const Vector3<double> by_1 = cross(cross(n, a1), O), by_2 = cross(cross(n, a2), O), by_3 = cross(n, O);
    Vector3<Number> slip = rates[1].value();
    for (unsigned int c = 0; c < 3; ++c)
      slip[c] += n_v1 * by_1[c] + n_v2 * by_2[c] - half_zeta * by_3[c];
    return 0.5 * friction * J * dot(slip, slip);
  }

private:
  template <typename Number>
  static Number along(const Vector3<double> &e, const Vector3<Number> &v)
  {
    return e[0] * v[0] + e[1] * v[1] + e[2] * v[2];
  }
};

/** Section "Director friction". */
struct DirectorFrictionParameters
{
  double friction   = 1.;
  std::string frame = "objective";

  void bind(ParameterSection &section);
};

/** The effect "director friction": what directors dissipate when they turn. Needs section Time. */
class DirectorFrictionEffect : public Effect
{
public:
  const std::string &name() const override;
  std::string description() const override;
  void bind(ParameterSection &section) override { parameters.bind(section); }
  void contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const override;

  DirectorFrictionParameters parameters;
};
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/director/director_fields.h>
#include <pellicle/potentials/director/tangential_form.h>

#include <cmath>
#include <memory>
#include <vector>

namespace pellicle
{
/** A quadratic energy of directors that weighs their tangential and normal parts differently, in displacement form. */
struct DirectorPartsEnergy
{
  static constexpr std::array<FieldUse, 2> fields{
      {{"position", Derivatives::first, FieldRole::independent}, director_field(Derivatives::none)}};
  static constexpr bool reparametrisation_invariant = true;

  TangentialForm<1> form;

  template <typename Number>
  Number density(const PointInputs<Number, 2> &inputs, const PointData & /*data*/) const
  {
    return form.density(inputs[0], std::array<Vector3<Number>, 1>{inputs[1].value()});
  }

  void add_derivatives(const PointInputs<double, 2> &inputs, const PointData & /*data*/,
                       const PointDerivativeView &view) const
  {
    form.add_derivatives(inputs[0], {inputs[1].value()}, view);
  }
};

/**
 * Energy of tilt, (k_t/2) |O_tan|^2 per area with O_tan = (I - n n) O: the first term of (23) of Hu, Zhang & E 2007,
 * whose k_2 is k_t. Locks for k_t h^2/K >> 1 (K the modulus of the gradient): see MixedTiltEnergy.
 */
struct TiltEnergy : DirectorPartsEnergy
{
  /** k_t, internal units. */
  explicit TiltEnergy(const double tilt_modulus) { form.alpha[0][0] = form.beta[0][0] = tilt_modulus; }
};

/**
 * The same energy with the shear q as a field of its own, which does not lock and admits k_t = infinity: minimum in O,
 * maximum in q of the integral of
 *
 *     (k_0/2) |O_tan|^2 + t (q . O_tan - |q|^2/(2 k_t)) - (d/(2 k_0)) (q . n)^2,     t = 1 - k_0/k_t,
 *     q = k_t O_tan there
 *
 * (Hellinger & Reissner, with part k_0 < k_t of the modulus left in displacement form after Arnold & Brezzi 1997, which
 * makes the gradient's energy coercive whatever the spaces, and holds the positions of surfaces that move). k_0 changes
 * with the mesh, and by it the discretisation error, not the limit. The factor t, not q, takes up that k_0 jumps from
 * cell to cell: q is the whole shear force per area that the directors exert, and continuous. The last term fixes the
 * normal part of q, of which the others say nothing; the exact q is tangential, so it is consistent. d = 1/10 was
 * measured (doc/numerics.md, "Directors").
 */
struct MixedTiltEnergy
{
  static constexpr std::array<FieldUse, 3> fields{{{"position", Derivatives::first, FieldRole::independent},
                                                   director_field(Derivatives::none),
                                                   director_shear_field()}};
  static constexpr bool reparametrisation_invariant = true; ///< its stationary value in q

  static constexpr double normal_weight = 0.1; ///< d

  double tilt_modulus = 1.;                          ///< k_t, internal units; may be infinite
  std::shared_ptr<const std::vector<double>> direct; ///< 0 < k_0 < k_t by PointData::index

  template <typename Number>
  Number density(const PointInputs<Number, 3> &inputs, const PointData &data) const
  {
    return form(data).density(inputs[0], std::array<Vector3<Number>, 2>{inputs[1].value(), inputs[2].value()});
  }

  void add_derivatives(const PointInputs<double, 3> &inputs, const PointData &data,
                       const PointDerivativeView &view) const
  {
    form(data).add_derivatives(inputs[0], {inputs[1].value(), inputs[2].value()}, view);
  }

private:
  TangentialForm<2> form(const PointData &data) const
  {
    const double k_0 = (*direct)[data.index];
    const double t   = std::isinf(tilt_modulus) ? 1. : 1. - k_0 / tilt_modulus;
    TangentialForm<2> f;
    f.alpha = {{{k_0, t}, {t, -t / tilt_modulus}}};
    f.beta  = {{{k_0, t}, {t, normal_weight / k_0}}};
    return f;
  }
};
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/elastic_skin.h>
#include <pellicle/potentials/eshelby_derivatives.h>
#include <pellicle/potentials/material_position.h>

#include <array>

namespace pellicle
{
/**
 * An elastic skin (ElasticSkin) whose reference X is a field as the position x is, as OnMovingReference for bodies. Its
 * force on the material points along a line, the jump of W 1 - F^T P (Eshelby's tensor in the surface), takes part in
 * what a free contact line obeys. The surface tension of a liquid, W = gamma J_s, has none.
 */
template <typename Law>
struct MovingSkin
{
  static constexpr std::array<FieldUse, 2> fields{{{"position", Derivatives::first, FieldRole::independent},
                                                   {material_position, Derivatives::first, FieldRole::independent}}};
  static constexpr bool reparametrisation_invariant = false; // a motion of the positions alone is a deformation

  Law law; ///< moduli in internal units

  template <typename Number>
  Number density(const PointInputs<Number, 2> &inputs, const PointData & /*data*/) const
  {
    return skin_density(law, inputs[0], metric_of(inputs[1]));
  }

  void add_derivatives(const PointInputs<double, 2> &inputs, const PointData & /*data*/,
                       const PointDerivativeView &view) const
  {
    constexpr unsigned int n = 9, offset = 0; // of the position alone
    std::array<double, n> dE{};
    std::array<double, n * n> d2E{};
    const ReferenceMetric A = metric_of(inputs[1]);
    add_skin_derivatives(law, inputs[0], A,
                         PointDerivativeView(dE.data(), view.wants_hessian() ? d2E.data() : nullptr, n, &offset, 1.));
    const AreaDerivatives area(inputs[1].d1(), inputs[1].d2());
    const Vector3<double> p[2] = {{dE[3], dE[4], dE[5]}, {dE[6], dE[7], dE[8]}};
    const EshelbyDerivatives<2> eshelby(skin_density(law, inputs[0], A),
                                        {{(1. / area.J) * area.dJ[0], (1. / area.J) * area.dJ[1]}},
                                        {{inputs[0].d1(), inputs[0].d2()}}, {{p[0], p[1]}});
    for (unsigned int a = 0; a < 2; ++a)
    {
      view.add_gradient(0, 1 + a, p[a]);
      view.add_gradient(1, 1 + a, eshelby.gradient(a));
    }
    if (!view.wants_hessian())
      return;
    for (unsigned int a = 0; a < 2; ++a)
      for (unsigned int b = 0; b < 2; ++b)
      {
        Matrix3 H_ab;
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            H_ab(i, j) = d2E[(3 + 3 * a + i) * n + 3 + 3 * b + j];
        const Matrix3 H_ab_F = eshelby.along_material(H_ab);
        view.add_hessian(0, 1 + a, 1, 1 + b, eshelby.mixed(a, b, H_ab_F));
        if (a > b)
          continue;
        view.add_hessian(0, 1 + a, 0, 1 + b, H_ab);
        view.add_hessian(1, 1 + a, 1, 1 + b, eshelby.second(a, b, H_ab_F));
      }
  }

private:
  template <typename Number>
  static BasicReferenceMetric<Number> metric_of(const FieldAtPoint<Number> &X)
  {
    return {dot(X.d1(), X.d1()), dot(X.d1(), X.d2()), dot(X.d2(), X.d2())};
  }
};
} // namespace pellicle

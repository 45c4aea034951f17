// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/eshelby_derivatives.h>
#include <pellicle/potentials/material_position.h>
#include <pellicle/potentials/reference_basis.h>

#include <array>
#include <limits>

namespace pellicle
{
/**
 * A density of a body (see OnGivenReference) whose reference X is a field as the position x is, F =
 * (dx/dxi)(dX/dxi)^-1: material points may move through the mesh. The integral stays the same when both fields are
 * parametrised anew by one motion of the mesh; what changes it is that a line of the mesh, such as a contact line, is
 * bound to other material points, by the force of Eshelby (see EshelbyDerivatives). Where J <= 0 or J_ref <= 0 it is
 * not a number.
 *
 * The derivatives with respect to X follow from those of the density on a given reference.
 */
template <typename BodyDensity>
struct OnMovingReference
{
  static constexpr auto fields                      = with_material_position(BodyDensity::fields);
  static constexpr bool reparametrisation_invariant = false; // a motion of the positions alone is a deformation

  BodyDensity body_density; ///< moduli in internal units

  template <typename Inputs>
  auto density(const Inputs &inputs, const PointData & /*data*/) const
  {
    const auto G = basis_of(inputs[1]);
    using Number = std::decay_t<decltype(G.volume)>;
    if (!(value_of(G.volume) > 0.))
      return Number(std::numeric_limits<double>::quiet_NaN());
    return body_density.density(G, without_reference(inputs));
  }

  void add_derivatives(const PointInputs<double, std::tuple_size<decltype(fields)>::value> &inputs,
                       const PointData & /*data*/, const PointDerivativeView &view) const
  {
    const ReferenceBasis G = basis_of(inputs[1]);
    const auto own_inputs  = without_reference(inputs);
    const bool second      = view.wants_hessian();
    OnGiven given(body_density, G, own_inputs, second);
    const EshelbyDerivatives<3> eshelby(body_density.density(G, own_inputs), G.dual,
                                        {{inputs[0].d1(), inputs[0].d2(), inputs[0].d3()}},
                                        {{given.gradient(1), given.gradient(2), given.gradient(3)}});
    for (unsigned int a = 0; a < 3; ++a)
    {
      view.add_gradient(0, 1 + a, given.gradient(1 + a));
      view.add_gradient(1, 1 + a, eshelby.gradient(a));
    }
    for (unsigned int f = 1; f < n_given; ++f)
      view.add_gradient(1 + f, 0, given.gradient(3 + f));
    if (!second)
      return;
    for (unsigned int b = 0; b < 3; ++b)
      for (unsigned int a = 0; a < 3; ++a)
      {
        const Matrix3 H_ab = given.hessian(1 + a, 1 + b), H_ab_F = eshelby.along_material(H_ab);
        view.add_hessian(0, 1 + a, 1, 1 + b, eshelby.mixed(a, b, H_ab_F));
        if (a > b)
          continue;
        view.add_hessian(0, 1 + a, 0, 1 + b, H_ab);
        view.add_hessian(1, 1 + a, 1, 1 + b, eshelby.second(a, b, H_ab_F));
      }
    for (unsigned int f = 1; f < n_given; ++f)
    {
      for (unsigned int a = 0; a < 3; ++a)
      {
        const Matrix3 E_xq = given.hessian(1 + a, 3 + f);
        view.add_hessian(0, 1 + a, 1 + f, 0, E_xq);
        view.add_hessian(1, 1 + a, 1 + f, 0, eshelby.with_further(a, given.gradient(3 + f), E_xq));
      }
      for (unsigned int g = f; g < n_given; ++g)
        view.add_hessian(1 + f, 0, 1 + g, 0, given.hessian(3 + f, 3 + g));
    }
  }

private:
  static constexpr unsigned int n_given = std::tuple_size<std::decay_t<decltype(BodyDensity::fields)>>::value;

  /** Derivatives of the density on a given reference, by vectors of its inputs: x, x,1, x,2, x,3, further fields. */
  class OnGiven
  {
  public:
    OnGiven(const BodyDensity &density, const ReferenceBasis &G, const PointInputs<double, n_given> &inputs,
            const bool second)
    {
      std::array<unsigned int, n_given> offsets{};
      for (unsigned int f = 1; f < n_given; ++f)
        offsets[f] = 12 + 3 * (f - 1);
      if (second)
        second_derivatives.fill(0.);
      density.add_derivatives(G, inputs,
                              PointDerivativeView(first_derivatives.data(),
                                                  second ? second_derivatives.data() : nullptr, n, offsets.data(), 1.));
    }
    Vector3<double> gradient(const unsigned int i) const
    {
      return {first_derivatives[3 * i], first_derivatives[3 * i + 1], first_derivatives[3 * i + 2]};
    }
    Matrix3 hessian(const unsigned int i, const unsigned int j) const
    {
      Matrix3 block;
      for (unsigned int r = 0; r < 3; ++r)
        for (unsigned int c = 0; c < 3; ++c)
          block(r, c) = second_derivatives[(3 * i + r) * n + 3 * j + c];
      return block;
    }

  private:
    static constexpr unsigned int n = 12 + 3 * (n_given - 1);
    std::array<double, n> first_derivatives{};
    std::array<double, n * n> second_derivatives; // filled if asked for
  };

  template <typename Number>
  static BasicReferenceBasis<Number> basis_of(const FieldAtPoint<Number> &X)
  {
    return {X.d1(), X.d2(), X.d3()};
  }

  template <typename Number>
  static PointInputs<Number, n_given> without_reference(const PointInputs<Number, n_given + 1> &inputs)
  {
    PointInputs<Number, n_given> given;
    given[0] = inputs[0];
    for (unsigned int f = 1; f < n_given; ++f)
      given[f] = inputs[f + 1];
    return given;
  }
};
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/exceptions.h>
#include <pellicle/potentials/potential.h>
#include <pellicle/potentials/reference_basis.h>

#include <memory>
#include <utility>
#include <vector>

namespace pellicle
{
/**
 * A density of a body whose reference is given at every quadrature point, per unit of parametric volume. What it is a
 * density of knows a point with its reference basis G, and not where that comes from:
 *
 *     static constexpr std::array<FieldUse, n> fields; // "position" with Derivatives::bulk, then fields without any
 *     template <typename Number, typename Reference>
 *     Number density(const BasicReferenceBasis<Reference> &G, const PointInputs<Number, n> &inputs) const;
 *     void add_derivatives(const ReferenceBasis &G, const PointInputs<double, n> &inputs,
 *                          const PointDerivativeView &view) const;
 *
 * OnMovingReference takes the same, where the reference is a field.
 */
template <typename BodyDensity>
struct OnGivenReference
{
  static constexpr auto fields                      = BodyDensity::fields;
  static constexpr bool reparametrisation_invariant = false;

  BodyDensity body_density;                                     ///< moduli in internal units
  std::shared_ptr<const std::vector<ReferenceBasis>> reference; ///< by PointData::index

  template <typename Inputs>
  auto density(const Inputs &inputs, const PointData &data) const
  {
    return body_density.density(reference_at(data), inputs);
  }

  template <typename Inputs>
  void add_derivatives(const Inputs &inputs, const PointData &data, const PointDerivativeView &view) const
  {
    body_density.add_derivatives(reference_at(data), inputs, view);
  }

private:
  const ReferenceBasis &reference_at(const PointData &data) const
  {
    PELLICLE_ASSERT(reference && data.index < reference->size(), "a body needs its reference basis");
    return (*reference)[data.index];
  }
};
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/potential.h>

#include <memory>
#include <string>
#include <vector>

namespace pellicle
{
/**
 * Edges in the (x, P) form of the bending energy. The surface term, the integral of a^ab x,a . P,b, is the curvature
 * times P only up to an edge term: minus the integral of nu . P along the edge, nu the outward unit conormal, makes it
 * complete.
 *
 *  - clamped edge: nu is given;
 *  - hinged or free edge with kappa_G = 0: nu is free, which makes P . n = 0 there; the moment is simply held at zero;
 *  - hinged or free edge with kappa_G: nu is an unknown field "edge conormal", and its equation P . n = kappa_G b_tt
 * the balance of moments.
 */
struct ClampedEdge
{
  static constexpr std::array<FieldUse, 2> fields{
      {{"position", Derivatives::first, FieldRole::independent}, {"moment", Derivatives::none, FieldRole::internal}}};
  static constexpr bool reparametrisation_invariant = true; ///< of a line that keeps its place

  std::shared_ptr<const std::vector<Vector3<double>>> conormals; ///< nu by PointData::index

  template <typename Number>
  Number density(const PointInputs<Number, 2> &inputs, const PointData &data) const
  {
    const Vector3<double> &nu = (*conormals)[data.index];
    const Vector3<Number> &P  = inputs[1].value();
    return -(nu[0] * P[0] + nu[1] * P[1] + nu[2] * P[2]) * norm(inputs[0].d1());
  }
};

/** -nu . P along an edge whose conormal is an unknown; on the far side of a split line, where nu points inwards, +nu .
 * P. */
struct HingedEdge
{
  static constexpr std::array<FieldUse, 3> fields{
      {{"position", Derivatives::first, FieldRole::independent},
       {"moment", Derivatives::none, FieldRole::internal},
       {"edge conormal", Derivatives::first, FieldRole::internal, FieldSpace::edge_conormals}}};
  static constexpr bool reparametrisation_invariant = true;

  double sign = -1.;

  template <typename Number>
  Number density(const PointInputs<Number, 3> &inputs, const PointData & /*data*/) const
  {
    return sign * dot(inputs[2].value(), inputs[1].value()) * norm(inputs[0].d1());
  }
};

/**
 * mu nu . x,1: a multiplier field keeps an unknown conormal orthogonal to its edge, wherever that moves. (On a meridian
 * it is so by construction, and there is no mu.)
 */
struct ConormalConstraint
{
  static constexpr std::array<FieldUse, 3> fields{
      {{"position", Derivatives::first, FieldRole::independent},
       {"edge conormal", Derivatives::none, FieldRole::internal, FieldSpace::edge_conormals},
       {"edge multiplier", Derivatives::none, FieldRole::internal, FieldSpace::edge_scalars}}};
  static constexpr bool reparametrisation_invariant = true;

  template <typename Number>
  Number density(const PointInputs<Number, 3> &inputs, const PointData & /*data*/) const
  {
    return inputs[2].value()[0] * dot(inputs[1].value(), inputs[0].d1());
  }
};

/**
 * -kappa_G times the geodesic curvature of an edge, kappa_g = (dnu/ds) . t (1/R for the rim of a flat disc). By the
 * theorem of Gauss and Bonnet the Gaussian energy kappa_G times the integral of K is this plus 2 pi chi kappa_G. With a
 * conormal that is continuous along the edge there are no turning angles at the vertices of cells.
 */
struct GeodesicCurvature
{
  static constexpr std::array<FieldUse, 2> fields{
      {{"position", Derivatives::first, FieldRole::independent},
       {"edge conormal", Derivatives::first, FieldRole::internal, FieldSpace::edge_conormals}}};
  static constexpr bool reparametrisation_invariant = true;

  double gaussian_modulus = 0.; ///< kappa_G

  template <typename Number>
  Number density(const PointInputs<Number, 2> &inputs, const PointData & /*data*/) const
  {
    return -gaussian_modulus * dot(inputs[1].d1(), inputs[0].d1()) / norm(inputs[0].d1());
  }
};
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/stretch_invariants.h>

#include <memory>
#include <string>
#include <vector>

namespace pellicle
{
/**
 * Distortion of the mesh relative to a reference, per reference area:
 *
 *     tr C/(2 J) - 1 + w (J - 1)^2,    C = A^-1 a,   J = sqrt(det C),   w = 20,
 *
 * zero where the metric a_ab equals the reference A_ab. The first two terms see change of shape only (conformal
 * energy), the last one change of area; w weighs even cells against square ones (measured: energy errors of strongly
 * deformed vesicles are 1.5 to 2 times smaller than with w = 1/2). Its tangential gradient fixes the position of the
 * nodes on the surface in the ALE chart; it is no physics and is never added to it.
 */
struct MeshDistortion
{
  static constexpr std::array<FieldUse, 1> fields{{{"position", Derivatives::first, FieldRole::independent}}};
  static constexpr bool reparametrisation_invariant = false;
  static constexpr double area_weight               = 20.; ///< w

  std::shared_ptr<const std::vector<ReferenceMetric>> reference; ///< by PointData::index

  template <typename Number>
  Number density(const PointInputs<Number, 1> &inputs, const PointData &data) const
  {
    const ReferenceMetric &A = (*reference)[data.index];
    const StretchInvariants<Number> stretch(inputs[0], A);
    const Number &T = stretch.T, &s = stretch.s;
    return A.area_element() * (T / (2. * s) - 1. + area_weight * (s - 1.) * (s - 1.));
  }

  void add_derivatives(const PointInputs<double, 1> &inputs, const PointData &data,
                       const PointDerivativeView &view) const;
};

/** The mesh energy as a potential. */
std::shared_ptr<const Potential> make_mesh_distortion(std::vector<ReferenceMetric> reference);
} // namespace pellicle

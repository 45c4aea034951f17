// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/exceptions.h>
#include <pellicle/potentials/density_potential.h>

#include <memory>
#include <vector>

namespace pellicle
{
/**
 * Dead load on a line: E = - integral of f . x dS with a force f per length of the line in the reference, constant in
 * direction and size while the line moves and stretches. The pull of a liquid surface on a contact line, where the
 * liquid itself is left out. A meridian's line is a circle; of its f only the components in r and z matter.
 *
 * The line is made of material points: with it nodes may not slide along the line or the surface.
 */
struct LineForce
{
  static constexpr std::array<FieldUse, 1> fields{{{"position", Derivatives::none, FieldRole::independent}}};
  static constexpr bool reparametrisation_invariant = false;

  Vector3<double> force; ///< f, energy/length^2
  /** |X,1| by PointData::index, see line_elements(). */
  std::shared_ptr<const std::vector<double>> reference;

  template <typename Number>
  Number density(const PointInputs<Number, 1> &inputs, const PointData &data) const
  {
    PELLICLE_ASSERT(reference && data.index < reference->size(), "a line force needs the line's reference");
    const Vector3<Number> &x = inputs[0].value();
    return -(*reference)[data.index] * (force[0] * x[0] + force[1] * x[1] + force[2] * x[2]);
  }
};
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/point_inputs.h>

namespace pellicle
{
/** The field O of directors: |O| = 1 at the nodes, between them the interpolation is not normalised. */
constexpr std::string_view director = "director";

/** The field q of shear: the force per area that holds the directors' tilt, tangential up to discretisation. */
constexpr std::string_view director_shear = "director shear";

/** Director model: how a density declares the directors ... */
constexpr FieldUse director_field(const Derivatives derivatives)
{
  return {director, derivatives, FieldRole::independent, FieldSpace::unit_vectors};
}

/** ... and their shear. */
constexpr FieldUse director_shear_field()
{
  return {director_shear, Derivatives::none, FieldRole::multiplier, FieldSpace::lower_degree_vectors};
}
} // namespace pellicle

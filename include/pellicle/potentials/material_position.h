// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/point_inputs.h>

#include <array>
#include <cstddef>

namespace pellicle
{
/** Name of the field X of those bodies and skins whose material points move through the mesh. */
constexpr const char *material_position = "material position";

/** The fields of a density, and second the material position, differentiated as the first field is. */
template <std::size_t n>
constexpr std::array<FieldUse, n + 1> with_material_position(const std::array<FieldUse, n> &fields)
{
  std::array<FieldUse, n + 1> all{};
  all[0] = fields[0];
  all[1] = {material_position, fields[0].derivatives, FieldRole::independent, FieldSpace::material_places};
  for (std::size_t f = 1; f < n; ++f)
    all[f + 1] = fields[f];
  return all;
}

} // namespace pellicle

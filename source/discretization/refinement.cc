// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/discretization/refinement.h>

#include <algorithm>

namespace pellicle
{
// Places are disjoint or part of each other: the middle of the smaller one decides.
bool is_part_of(const CellPlace &part, const CellPlace &whole)
{
  constexpr double same_size = 1. + 1e-6; // of a meridian's cells sizes are rounded
  const double u = part.u0 + 0.5 * part.size - whole.u0, v = part.v0 + 0.5 * part.size - whole.v0;
  const bool within_v = v > 0. && v < whole.size;
  return part.patch == whole.patch && part.size < same_size * whole.size && u > 0. && u < whole.size && within_v;
}

bool Refinement::cuts(const CellPlace &place) const
{
  return std::any_of(cut.begin(), cut.end(), [&](const CellPlace &wanted) { return is_part_of(wanted, place); });
}
} // namespace pellicle

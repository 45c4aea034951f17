// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/cell_place.h>

#include <utility>
#include <vector>

namespace pellicle
{
/**
 * How finely the coarsest mesh is cut: every cell the same number of times, and some of them further. A number alone
 * is uniform refinement.
 */
struct Refinement
{
  unsigned int uniform = 0;
  /** Places that are to be cut, into four in space and into two on a meridian. Whatever contains such a place is cut,
   * too, and so are neighbours that would be more than twice as large: a list that only grows makes meshes of which
   * each contains the one before it. */
  std::vector<CellPlace> cut;

  Refinement(const unsigned int times) // implicit: builders take a number as well
      : uniform(times)
  {
  }
  Refinement(const unsigned int times, std::vector<CellPlace> further)
      : uniform(times)
      , cut(std::move(further))
  {
  }

  /** Whether a cell of this place has to be cut, whatever its neighbours are. */
  bool cuts(const CellPlace &place) const;
};

/** Whether a place lies within another one, or is the same. */
bool is_part_of(const CellPlace &part, const CellPlace &whole);
} // namespace pellicle

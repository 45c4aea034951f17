// SPDX-License-Identifier: LGPL-2.1-or-later
#include "joined_at_line.h"

#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/closed_at_rim.h>

namespace pellicle
{
SurfaceDiscretization closed_at_rim(const SurfaceDiscretization &upper, const SurfaceDiscretization &lower,
                                    const std::string &upper_name, const std::string &lower_name)
{
  PELLICLE_ASSERT(upper.edges.size() == 1 && lower.edges.size() == 1, "two open surfaces with one rim each");
  SurfaceDiscretization result = upper;
  append_at_line(result, upper.edges.front(), lower, lower.edges.front(), JoinedSide::turned_round);
  result.cell_region.assign(upper.n_cells, 0);
  result.cell_region.resize(result.n_cells, 1);
  result.region_names         = {upper_name, lower_name};
  result.edges.front().is_rim = false;
  return result;
}
} // namespace pellicle

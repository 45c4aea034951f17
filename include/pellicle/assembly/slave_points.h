// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/surface_cells.h>

#include <cstddef>
#include <vector>

namespace pellicle
{
/** Points of a slave surface at which contact acts: Gauss points of its cells. */
struct SlavePoints
{
  /** `reference`: positions of the reference state, whose areas points have once and for all. `n_gauss`: points in each
   * direction of a cell. */
  SlavePoints(SurfaceCells slave, const NodalVectors &reference, unsigned int n_gauss);

  std::size_t size() const { return reference_areas.size(); }
  const double *shapes(const std::size_t q) const { return tables.tables[0].data() + q * tables.n_nodes; }

  SurfaceCells cells;
  ShapeTables tables;
  std::vector<double> reference_areas; ///< dA [cell * tables.n_points + q], weight included
};
} // namespace pellicle

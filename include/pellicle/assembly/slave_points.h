// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/communicator.h>
#include <pellicle/assembly/surface_cells.h>

#include <cstddef>
#include <vector>

namespace pellicle
{
/** Points at which contact acts: Gauss points of the cells of a slave surface, or of the edges of a slave line. */
struct SlavePoints
{
  /** `reference`: positions of the reference state, whose areas points have once and for all. `n_gauss`: points in each
   * direction of a cell. */
  SlavePoints(const SurfaceCells &slave, const NodalVectors &reference, unsigned int n_gauss);
  /** Points of an edge loop (with its tables), which have lengths for areas. */
  SlavePoints(const EdgeLoop &slave, const NodalVectors &reference);

  std::size_t size() const { return reference_areas.size(); }
  std::size_t n_cells() const { return reference_areas.size() / tables.n_points; }
  std::size_t n_local() const { return tables.n_nodes; }
  const std::size_t *nodes(const std::size_t cell) const { return cell_nodes.data() + cell * tables.n_nodes; }
  const double *shapes(const std::size_t q) const { return tables.tables[0].data() + q * tables.n_nodes; }

  /** Cells of this process; all of them, unless distribute() was called. */
  bool is_own(const std::size_t cell) const { return cell >= first_own && cell < end_own; }
  void distribute(const Communicator &communicator);

  std::vector<std::size_t> cell_nodes; ///< [c * n_local() + i]
  ShapeTables tables;
  /** dA, on a line dS: [cell * tables.n_points + q], weight included. */
  std::vector<double> reference_areas;
  bool on_line = false;

private:
  std::size_t first_own = 0, end_own = 0;
};
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>

#include <array>
#include <cstddef>
#include <vector>

namespace pellicle
{
/**
 * Carries nodal values from one mesh to another one of the same patches, which may be refined (everywhere or in places)
 * or of another degree: each node of the second mesh gets the value of the first one's polynomial there, found by the
 * places of cells (SurfaceDiscretization::cell_places). What the second mesh can represent is carried over exactly.
 *
 * Nodes that stand at one place on the two sides of a split line get the values of their own side.
 */
class MeshTransfer
{
public:
  /** Whether both meshes know the places of their cells, and each cell of the second lies in one of the first. */
  static bool is_possible(const SurfaceDiscretization &from, const SurfaceDiscretization &to);

  /** Asserts is_possible(). */
  MeshTransfer(const SurfaceDiscretization &from, const SurfaceDiscretization &to);

  /** A field on the second mesh. */
  NodalVectors operator()(const NodalVectors &values) const;

private:
  /** Where a node of the second mesh is in the first one. */
  struct Place
  {
    std::size_t cell   = 0;
    std::size_t table  = 0; ///< which of the tables, which of its points
    unsigned int point = 0;
  };

  std::size_t n_local = 0;             ///< nodes of the first mesh's cells
  std::vector<std::size_t> cell_nodes; ///< of the first mesh
  std::vector<Place> places;
  std::vector<std::vector<double>> tables; ///< [table][point * n_local + i]: N_i of the first mesh
};
} // namespace pellicle

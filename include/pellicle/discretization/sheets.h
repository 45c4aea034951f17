// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>

#include <cstddef>
#include <vector>

namespace pellicle
{
/**
 * The surface without bodies, and its regions without common nodes: what is continuous in a sheet only (normals,
 * curvature) can be computed there with one value a node.
 */
struct Sheets
{
  SurfaceDiscretization surface;     ///< no bodies, no edge loops
  std::vector<std::size_t> original; ///< the node of the whole for each of its nodes

  /** Values at the nodes of the sheets of a field with so many components. */
  std::vector<double> values(const std::vector<double> &of_whole, unsigned int n_components) const;
};

Sheets sheets_of(const SurfaceDiscretization &whole);
} // namespace pellicle

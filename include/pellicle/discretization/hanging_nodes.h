// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>

#include <vector>

namespace pellicle
{
/** Gives hanging nodes the values of their neighbours' polynomials: without it there are cracks. */
void join_hanging_nodes(const std::vector<HangingNode> &hanging, NodalVectors &values);

/** The same for all that a discretization has at its nodes: positions, mesh reference, start values. */
void join_hanging_nodes(SurfaceDiscretization &discretization);

/** Takes what acts on hanging nodes over to the nodes that they hang on: the transpose of the above. */
void hand_over_forces(const std::vector<HangingNode> &hanging, NodalVectors &forces);

/** Whether a node hangs, for each of them. */
std::vector<bool> hanging_flags(const SurfaceDiscretization &discretization);

/** The sides of cells at which cells of different sizes meet: those of the small ones and those of the large. */
class IrregularSides
{
public:
  explicit IrregularSides(const SurfaceDiscretization &discretization);

  bool contains(const CellSide &side) const;

private:
  const SurfaceDiscretization &surface;
  std::vector<bool> marks; ///< nodes that hang, and nodes on which others hang
};
} // namespace pellicle

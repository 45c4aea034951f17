// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace pellicle
{
/**
 * Which part of the coarsest mesh a cell is: the square (u, v) in [u0, u0 + size] x [v0, v0 + size] of a patch, whose
 * own coordinates run over [0, 1]^2 in the directions of the cell's. Of a meridian: the part [u0, u0 + size] of the
 * line, patch 0, v0 = 0. Sizes in space are powers of 1/2, so that places compare exactly.
 *
 * Cells of two meshes of the same patches are part of each other or disjoint, however finely either of them is cut.
 */
struct CellPlace
{
  unsigned int patch = 0;
  double u0          = 0.;
  double v0          = 0.;
  double size        = 1.;
};
} // namespace pellicle

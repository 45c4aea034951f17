// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/models/surface_problem.h>

#include <vector>

namespace pellicle
{
/**
 * Which cells of the surface have the errors: for each of them an estimate, up to a common factor, of its part in the
 * error of the energy, in internal units. From the solution alone: what the fields have of degree k in a cell (in
 * Legendre polynomials of its coordinates), and how much smaller that is than what they have of degree k - 1,
 *
 *     indicator = sum over fields of S_k min(1, S_k/S_(k-1)),
 *     S_j = integral over the cell of |grad of the field's part of degree j|^2 dA
 *
 * for directors; of the position only the part normal to the surface counts, for nodes may slide along it; the moment,
 * which is a second derivative of it, enters with |part|^2. Where a solution is smooth on the scale of the cell, S_k
 * falls like h^(2k - 2), S_k/S_(k-1) like h^2 and the indicator like the error of the energy; where it is not, the
 * ratio is one. Multiplier fields and those of edges and bodies have no say.
 */
std::vector<double> error_indicators(const SurfaceProblem &problem);

/** The cells with the largest errors. */
struct WorstCells
{
  std::vector<CellPlace> places;
  double share = 0.; ///< of all errors
};

/**
 * The cells that have at least the given share of the sum of all indicators between them, largest first (W. Doerfler,
 * SIAM J. Numer. Anal. 33, 1106, 1996), and those that differ from the last of them by round-off, so that symmetric
 * solutions keep symmetric meshes.
 *
 * @param fraction  in (0, 1).
 */
WorstCells cells_with_most(double fraction, const std::vector<double> &indicators,
                           const std::vector<CellPlace> &places);
} // namespace pellicle

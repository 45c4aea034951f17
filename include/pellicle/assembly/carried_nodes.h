// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/nodal_chart.h>

#include <vector>

namespace pellicle
{
/**
 * Who carries the nodes of liquid sheets that end at lines with motions of their own (see NodalChart::carriers): the
 * displacement of the line's nodes is continued over the sheets by Laplace's equation, component by component,
 *
 *     integral of A^ab share,a . v,b dA = 0 for all v,   share_J = N_J on the line, 0 at nodes that are held,
 *
 * A the metric of the given positions. A sheet so follows its line smoothly as a whole, and a translation of all lines
 * translates it. Why not leave the sheet's nodes behind: then the line's displacement would fall to zero within one
 * cell. Cells there would be crushed by a line that moves far; forces on the line would be tested with a kink, and
 * balances of forces would hold to the discretisation error only (see also directions_towards_bodies()).
 *
 * @param own  nodes that move by themselves: lines, bodies.
 * @param held nodes that are not carried at all.
 */
std::vector<std::vector<NodalChart::Carrier>> carriers_of_sheets(const SurfaceDiscretization &discretization,
                                                                 const NodalVectors &positions,
                                                                 const std::vector<bool> &own,
                                                                 const std::vector<bool> &held);
} // namespace pellicle

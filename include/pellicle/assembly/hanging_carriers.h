// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/field_layout.h>
#include <pellicle/assembly/nodal_chart.h>

#include <Eigen/SparseCore>

namespace pellicle
{
/**
 * Takes their own unknowns from hanging nodes; they are carried by the nodes that they hang on
 * (NodalChart::carriers), and so are nodes that hanging ones carried. Then rows and columns, mesh equations included,
 * go where they belong without anybody knowing of hanging nodes. The last step in making a chart; may be repeated.
 */
void carry_hanging_nodes(const SurfaceDiscretization &discretization, NodalChart &chart);

/** Whether a field has values all over the surface, so that a hanging node's follow from its neighbour's. */
bool covers_surface(const Field &field);

/** P with v = P u: what hanging nodes have from the others; their own columns are zero. */
Eigen::SparseMatrix<double> hanging_prolongation(const SurfaceDiscretization &discretization);

/** P^T matrix P, with a one on the diagonal of hanging nodes; the matrix itself where nothing hangs. For a right-hand
 * side P^T f, the solution is P u. */
Eigen::SparseMatrix<double> condensed(const SurfaceDiscretization &discretization,
                                      const Eigen::SparseMatrix<double> &matrix);
} // namespace pellicle

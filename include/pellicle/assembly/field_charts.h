// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/field_layout.h>
#include <pellicle/assembly/nodal_chart.h>
#include <pellicle/assembly/nodal_conditions.h>

namespace pellicle
{
/**
 * Unit vectors at the nodes of the surface (directors): two columns tangential to the sphere at the present value, one
 * on a meridian, none where symmetry leaves no other direction. The next value is the retraction (O + d)/|O + d|.
 */
NodalChart unit_vector_chart(const SurfaceDiscretization &discretization, const NodalVectors &values);

/**
 * Continuous vector fields of degree k - 1 on cells of degree k, by their values at the nodes of degree k: some nodes
 * of a cell have unknowns, as many as degree k - 1 has nodes, and carry the others by interpolation
 * (NodalChart::carriers; shares depend on the cell's topology alone). On an edge the node with the smallest number is
 * carried by the others of the edge, inside a cell those with the last inner index; so neighbours agree. The field
 * needs no shape functions of its own.
 */
NodalChart lower_degree_chart(const SurfaceDiscretization &discretization);

/** All admissible values of a field other than the position, at the present ones. */
NodalChart chart_of_field(const SurfaceDiscretization &discretization, const Field &field,
                          const NodalVectors &positions, const NodalVectors &values, const NodalConditions &conditions);

/** Whether the chart of a field has its columns at the present values, and must follow them. */
bool chart_follows_values(const Field &field);
} // namespace pellicle

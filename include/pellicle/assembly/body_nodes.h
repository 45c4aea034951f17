// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/nodal_chart.h>
#include <pellicle/assembly/nodal_conditions.h>
#include <pellicle/potentials/reference_basis.h>

#include <string>
#include <vector>

namespace pellicle
{
/** Base vectors of a body in a configuration at every quadrature point, as the reference of its material. Throws
 * UserError naming the body where x,1 . (x,2 x x,3) <= 0. */
std::vector<ReferenceBasis> reference_bases(const BulkPart &body, const NodalVectors &positions);

/** Numbers at the pressure nodes of bodies. */
NodalChart bulk_scalar_chart(const SurfaceDiscretization &discretization);

/** Every admissible direction at the nodes of the surface, and no unknowns inside bodies (the moment). */
NodalChart surface_vector_chart(const SurfaceDiscretization &discretization);

/** Weights of the nodes in a drag: the areas of nodal_areas() on the surface plus the volumes of the bodies, likewise
 * distributed (in internal units both are numbers); zero at pressure nodes. */
std::vector<double> nodal_weights(const SurfaceDiscretization &discretization, const NodalVectors &positions);

/** Nodes of which a field keeps its values: a face that is held. */
void hold_nodes(NodalConditions &conditions, const std::string &field, const std::vector<std::size_t> &nodes,
                std::size_t n_nodes);
} // namespace pellicle

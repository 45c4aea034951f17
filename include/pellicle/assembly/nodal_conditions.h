// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/nodal_chart.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pellicle
{
/** What edges ask of the nodes of one field. Empty lists: nothing. */
struct FieldConditions
{
  /** For a node: the only directions in which it may change, with physical equations (count 0: held). */
  std::vector<std::optional<AdmissibleDirections>> only;
  /** Nodes that move as another one does, or with its unknowns along their own columns: see NodalChart::leader. */
  std::vector<std::size_t> leader;
  /** Bodies on which nodes stay (null: none): see NodalChart::on_body. */
  std::vector<std::shared_ptr<const RigidBody>> body;
};

/** By name of the field; fields that are not named have no conditions. */
using NodalConditions = std::map<std::string, FieldConditions>;

/** No direction at all. */
AdmissibleDirections held();

/**
 * Columns of the nodes that stay on bodies at the present positions, tangential to the bodies. On an edge loop the one
 * across the line is physical, whatever becomes of the others: it moves the line over the body. Nodes that are held
 * stay held.
 *
 * Called again for the same chart when nodes have moved, it carries the columns over to the new tangent planes without
 * turning them: Newton's method would lose its quadratic end if they followed the line. Throws SolveError where a body
 * has no closest point.
 */
void keep_on_bodies(const FieldConditions &conditions, const SurfaceDiscretization &discretization,
                    const NodalVectors &positions, TangentialMotion tangential, NodalChart &chart);

/** Replaces the columns of nodes that a condition names, and ties followers to their leaders. */
void apply_conditions(const NodalConditions &conditions, const std::string &field, NodalChart &chart);
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/nodal_chart.h>

#include <map>
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
  /** Nodes that move as another one does: see NodalChart::leader. */
  std::vector<std::size_t> leader;
};

/** By name of the field; fields that are not named have no conditions. */
using NodalConditions = std::map<std::string, FieldConditions>;

/** No direction at all. */
AdmissibleDirections held();

/** Replaces the columns of nodes that a condition names, and ties followers to their leaders. */
void apply_conditions(const NodalConditions &conditions, const std::string &field, NodalChart &chart);
} // namespace pellicle

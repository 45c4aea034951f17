// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/nodal_conditions.h>

namespace pellicle
{
AdmissibleDirections held()
{
  AdmissibleDirections none;
  none.count   = 0;
  none.columns = {};
  return none;
}

void apply_conditions(const NodalConditions &conditions, const std::string &field, NodalChart &chart)
{
  const auto found = conditions.find(field);
  if (found == conditions.end())
    return;
  const FieldConditions &these = found->second;
  chart.leader                 = these.leader;
  for (std::size_t I = 0; I < these.only.size(); ++I)
    if (these.only[I])
    {
      NodalChart::Node node;
      node.count = these.only[I]->count;
      for (unsigned int j = 0; j < node.count; ++j)
        for (unsigned int c = 0; c < 3; ++c)
          node.columns[3 * j + c] = these.only[I]->columns[j][c];
      chart.nodes[I] = node;
    }
  for (std::size_t I = 0; I < these.leader.size(); ++I)
  {
    chart.nodes[I] = chart.nodes[these.leader[I]];
    if (!chart.unit_vectors.empty())
      chart.unit_vectors[I] = chart.unit_vectors[these.leader[I]];
  }
}
} // namespace pellicle

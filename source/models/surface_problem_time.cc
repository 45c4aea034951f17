// SPDX-License-Identifier: LGPL-2.1-or-later
// A surface problem that steps in time.
#include <pellicle/models/surface_problem.h>

#include <algorithm>
#include <numeric>

namespace pellicle
{
void SurfaceProblem::begin_time_step(const double length)
{
  const std::vector<Cell> cells = own_cells(surface, communicator);
  std::vector<double> inputs;
  for (const Dissipation &dissipation : set.dissipations)
  {
    const std::vector<unsigned int> offsets = field_layout.offsets(*dissipation.over_step);
    const std::vector<FieldUse> uses        = dissipation.over_step->fields();
    const std::size_t here                  = set_of(surface, dissipation.over_step->where());
    const ShapeTables &tables               = tables_of(surface, here);
    const std::size_t n_inputs =
        std::accumulate(uses.begin(), uses.end(), std::size_t(0),
                        [](const std::size_t n, const FieldUse &use) { return n + 3 * n_slots(use.derivatives); });
    dissipation.start->length = length;
    dissipation.start->inputs.assign(n_cells_of(surface, here) * tables.n_points * n_inputs, 0.);
    for (const Cell &cell : cells)
    {
      if (cell.set != here)
        continue;
      gather_inputs(tables, cell.nodes, field_layout, current.fields, inputs);
      auto next =
          dissipation.start->inputs.begin() + static_cast<std::ptrdiff_t>(cell.index * tables.n_points * n_inputs);
      for (unsigned int q = 0; q < tables.n_points; ++q)
        for (std::size_t f = 0; f < uses.size(); ++f)
          next = std::copy_n(inputs.begin() + static_cast<std::ptrdiff_t>(q * field_layout.n_inputs() + offsets[f]),
                             3 * n_slots(uses[f].derivatives), next);
    }
  }
  current_values = evaluate(current);
}

double SurfaceProblem::step_dissipation() const
{
  return std::accumulate(current_values.dissipations.begin(), current_values.dissipations.end(), 0.);
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
// A surface problem in a checkpoint.
#include <pellicle/models/surface_problem.h>

#include <utility>

namespace pellicle
{
void SurfaceProblem::exchange(Archive &archive)
{
  SurfaceState state     = current;
  TermValues values      = current_values;
  PositionChart in_chart = chart;
  archive.name("state");
  archive | in_chart | state | values.energies | values.constraints | values.compliances | values.pairs |
      values.dissipations;
  if (!archive.is_reading())
    return;

  bool fits = state.fields.size() == current.fields.size() && state.multipliers.size() == current.multipliers.size();
  for (std::size_t f = 0; fits && f < state.fields.size(); ++f)
    fits = state.fields[f].size() == current.fields[f].size();
  if (!fits)
    throw ArchiveMismatch("its fields are on another mesh");
  // Factors and partners in contact as a solve would have left them. Solving for internal fields once more changes
  // their last digits, and values depend on the order in which they were summed: so both are put back.
  set_state(state);
  use_chart(in_chart, state.fields[0]);
  current        = std::move(state);
  current_values = std::move(values);
}
} // namespace pellicle

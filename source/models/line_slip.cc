// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/models/line_slip.h>

#include <algorithm>
#include <utility>

namespace pellicle
{
LineSlip::LineSlip(const EdgeLoop &line)
    : line(line)
{
  for (std::size_t c = 0; c < line.n_cells; ++c)
    for (unsigned int i = 0; i < line.tables.n_nodes; ++i)
      nodes[line.cell_nodes[c * line.tables.n_nodes + i]].cells.push_back(c);
  friction_state->n_points = line.tables.n_points;
}

void LineSlip::begin_step(std::vector<double> areas, const bool keeps_last_step)
{
  if (keeps_last_step)
    friction_state->dissipated += dissipated_in_step();
  friction_state->start = areas;
  areas_at_equilibrium  = std::move(areas);
  for (auto &[I, node] : nodes)
    node.status = node.settled;
  tried.clear();
  note_statuses();
}

void LineSlip::forget_statuses()
{
  for (auto &[I, node] : nodes)
    node.settled = SlipStatus::stuck;
}

// Where a node that wants to slip goes the other way once it may, the line is unstable: nothing is gained by going on.
void LineSlip::note_statuses()
{
  std::vector<SlipStatus> now;
  for (const auto &[I, node] : nodes)
    now.push_back(node.status);
  if (!tried.insert(now).second)
    throw SolveError("nodes of the contact line slip and stick in turn without end");
}

std::size_t LineSlip::update(const std::vector<std::size_t> &turned_back, std::vector<Slip> wanted,
                             std::vector<double> areas)
{
  std::size_t changes = turned_back.size(), n_between = 0;
  for (const std::size_t I : turned_back)
    nodes.at(I).status = SlipStatus::stuck;
  std::stable_sort(wanted.begin(), wanted.end(), [](const Slip &a, const Slip &b) { return a.excess > b.excess; });
  for (const Slip &slip : wanted)
    if (may_slip(slip))
    {
      nodes.at(slip.node).status = slip.status;
      ++changes;
    }
    else
      ++n_between;
  if (changes == 0 && n_between > 0)
    throw SolveError("parts of the line that advance and recede meet within one cell of it; a finer mesh, Mesh/"
                     "Refinements, separates them unless the hysteresis is too small for this load");
  if (changes > 0)
  {
    note_statuses();
    return changes;
  }
  for (auto &[I, node] : nodes)
    node.settled = node.status;
  areas_at_equilibrium = std::move(areas);
  return 0;
}

bool LineSlip::may_slip(const Slip &slip) const
{
  const std::vector<std::size_t> &cells = nodes.at(slip.node).cells;
  return std::all_of(cells.begin(), cells.end(),
                     [&](const std::size_t cell)
                     {
                       const SlipStatus there = of_cell(cell);
                       return there == SlipStatus::stuck || there == slip.status;
                     });
}

SlipStatus LineSlip::of_cell(const std::size_t cell) const
{
  for (unsigned int i = 0; i < line.tables.n_nodes; ++i)
    if (const SlipStatus status = of_node(line.cell_nodes[cell * line.tables.n_nodes + i]); status != SlipStatus::stuck)
      return status;
  return SlipStatus::stuck;
}

void LineSlip::set_friction(const double advancing, const double receding)
{
  friction_state->coefficient.assign(line.n_cells, 0.);
  for (std::size_t c = 0; c < line.n_cells; ++c)
    if (const SlipStatus status = of_cell(c); status != SlipStatus::stuck)
      friction_state->coefficient[c] = status == SlipStatus::advancing ? advancing : receding;
}

double LineSlip::dissipated_in_step() const
{
  const LineFrictionState &state = *friction_state;
  double sum = 0., parameter_length = 0.;
  for (std::size_t p = 0; p < state.start.size(); ++p)
  {
    const double weight = line.tables.weights[p % state.n_points];
    sum += weight * state.coefficient[p / state.n_points] * (areas_at_equilibrium[p] - state.start[p]);
    parameter_length += weight;
  }
  return state.start.empty() ? 0. : sum / parameter_length;
}

void LineSlip::exchange(Archive &archive)
{
  archive.name("slip");
  for (auto &[I, node] : nodes)
    archive | node.status | node.settled;
  const std::size_t n_cells = line.n_cells, n_points = n_cells * line.tables.n_points;
  archive.list(friction_state->coefficient, n_cells);
  archive.list(friction_state->start, n_points);
  archive | friction_state->dissipated;
  archive.list(areas_at_equilibrium, n_points);
}

LineSlip::Counts LineSlip::counts() const
{
  Counts counts;
  for (const auto &[I, node] : nodes)
    ++(node.status == SlipStatus::stuck       ? counts.stuck
       : node.status == SlipStatus::advancing ? counts.advancing
                                              : counts.receding);
  return counts;
}

std::string LineSlip::about_sliding() const
{
  const Counts now = counts();
  if (now.advancing + now.receding == 0)
    return "";
  return "the contact line has depinned and the drop slides: of " + std::to_string(nodes.size()) +
         " nodes of the line " + std::to_string(now.advancing) + " advance and " + std::to_string(now.receding) +
         " recede, and no equilibrium was found";
}
} // namespace pellicle

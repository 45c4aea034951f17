// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/edge_frames.h>
#include <pellicle/base/constants.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/point_walk.h>
#include <pellicle/models/line_forces.h>
#include <pellicle/models/line_pinning.h>
#include <pellicle/models/surface_problem.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pellicle
{
namespace
{
// Of cos(theta), and of displacements in internal length: below them is what Newton's method leaves.
constexpr double angle_tolerance = 1e-7, slip_tolerance = 1e-10;
} // namespace

LinePinning::LinePinning(const EdgeLoop &line, const SceneTargets &targets)
    : line(line)
    , drop(targets.drop())
{
  for (std::size_t c = 0; c < line.n_cells; ++c)
    for (unsigned int i = 0; i < line.tables.n_nodes; ++i)
      nodes[line.cell_nodes[c * line.tables.n_nodes + i]].cells.push_back(c);
  friction->n_points = line.tables.n_points;
}

const std::string &LinePinning::name() const
{
  static const std::string text = "line pinning";
  return text;
}

void LinePinning::take(const SceneTargets &targets)
{
  drop = targets.drop();
}

const RigidBody &LinePinning::body() const
{
  return *drop.bodies[line.name == contact_line ? 0 : 1];
}

bool LinePinning::is_pulled_along() const
{
  return drop.body_force[0] != 0. || drop.body_force[1] != 0.;
}

void LinePinning::begin_step(const SurfaceProblem &problem)
{
  const NodalVectors &x = problem.state().fields[0];
  settling              = last_equilibrium.empty() && !is_pulled_along();
  // A step that was taken back has cost nothing.
  if (x == last_equilibrium)
    friction->dissipated += dissipated_in_step(x);
  friction->start.clear();
  for_all_points(line.tables, line.cell_nodes, x, 2,
                 [&](const WalkPoint &point)
                 { friction->start.push_back(wetted_area_density(drop.chart_of(line.name), point[0], point[1])); });
  for (const auto &[I, force] : line_forces(problem, line, drop.chart_of(line.name)))
  {
    Node &node  = nodes.at(I);
    node.start  = body().gap(vector_at(x, I)).foot; // a plate may have moved
    node.across = force.across;
    node.status = node.settled;
  }
  set_friction();
  tried.clear();
  note_statuses();
}

// Where a node that wants to slip goes the other way once it may, the line is unstable: nothing is gained by going on.
void LinePinning::note_statuses()
{
  std::vector<Status> now;
  for (const auto &[I, node] : nodes)
    now.push_back(node.status);
  if (!tried.insert(now).second)
    throw SolveError("nodes of the contact line slip and stick in turn without end");
}

void LinePinning::add_conditions(NodalConditions &conditions) const
{
  if (settling)
    return;
  FieldConditions &position = conditions["position"];
  position.only.resize(position.body.size());
  for (const auto &[I, node] : nodes)
    if (node.status == Status::stuck)
      position.only[I] = held();
}

void LinePinning::place(NodalVectors &positions) const
{
  if (settling)
    return;
  for (const auto &[I, node] : nodes)
    if (node.status == Status::stuck)
      for (unsigned int c = 0; c < 3; ++c)
        positions[3 * I + c] = node.start[c];
}

void LinePinning::add_potentials(PotentialSet &set) const
{
  set.energies.push_back(make_line_friction(name(), drop.chart_of(line.name), friction, line.name));
}

bool LinePinning::leaves_rigid_motions() const
{
  return settling || (counts().stuck == 0 && !is_pulled_along());
}

std::size_t LinePinning::update(const SurfaceProblem &problem)
{
  const NodalVectors &x = problem.state().fields[0];
  std::size_t changes = 0, n_between = 0;
  struct Slip
  {
    double excess = 0.;
    Node *node    = nullptr;
    Status status = Status::stuck;
  };
  std::vector<Slip> wanted;
  const double advancing = threshold(Status::advancing), receding = threshold(Status::receding);
  for (const auto &[I, force] :
       settling ? std::map<std::size_t, LineForce>() : line_forces(problem, line, drop.chart_of(line.name)))
  {
    Node &node          = nodes.at(I);
    const double cosine = force.pull / (drop.surface_tension * force.length);
    const double moved  = 0.5 * dot(vector_at(x, I) - node.start, node.across + force.across);
    if (node.status == Status::stuck && cosine < advancing - angle_tolerance)
      wanted.push_back({advancing - cosine, &node, Status::advancing});
    else if (node.status == Status::stuck && cosine > receding + angle_tolerance)
      wanted.push_back({cosine - receding, &node, Status::receding});
    else if ((node.status == Status::advancing && moved < -slip_tolerance) ||
             (node.status == Status::receding && moved > slip_tolerance))
    {
      node.status = Status::stuck;
      ++changes;
    }
  }
  std::stable_sort(wanted.begin(), wanted.end(), [](const Slip &a, const Slip &b) { return a.excess > b.excess; });
  for (const Slip &slip : wanted)
    if (may_slip(*slip.node, slip.status))
    {
      slip.node->status = slip.status;
      ++changes;
    }
    else
      ++n_between;
  if (changes == 0 && n_between > 0)
    throw SolveError("parts of the line that advance and recede meet within one cell of it; a finer mesh, Mesh/"
                     "Refinements, separates them unless the hysteresis is too small for this load");
  set_friction();
  if (changes > 0)
  {
    note_statuses();
    return changes;
  }
  for (auto &[I, node] : nodes)
    node.settled = node.status;
  last_equilibrium = x;
  return 0;
}

std::string LinePinning::about_failure() const
{
  const Counts now = counts();
  if (!is_pulled_along() || settling || now.advancing + now.receding == 0)
    return "";
  return "the contact line has depinned and the drop slides: of " + std::to_string(nodes.size()) +
         " nodes of the line " + std::to_string(now.advancing) + " advance and " + std::to_string(now.receding) +
         " recede, and no equilibrium was found";
}

LinePinning::Counts LinePinning::counts() const
{
  Counts counts;
  for (const auto &[I, node] : nodes)
    ++(node.status == Status::stuck       ? counts.stuck
       : node.status == Status::advancing ? counts.advancing
                                          : counts.receding);
  return counts;
}

double LinePinning::cosine(const Status status) const
{
  return std::cos(status == Status::stuck       ? drop.contact_angle
                  : status == Status::advancing ? drop.pinning->advancing
                                                : drop.pinning->receding);
}

// Of a discrete line pulled flat, |cos(theta)| may be slightly above one.
double LinePinning::threshold(const Status status) const
{
  constexpr double never = std::numeric_limits<double>::infinity();
  if (status == Status::advancing)
    return drop.pinning->advancing < pi ? cosine(status) : -never;
  return drop.pinning->receding > 0. ? cosine(status) : never;
}

bool LinePinning::may_slip(const Node &node, const Status status) const
{
  return std::all_of(node.cells.begin(), node.cells.end(),
                     [&](const std::size_t cell)
                     {
                       const Status there = status_of_cell(cell);
                       return there == Status::stuck || there == status;
                     });
}

LinePinning::Status LinePinning::status_of_cell(const std::size_t cell) const
{
  for (unsigned int i = 0; i < line.tables.n_nodes; ++i)
    if (const Status status = nodes.at(line.cell_nodes[cell * line.tables.n_nodes + i]).status; status != Status::stuck)
      return status;
  return Status::stuck;
}

void LinePinning::set_friction()
{
  friction->coefficient.assign(line.n_cells, 0.);
  for (std::size_t c = 0; c < line.n_cells; ++c)
    friction->coefficient[c] = drop.surface_tension * (cosine(Status::stuck) - cosine(status_of_cell(c)));
}

double LinePinning::dissipated_in_step(const NodalVectors &positions) const
{
  double sum = 0., parameter_length = 0.;
  std::size_t index = 0;
  for_all_points(line.tables, line.cell_nodes, positions, 2,
                 [&](const WalkPoint &point)
                 {
                   const double weight = line.tables.weights[point.q];
                   sum += weight * friction->coefficient[index / friction->n_points] *
                          (wetted_area_density(drop.chart_of(line.name), point[0], point[1]) - friction->start[index]);
                   parameter_length += weight;
                   ++index;
                 });
  return sum / parameter_length;
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/edge_frames.h>
#include <pellicle/base/constants.h>
#include <pellicle/discretization/point_walk.h>
#include <pellicle/models/line_forces.h>
#include <pellicle/models/line_pinning.h>
#include <pellicle/models/surface_problem.h>

#include <cmath>
#include <limits>
#include <utility>

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
    , slip(line)
{
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
  slip.begin_step(wetted_areas(x), x == last_equilibrium);
  for (const auto &[I, force] : line_forces(problem, line, drop.chart_of(line.name)))
    nodes[I] = {body().gap(vector_at(x, I)).foot, force.across}; // a plate may have moved
  set_friction();
}

void LinePinning::add_conditions(NodalConditions &conditions) const
{
  if (settling)
    return;
  FieldConditions &position = conditions["position"];
  position.only.resize(position.body.size());
  for (const auto &[I, node] : nodes)
    if (slip.of_node(I) == SlipStatus::stuck)
      position.only[I] = held();
}

void LinePinning::place(FieldValues &fields) const
{
  if (settling)
    return;
  for (const auto &[I, node] : nodes)
    if (slip.of_node(I) == SlipStatus::stuck)
      for (unsigned int c = 0; c < 3; ++c)
        fields[0][3 * I + c] = node.start[c];
}

void LinePinning::add_potentials(PotentialSet &set) const
{
  set.energies.push_back(make_line_friction(name(), drop.chart_of(line.name), slip.friction(), line.name));
}

bool LinePinning::leaves_rigid_motions() const
{
  return settling || (counts().stuck == 0 && !is_pulled_along());
}

std::size_t LinePinning::update(const SurfaceProblem &problem)
{
  const NodalVectors &x = problem.state().fields[0];
  std::vector<LineSlip::Slip> wanted;
  std::vector<std::size_t> turned_back;
  const double advancing = threshold(SlipStatus::advancing), receding = threshold(SlipStatus::receding);
  for (const auto &[I, force] :
       settling ? std::map<std::size_t, LineForce>() : line_forces(problem, line, drop.chart_of(line.name)))
  {
    const Node &node        = nodes.at(I);
    const SlipStatus status = slip.of_node(I);
    const double cosine     = force.pull / (drop.surface_tension * force.length);
    const double moved      = 0.5 * dot(vector_at(x, I) - node.start, node.across + force.across);
    if (status == SlipStatus::stuck && cosine < advancing - angle_tolerance)
      wanted.push_back({advancing - cosine, I, SlipStatus::advancing});
    else if (status == SlipStatus::stuck && cosine > receding + angle_tolerance)
      wanted.push_back({cosine - receding, I, SlipStatus::receding});
    else if ((status == SlipStatus::advancing && moved < -slip_tolerance) ||
             (status == SlipStatus::receding && moved > slip_tolerance))
      turned_back.push_back(I);
  }
  const std::size_t changes = slip.update(turned_back, std::move(wanted), wetted_areas(x));
  set_friction();
  if (changes == 0)
    last_equilibrium = x;
  return changes;
}

std::string LinePinning::about_failure() const
{
  return settling || !is_pulled_along() ? "" : slip.about_sliding();
}

void LinePinning::exchange(Archive &archive)
{
  slip.exchange(archive);
  archive | nodes | settling | last_equilibrium;
  for (const auto &[I, node] : nodes)
    if (!slip.has_node(I))
      throw ArchiveMismatch("it has node " + std::to_string(I) + " on the contact line, which is elsewhere");
}

double LinePinning::cosine(const SlipStatus status) const
{
  return std::cos(status == SlipStatus::stuck       ? drop.contact_angle
                  : status == SlipStatus::advancing ? drop.pinning->advancing
                                                    : drop.pinning->receding);
}

// Of a discrete line pulled flat, |cos(theta)| may be slightly above one.
double LinePinning::threshold(const SlipStatus status) const
{
  constexpr double never = std::numeric_limits<double>::infinity();
  if (status == SlipStatus::advancing)
    return drop.pinning->advancing < pi ? cosine(status) : -never;
  return drop.pinning->receding > 0. ? cosine(status) : never;
}

void LinePinning::set_friction()
{
  const auto friction = [&](const SlipStatus status)
  { return drop.surface_tension * (cosine(SlipStatus::stuck) - cosine(status)); };
  slip.set_friction(friction(SlipStatus::advancing), friction(SlipStatus::receding));
}

std::vector<double> LinePinning::wetted_areas(const NodalVectors &positions) const
{
  std::vector<double> areas;
  for_all_points(line.tables, line.cell_nodes, positions, 2,
                 [&](const WalkPoint &point)
                 { areas.push_back(wetted_area_density(drop.chart_of(line.name), point[0], point[1])); });
  return areas;
}
} // namespace pellicle

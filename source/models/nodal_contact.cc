// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/edge_frames.h>
#include <pellicle/models/nodal_contact.h>
#include <pellicle/models/surface_problem.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pellicle
{
namespace
{
constexpr double on_body_gap = 1e-10; // internal length: touching
constexpr double round_off   = 1e-9;  // of the largest contact force
} // namespace

NodalContact::NodalContact(const SurfaceDiscretization &surface, std::vector<std::shared_ptr<const RigidBody>> all,
                           std::vector<bool> exempt_nodes)
    : bodies(std::move(all))
    , exempt(std::move(exempt_nodes))
    , touched(surface.n_nodes, none)
{
  for (const HangingNode &hanging : surface.hanging)
    exempt[hanging.node] = true; // its neighbours' statuses decide where it is
  find_touching(surface.positions);
}

void NodalContact::find_touching(const NodalVectors &positions)
{
  for (std::size_t I = 0; I < touched.size(); ++I)
  {
    touched[I] = none;
    for (std::size_t b = 0; b < bodies.size(); ++b)
      if (!exempt[I] && bodies[b]->gap(vector_at(positions, I)).gap < on_body_gap)
        touched[I] = static_cast<int>(b);
  }
}

bool NodalContact::take_over(const FieldValues &fields)
{
  find_touching(fields[0]);
  return true;
}

const std::string &NodalContact::name() const
{
  static const std::string text = "contact";
  return text;
}

void NodalContact::take(const SceneTargets &targets)
{
  bodies = targets.drop().bodies;
}

void NodalContact::add_conditions(NodalConditions &conditions) const
{
  auto &body = conditions["position"].body;
  body.resize(touched.size());
  for (std::size_t I = 0; I < touched.size(); ++I)
    if (touched[I] != none)
      body[I] = bodies[touched[I]];
}

std::size_t NodalContact::update(const SurfaceProblem &problem)
{
  const NodalVectors &positions = problem.state().fields[0];
  const NodalVectors forces     = problem.nodal_forces().total;
  std::vector<double> pressing(touched.size(), 0.);
  double largest = 0.;
  for (std::size_t I = 0; I < touched.size(); ++I)
    if (touched[I] != none)
    {
      pressing[I] = dot(vector_at(forces, I), bodies[touched[I]]->gap(vector_at(positions, I)).normal);
      largest     = std::max(largest, std::abs(pressing[I]));
    }
  std::size_t changes = 0;
  for (std::size_t I = 0; I < touched.size(); ++I)
  {
    if (exempt[I])
      continue;
    if (touched[I] != none)
    {
      if (pressing[I] < -round_off * largest)
      {
        touched[I] = none;
        ++changes;
      }
      continue;
    }
    for (std::size_t b = 0; b < bodies.size(); ++b)
      if (bodies[b]->gap(vector_at(positions, I)).gap < -on_body_gap)
      {
        touched[I] = static_cast<int>(b);
        ++changes;
        break;
      }
  }
  return changes;
}

std::string NodalContact::about_failure() const
{
  std::string text;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    if (const auto n = std::count(touched.begin(), touched.end(), static_cast<int>(b)); n > 0)
      text += (text.empty() ? "in contact at its nodes: " : ", ") + std::to_string(n) + " on the " + bodies[b]->name() +
              (bodies.size() > 1 ? " " + std::to_string(b + 1) : "");
  return text.empty() ? "no node touches a body" : text;
}

void NodalContact::exchange(Archive &archive)
{
  const std::size_t n = touched.size();
  archive | touched;
  const auto is_known = [&](const int b) { return b == none || (b >= 0 && b < static_cast<int>(bodies.size())); };
  if (touched.size() != n || !std::all_of(touched.begin(), touched.end(), is_known))
    throw ArchiveMismatch("it has nodes in contact with bodies that are not there");
}

std::size_t NodalContact::n_active() const
{
  return static_cast<std::size_t>(std::count_if(touched.begin(), touched.end(), [](const int b) { return b != none; }));
}

bool NodalContact::touches(const std::size_t node, const std::size_t body) const
{
  return touched[node] == static_cast<int>(body);
}
} // namespace pellicle

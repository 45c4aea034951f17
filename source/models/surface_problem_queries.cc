// SPDX-License-Identifier: LGPL-2.1-or-later
// What others ask of a surface problem at its present state.
#include <pellicle/assembly/edge_frames.h>
#include <pellicle/discretization/hanging_nodes.h>
#include <pellicle/models/surface_problem.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pellicle
{
SurfaceProblem::NodalForces SurfaceProblem::nodal_forces() const
{
  const Timing::Scope scope(timing, "assembly");
  const std::size_t n = 3 * surface.n_nodes;
  NodalForces forces{NodalVectors(n, 0.), std::vector<NodalVectors>(set.constraints.size(), NodalVectors(n, 0.))};
  const auto add = [](const Cell &cell, const std::vector<double> &gradient, NodalVectors &sum)
  {
    for (unsigned int c = 0; c < 3; ++c)
      for (std::size_t i = 0; i < cell.n_nodes; ++i)
        sum[3 * cell.nodes[i] + c] += gradient[c * cell.n_nodes + i]; // the position is the first field
  };
  assembler.loop(set, current.fields, current.multipliers, Order::gradient,
                 [&](const Cell &cell, const Element &element, const auto &constraint_gradients)
                 {
                   add(cell, element.gradient, forces.total);
                   for (std::size_t k = 0; k < forces.constraints.size(); ++k)
                     if (!constraint_gradients[k].empty())
                       add(cell, constraint_gradients[k], forces.constraints[k]);
                 });
  communicator.sum(forces.total);
  for (NodalVectors &gradient : forces.constraints)
    communicator.sum(gradient);
  if (pair_terms)
  {
    const NodalVectors of_pairs = pair_forces();
    for (std::size_t i = 0; i < n; ++i)
      forces.total[i] += of_pairs[i];
  }
  hand_over_forces(surface.hanging, forces.total);
  for (NodalVectors &gradient : forces.constraints)
    hand_over_forces(surface.hanging, gradient);
  return forces;
}

NodalVectors SurfaceProblem::nodal_forces(const PotentialSet &part, const std::string &field) const
{
  const std::size_t first = 3 * field_layout.index(field);
  NodalVectors sum(3 * surface.n_nodes, 0.);
  Assembler other(surface, field_layout, part, communicator, Assembler::everything(part, field_layout));
  other.loop(part, current.fields, current.multipliers, Order::gradient,
             [&](const Cell &cell, const Element &element, const auto &)
             {
               for (unsigned int c = 0; c < 3; ++c)
                 for (std::size_t i = 0; i < cell.n_nodes; ++i)
                   sum[3 * cell.nodes[i] + c] += element.gradient[(first + c) * cell.n_nodes + i];
             });
  communicator.sum(sum);
  hand_over_forces(surface.hanging, sum);
  return sum;
}

std::shared_ptr<const RigidBody> SurfaceProblem::body_of(const std::size_t node) const
{
  const auto found = conditions.find("position");
  return found != conditions.end() && !found->second.body.empty() ? found->second.body[node] : nullptr;
}

std::vector<double> SurfaceProblem::gradient_of(const PotentialSet &further) const
{
  const Timing::Scope scope(timing, "assembly");
  std::vector<NodalVectors> gradients(field_layout.fields().size(), NodalVectors(3 * surface.n_nodes, 0.));
  Assembler other(surface, field_layout, further, communicator, Assembler::everything(further, field_layout));
  other.loop(further, current.fields, {}, Order::gradient,
             [&](const Cell &cell, const Element &element, const auto &)
             {
               for (std::size_t f = 0; f < gradients.size(); ++f)
                 for (unsigned int c = 0; c < 3; ++c)
                   for (std::size_t i = 0; i < cell.n_nodes; ++i)
                     gradients[f][3 * cell.nodes[i] + c] += element.gradient[(3 * f + c) * cell.n_nodes + i];
             });
  const Numbering &numbering = system->numbering();
  std::vector<double> result(numbering.size(), 0.);
  for (std::size_t f = 0; f < gradients.size(); ++f)
  {
    communicator.sum(gradients[f]);
    system->restrict_vector(f, gradients[f], result);
    for (std::size_t I = 0; I < numbering.charts[f].nodes.size(); ++I)
      for (unsigned int a = 0; a < numbering.count(f, I); ++a)
        if (numbering.charts[f].nodes[I].mesh_equation[a])
          result[numbering.first_of(f, I) + a] = 0.;
  }
  return result;
}

double SurfaceProblem::value_of(const PotentialSet &further) const
{
  Assembler other(surface, field_layout, further, communicator, Assembler::everything(further, field_layout));
  const std::vector<double> values = other.loop(further, current.fields, {}, Order::value).energies;
  return std::accumulate(values.begin(), values.end(), 0.);
}

std::vector<double> SurfaceProblem::area_weights() const
{
  const Numbering &numbering = system->numbering();
  std::vector<double> weights(numbering.size(), 0.);
  for (std::size_t I = 0; I < surface.n_nodes; ++I)
    for (unsigned int a = 0; a < numbering.count(0, I); ++a)
      if (!numbering.charts[0].nodes[I].mesh_equation[a])
        weights[numbering.first_of(0, I) + a] += node_areas[I];
  return weights;
}

double SurfaceProblem::displacement(const std::vector<double> &direction) const
{
  double largest = 0.;
  for (std::size_t f = 0; f < field_layout.fields().size(); ++f)
  {
    if (!is_moving(f))
      continue;
    const NodalVectors move = displacements(direction, f);
    for (std::size_t I = 0; I < surface.n_nodes; ++I)
    {
      const double length = norm(vector_at(move, I));
      if (!(length <= largest)) // keeps nan
        largest = length;
    }
  }
  return largest;
}

std::vector<double> SurfaceProblem::direction_of(const NodalVectors &displacements) const
{
  // Its own columns, which are orthonormal, account for what carriers do not.
  NodalVectors own                                              = displacements;
  const std::vector<std::vector<NodalChart::Carrier>> &carriers = system->numbering().charts[0].carriers;
  for (std::size_t I = 0; I < carriers.size(); ++I)
    for (const NodalChart::Carrier &carrier : carriers[I])
      for (unsigned int c = 0; c < 3; ++c)
        own[3 * I + c] -= carrier.share[c] * displacements[3 * carrier.node + c];
  std::vector<double> direction(system->numbering().size(), 0.);
  for (std::size_t I = 0; I < surface.n_nodes; ++I)
  {
    const NodalChart::Node &node = system->numbering().charts[0].nodes[I];
    for (unsigned int a = 0; a < node.count; ++a)
    {
      double &along = direction[system->numbering().first_of(0, I) + a];
      for (unsigned int c = 0; c < 3; ++c)
        along += node.columns[3 * a + c] * own[3 * I + c];
    }
  }
  return direction;
}

NodalVectors SurfaceProblem::displacements(const std::vector<double> &direction, const std::size_t field) const
{
  NodalVectors move(3 * surface.n_nodes, 0.);
  system->add_columns(direction, 1., field, move);
  return move;
}

std::size_t SurfaceProblem::field_that_moves() const
{
  for (std::size_t f = 0; f < field_layout.fields().size(); ++f)
    if (is_moving(f) && system->numbering().n_unknowns_of(f) > 0)
      return f;
  return 0;
}

void SurfaceProblem::displace(SurfaceState &state, const std::size_t field, const double factor,
                              const NodalVectors &changes) const
{
  NodalVectors &values = state.fields[field];
  for (std::size_t i = 0; i < changes.size(); ++i)
    values[i] += factor * changes[i];
  if (field_layout.fields()[field].space != FieldSpace::unit_vectors)
    return;
  for (std::size_t I = 0; I < surface.n_nodes; ++I)
  {
    const Vector3<double> v = vector_at(values, I);
    set_vector_at(values, I, (1. / norm(v)) * v);
  }
}

double SurfaceProblem::energy() const
{
  double sum = energy_of_self_terms(current_values, current.multipliers);
  for (const double energy : current_values.energies)
    sum += energy;
  for (const double energy : current_values.pairs)
    sum += energy;
  return sum;
}

std::vector<const AssemblyCounters *> SurfaceProblem::counters() const
{
  std::vector<const AssemblyCounters *> all{&assembler.counters(), &elimination.counters()};
  if (mesh_assembler)
    all.push_back(&mesh_assembler->counters());
  return all;
}
} // namespace pellicle

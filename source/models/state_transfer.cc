// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/edge_frames.h>
#include <pellicle/discretization/admissible.h>
#include <pellicle/discretization/edge_loops.h>
#include <pellicle/discretization/mesh_transfer.h>
#include <pellicle/models/state_transfer.h>

#include <algorithm>
#include <utility>

namespace pellicle
{
namespace
{
bool have_the_same_unknowns(const SurfaceProblem &a, const SurfaceProblem &b)
{
  const auto &fields = a.layout().fields(), &others = b.layout().fields();
  return a.potentials().constraints.size() == b.potentials().constraints.size() &&
         std::equal(fields.begin(), fields.end(), others.begin(), others.end(),
                    [](const Field &f, const Field &g) { return f.name == g.name && f.space == g.space; });
}

/** Where a field stood at the start of the problem; null: nowhere in particular. */
const NodalVectors *start_of(const SurfaceProblem &problem, const Field &field)
{
  const SurfaceDiscretization &surface = problem.discretization();
  if (field.name == "position")
    return &surface.positions;
  const auto given = surface.start_values.find(field.name);
  return given == surface.start_values.end() ? nullptr : &given->second;
}

/** The fields of one problem seen from the other. */
class Fields
{
public:
  Fields(const SurfaceProblem &from, const SurfaceProblem &to, const Vector3<double> &shift)
      : from(from)
      , to(to)
      , shift(shift)
      , carry(from.discretization(), to.discretization())
      , on_edge(nodes_of_edges(to.discretization()))
      , is_material(to.needs_material_chart())
  {
  }

  NodalVectors at(const std::size_t f) const
  {
    const Field &field        = to.layout().fields()[f];
    const bool is_on_edge     = field.space == FieldSpace::edge_conormals || field.space == FieldSpace::edge_scalars;
    const bool is_unit        = field.space == FieldSpace::edge_conormals || field.space == FieldSpace::unit_vectors;
    const NodalVectors wanted = wanted_values(f);
    NodalVectors values       = to.state().fields[f];
    for (std::size_t I = 0; I < to.discretization().n_nodes; ++I)
    {
      const Vector3<double> start = vector_at(values, I);
      // An edge's unit vectors are zero where the edge has none.
      if ((is_on_edge && !on_edge[I]) || (is_unit && dot(start, start) == 0.))
        continue;
      Vector3<double> value = start + admissible_change(field, I, vector_at(wanted, I) - start);
      if (is_unit)
        value = (1. / norm(value)) * value;
      if (field.name == "position")
        value = on_its_body(I, value);
      set_vector_at(values, I, value);
    }
    return values;
  }

private:
  NodalVectors wanted_values(const std::size_t f) const
  {
    const Field &field        = to.layout().fields()[f];
    const NodalVectors *start = start_of(to, field), *start_before = start_of(from, field);
    if (is_material && field.space == FieldSpace::vectors && start != nullptr && start_before != nullptr)
    {
      NodalVectors changes = from.state().fields[f];
      for (std::size_t i = 0; i < changes.size(); ++i)
        changes[i] -= (*start_before)[i];
      NodalVectors values = carry(changes);
      for (std::size_t i = 0; i < values.size(); ++i)
        values[i] += (*start)[i];
      return values;
    }
    NodalVectors values = carry(from.state().fields[f]);
    if (field.name == "position")
      for (std::size_t i = 0; i < values.size(); ++i)
        values[i] -= shift[static_cast<unsigned int>(i % 3)];
    return values;
  }

  Vector3<double> admissible_change(const Field &field, const std::size_t node, const Vector3<double> &change) const
  {
    const auto condition            = to.nodal_conditions().find(field.name);
    AdmissibleDirections directions = admissible_at(to.discretization(), node);
    if (condition != to.nodal_conditions().end() && !condition->second.only.empty() && condition->second.only[node])
      directions = *condition->second.only[node];
    return directions.count == 3 ? change : admissible_part(directions, change);
  }

  Vector3<double> on_its_body(const std::size_t node, const Vector3<double> &place) const
  {
    const auto body = to.body_of(node);
    return body ? body->gap(place).foot : place;
  }

  const SurfaceProblem &from, &to;
  const Vector3<double> shift;
  const MeshTransfer carry;
  const std::vector<bool> on_edge;
  const bool is_material;
};
} // namespace

std::optional<SurfaceState> transferred_state(const SurfaceProblem &from, const SurfaceProblem &to,
                                              const Vector3<double> &shift)
{
  if (!have_the_same_unknowns(from, to) || !MeshTransfer::is_possible(from.discretization(), to.discretization()))
    return std::nullopt;
  const Fields fields(from, to, shift);
  SurfaceState state;
  for (std::size_t f = 0; f < to.layout().fields().size(); ++f)
    state.fields.push_back(fields.at(f));
  state.multipliers = from.state().multipliers;
  return state;
}
} // namespace pellicle

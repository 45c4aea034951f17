// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/edge_frames.h>
#include <pellicle/assembly/nodal_conditions.h>
#include <pellicle/discretization/admissible.h>

namespace pellicle
{
AdmissibleDirections held()
{
  AdmissibleDirections none;
  none.count   = 0;
  none.columns = {};
  return none;
}

namespace
{
using Direction                = Vector3<double>;
constexpr double smallest_sine = 1e-6; // of a direction with the normal, to count as tangential

/** Appends the part of a direction that is tangential to the body and orthogonal to the columns, if there is any. */
void append_tangential(const Direction &wanted, const Direction &normal, const bool mesh_equation,
                       NodalChart::Node &node)
{
  Direction d = wanted - dot(wanted, normal) * normal;
  for (unsigned int j = 0; j < node.count; ++j)
  {
    const Direction column(node.columns[3 * j], node.columns[3 * j + 1], node.columns[3 * j + 2]);
    d -= dot(d, column) * column;
  }
  const double length = norm(d);
  if (length < smallest_sine)
    return;
  for (unsigned int c = 0; c < 3; ++c)
    node.columns[3 * node.count + c] = d[c] / length;
  node.mesh_equation[node.count++] = mesh_equation;
}
} // namespace

void keep_on_bodies(const FieldConditions &conditions, const SurfaceDiscretization &discretization,
                    const NodalVectors &positions, const TangentialMotion tangential, NodalChart &chart)
{
  const std::map<std::size_t, Direction> lines = nodal_line_tangents(discretization, positions);
  chart.on_body.resize(discretization.n_nodes);
  for (std::size_t I = 0; I < conditions.body.size(); ++I)
  {
    const bool is_held = I < conditions.only.size() && conditions.only[I] && conditions.only[I]->count == 0;
    if (!conditions.body[I] || is_held)
      continue;
    const GapSample here = conditions.body[I]->gap(vector_at(positions, I));
    NodalChart::Node node;
    if (chart.on_body[I])
    {
      const NodalChart::Node &before = chart.nodes[I];
      for (unsigned int j = 0; j < before.count; ++j)
        append_tangential({before.columns[3 * j], before.columns[3 * j + 1], before.columns[3 * j + 2]}, here.normal,
                          before.mesh_equation[j], node);
      chart.on_body[I]->here = here;
      chart.nodes[I]         = node;
      continue;
    }
    chart.on_body[I] = NodalChart::OnBody{conditions.body[I], here};
    if (const auto line = lines.find(I); line != lines.end())
      append_tangential(cross(line->second, here.normal), here.normal, false, node);
    const AdmissibleDirections all = admissible_at(discretization, I);
    // The second of two directions in a plane may come from any of the three.
    for (unsigned int j = 0; j < all.count && node.count < 2 && tangential != TangentialMotion::none; ++j)
      append_tangential({all.columns[j][0], all.columns[j][1], all.columns[j][2]}, here.normal,
                        tangential == TangentialMotion::mesh, node);
    chart.nodes[I] = node;
  }
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
    if (I >= these.only.size() || !these.only[I])
      chart.nodes[I] = chart.nodes[these.leader[I]];
    if (!chart.unit_vectors.empty())
      chart.unit_vectors[I] = chart.unit_vectors[these.leader[I]];
  }
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
// Pair terms of a surface problem, and the nodes that are material points in every chart.
#include <pellicle/assembly/cells.h>
#include <pellicle/models/surface_problem.h>

#include <algorithm>
#include <utility>

namespace pellicle
{
namespace
{
/** Whether a potential sees the tangential motion of a node that is not material. */
bool sees_gauge(const Potential &potential, const SurfaceDiscretization &surface, const std::vector<bool> &material)
{
  const Where &where = potential.where();
  if (potential.reparametrisation_invariant() || where.part == Where::Part::bulk)
    return false;
  const std::size_t set = set_of(surface, where), n_local = tables_of(surface, set).n_nodes;
  const auto &nodes       = set == 0 ? surface.cell_nodes : surface.edges[set - 1].cell_nodes;
  const auto is_elsewhere = [&](const std::size_t cell)
  {
    return where.part == Where::Part::region && !surface.cell_region.empty() &&
           surface.region_names[surface.cell_region[cell]] != where.name;
  };
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (!material[nodes[i]] && !is_elsewhere(i / n_local))
      return true;
  return false;
}
} // namespace

void SurfaceProblem::find_material_nodes()
{
  material.assign(surface.n_nodes, false);
  for (const BulkPart &body : surface.bulks)
    for (std::size_t i = 0; i < body.cell_nodes.size(); ++i)
      if (i % body.tables.n_nodes < body.tables.n_nodes - body.n_pressure_nodes)
        material[body.cell_nodes[i]] = true;
  if (pair_terms)
    for (const auto &term : pair_terms->terms())
      for (const std::size_t node : term->material_nodes())
        material[node] = true;
}

bool SurfaceProblem::needs_material_chart() const
{
  if (std::all_of(surface.cell_nodes.begin(), surface.cell_nodes.end(),
                  [this](const std::size_t node) { return material[node]; }))
    return true;
  const auto sees = [this](const Potential &potential) { return sees_gauge(potential, surface, material); };
  for (const auto &energy : set.energies)
    if (sees(*energy))
      return true;
  for (const Dissipation &dissipation : set.dissipations)
    if (sees(*dissipation.over_step))
      return true;
  for (const Constraint &constraint : set.constraints)
    for (std::size_t p = 0; p < constraint.n_parts(); ++p)
      if (sees(constraint.part(p)))
        return true;
  return false;
}

void SurfaceProblem::set_pairs(std::shared_ptr<PairTerms> pairs)
{
  pair_terms = std::move(pairs);
  find_material_nodes();
  current_values = evaluate(current);
}

NodalVectors SurfaceProblem::pair_forces() const
{
  NodalVectors forces(3 * surface.n_nodes, 0.);
  if (!pair_terms)
    return forces;
  pair_terms->evaluate(current.fields[0], Order::gradient);
  for (const ContactElement &element : pair_terms->elements())
  {
    const std::size_t n = element.nodes.size();
    for (unsigned int c = 0; c < 3; ++c)
      for (std::size_t i = 0; i < n; ++i)
        forces[3 * element.nodes[i] + c] += element.derivatives.gradient[c * n + i];
  }
  communicator.sum(forces);
  return forces;
}
} // namespace pellicle

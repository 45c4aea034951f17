// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/body_nodes.h>
#include <pellicle/assembly/carried_nodes.h>
#include <pellicle/assembly/edge_frames.h>
#include <pellicle/assembly/field_charts.h>
#include <pellicle/assembly/hanging_carriers.h>
#include <pellicle/assembly/rim_directions.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/hanging_nodes.h>
#include <pellicle/discretization/point_walk.h>
#include <pellicle/models/surface_problem.h>
#include <pellicle/potentials/energies/mesh_distortion.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace pellicle
{
namespace
{
constexpr double rigid_rho =
    1e4; // stiffness of the gauge against rigid motions; its size has no influence on a solution
constexpr double chart_reach = 0.1; // displacement, relative to the length, after which normals and gauge are renewed
// Forces below it, in internal units, count as this large: where a skin is free of stress there are none to compare
// the residual with.
constexpr double smallest_forces = 1e-4;

// Integral of N_I (t + r x x) for each rigid motion: displacements that the gauge allows are orthogonal to it in L2,
// and so are the modes of a stability analysis. (Positive weights of nodes would do for a gauge, but a mode of high
// order would take up a rigid motion of order h^2.)
std::vector<NodalVectors> weighted_rigid_motions(const SurfaceDiscretization &discretization,
                                                 const NodalVectors &positions)
{
  const ShapeTables &tables = discretization.tables;
  std::vector<NodalVectors> directions(discretization.rigid_motions.size(),
                                       NodalVectors(3 * discretization.n_nodes, 0.));
  const auto add = [&](const WalkPoint &x)
  {
    const double dA = x.area();
    for (std::size_t k = 0; k < directions.size(); ++k)
    {
      const RigidMotion &motion = discretization.rigid_motions[k];
      const Vector3<double> t(motion.translation[0], motion.translation[1], motion.translation[2]);
      const Vector3<double> r(motion.rotation[0], motion.rotation[1], motion.rotation[2]);
      const Vector3<double> v = t + cross(r, x[0]);
      for (unsigned int I = 0; I < tables.n_nodes; ++I)
        for (unsigned int c = 0; c < 3; ++c)
          directions[k][3 * x.nodes[I] + c] += tables.tables[0][std::size_t(x.q) * tables.n_nodes + I] * dA * v[c];
    }
  };
  if (!directions.empty())
    for_all_points(tables, discretization.cell_nodes, positions, 3, add);
  return directions;
}
} // namespace

bool is_reparametrisation_invariant(const PotentialSet &set)
{
  return std::all_of(set.energies.begin(), set.energies.end(),
                     [](const auto &energy) { return energy->reparametrisation_invariant(); }) &&
         std::all_of(set.dissipations.begin(), set.dissipations.end(),
                     [](const Dissipation &d) { return d.over_step->reparametrisation_invariant(); }) &&
         std::all_of(set.constraints.begin(), set.constraints.end(),
                     [](const Constraint &c)
                     {
                       bool all = true;
                       for (std::size_t p = 0; p < c.n_parts(); ++p)
                         all = all && c.part(p).reparametrisation_invariant();
                       return all;
                     });
}

std::vector<ReferenceMetric> reference_metric(const SurfaceDiscretization &discretization,
                                              const NodalVectors &positions)
{
  const ShapeTables &tables = discretization.tables;
  std::vector<ReferenceMetric> metric;
  metric.reserve(discretization.n_cells * tables.n_points);
  for_all_points(tables, discretization.cell_nodes, positions, 3,
                 [&](const WalkPoint &x) {
                   metric.push_back({dot(x[1], x[1]), dot(x[1], x[2]), dot(x[2], x[2])});
                 });
  return metric;
}

// Positions of the start shape, which are the places of material points as well, its conormals on the edges that have
// them as unknowns, its normals for unit vectors; what the discretization gives; zero for the rest.
FieldValues start_fields(const SurfaceDiscretization &discretization, const FieldLayout &layout,
                         const NodalConditions &conditions)
{
  FieldValues fields;
  for (const Field &field : layout.fields())
  {
    const bool is_place = field.name == "position" || field.space == FieldSpace::material_places;
    fields.push_back(is_place ? discretization.positions : NodalVectors(3 * discretization.n_nodes, 0.));
    if (const auto given = discretization.start_values.find(field.name); given != discretization.start_values.end())
      fields.back() = given->second;
    else if (field.space == FieldSpace::unit_vectors)
      fields.back() = nodal_normals(discretization, discretization.positions);
    if (field.space != FieldSpace::edge_conormals)
      continue;
    const auto &only           = conditions.at(field.name).only;
    const NodalVectors normals = nodal_normals(discretization, discretization.positions);
    for (const auto &[node, nu] : nodal_conormals(discretization, discretization.positions, normals))
      if (!only[node])
        for (unsigned int c = 0; c < 3; ++c)
          fields.back()[3 * node + c] = nu[c];
  }
  return fields;
}

double energy_of_self_terms(const TermValues &values, const std::vector<double> &multipliers)
{
  double sum = 0.;
  for (std::size_t k = 0; k < multipliers.size(); ++k)
    sum += 0.5 * multipliers[k] * multipliers[k] * values.compliances[k];
  return sum;
}

SurfaceProblem::SurfaceProblem(const SurfaceDiscretization &discretization, PotentialSet potential_set,
                               NodalConditions nodal_conditions, const Communicator &communicator,
                               std::string linear_solver, Timing &timing)
    : surface(discretization)
    , set(std::move(potential_set))
    , conditions(std::move(nodal_conditions))
    , communicator(communicator)
    , timing(timing)
    , field_layout(set)
    , assembler(surface, field_layout, set, communicator, Assembler::everything(set, field_layout))
    , elimination(surface, field_layout, set, conditions, start_fields(surface, field_layout, conditions), communicator,
                  linear_solver, timing)
{
  find_material_nodes();
  SurfaceState start;
  start.fields = start_fields(surface, field_layout, conditions);
  start.multipliers.assign(set.constraints.size(), 0.);
  set_state(std::move(start));
}

void SurfaceProblem::set_potentials(PotentialSet potential_set)
{
  set = std::move(potential_set);
  set_state(current);
}

void SurfaceProblem::set_conditions(NodalConditions nodal_conditions)
{
  conditions = std::move(nodal_conditions);
  bool moved = false;
  if (const auto of_position = conditions.find("position"); of_position != conditions.end())
    for (std::size_t I = 0; I < of_position->second.body.size(); ++I)
      if (const auto &body = of_position->second.body[I])
      {
        const GapSample gap = body->gap(vector_at(current.fields[0], I));
        moved               = moved || gap.gap != 0.;
        for (unsigned int c = 0; c < 3; ++c)
          current.fields[0][3 * I + c] = gap.foot[c];
      }
  if (moved)
    set_state(current);
}

void SurfaceProblem::set_state(SurfaceState state)
{
  current = std::move(state);
  for (std::size_t f = 0; f < current.fields.size(); ++f)
    if (covers_surface(field_layout.fields()[f]))
      join_hanging_nodes(surface.hanging, current.fields[f]);
  if (!elimination.empty() && !elimination.solve(set, current.multipliers, current.fields))
    throw SolveError("The equations of the internal fields (moment) cannot be solved on this shape: a cell is "
                     "degenerate. Refine the mesh, lower its "
                     "degree or give a better start shape.");
  current_values = evaluate(current);
}

void SurfaceProblem::use_chart(const PositionChart new_chart, const NodalVectors &mesh_reference)
{
  // Reactions of another chart balance other forces.
  if (chart != new_chart || current.rigid_reactions.size() != n_rigid())
    current.rigid_reactions.assign(n_rigid(), 0.);
  chart = new_chart;
  if (chart == PositionChart::graph && surface.has_junctions())
    find_sheet_carriers();
  const bool all_free = std::find(material.begin(), material.end(), false) == material.end();
  if (chart != PositionChart::material && !all_free && needs_material_chart())
    throw UserError("Newton/Chart = ale and graph keep the nodes from following tangential forces, but a listed effect "
                    "acts tangentially (it refers to material points). Use Newton/Chart = automatic.");
  if (chart == PositionChart::ale)
  {
    mesh_set = {};
    mesh_set.energies.push_back(make_mesh_distortion(reference_metric(surface, mesh_reference)));
    mesh_layout    = std::make_unique<FieldLayout>(mesh_set);
    mesh_assembler = std::make_unique<Assembler>(surface, *mesh_layout, mesh_set, communicator,
                                                 Assembler::everything(mesh_set, *mesh_layout));
  }

  system = std::make_unique<BorderedSystem>(surface, Numbering(charts_here(), set.constraints.size(), n_rigid()),
                                            communicator);
  renew_gauge();
}

// Sheets follow the lines where they meet others, and bodies.
void SurfaceProblem::find_sheet_carriers()
{
  std::vector<bool> own = material, is_held(surface.n_nodes, false);
  for (const EdgeLoop &loop : surface.edges)
    if (loop.is_junction)
      for (const std::size_t node : loop.cell_nodes)
        own[node] = true;
  if (const auto of_position = conditions.find("position"); of_position != conditions.end())
    for (std::size_t I = 0; I < of_position->second.only.size(); ++I)
      is_held[I] = of_position->second.only[I] && of_position->second.only[I]->count == 0;
  sheet_carriers = carriers_of_sheets(surface, surface.positions, own, is_held);
}

std::vector<NodalChart> SurfaceProblem::charts_here() const
{
  const NodalVectors normals = chart == PositionChart::material ? NodalVectors{} : transversal_directions();
  std::vector<NodalChart> charts;
  for (std::size_t f = 0; f < field_layout.fields().size(); ++f)
  {
    const Field &field = field_layout.fields()[f];
    if (field.name != "position")
    {
      charts.push_back(chart_of_field(surface, field, current.fields[0], current.fields[f], conditions));
      continue;
    }
    charts.push_back(chart == PositionChart::material ? free_chart(surface)
                     : chart == PositionChart::graph  ? graph_chart(surface, current.fields[0], normals)
                                                      : ale_chart(surface, current.fields[0], normals));
    free_nodes(surface, material, charts.back());
    if (chart == PositionChart::graph)
      charts.back().carriers = sheet_carriers;
    apply_conditions(conditions, field.name, charts.back());
    keep_nodes_on_bodies(charts.back());
    carry_hanging_nodes(surface, charts.back());
  }
  return charts;
}

// Normals, but near lines that stay on bodies.
NodalVectors SurfaceProblem::transversal_directions() const
{
  NodalVectors normals   = nodal_normals(surface, current.fields[0]);
  const auto of_position = conditions.find("position");
  if (of_position == conditions.end() || of_position->second.body.empty())
    return normals;
  return directions_towards_bodies(of_position->second, surface, current.fields[0], normals);
}

void SurfaceProblem::keep_nodes_on_bodies(NodalChart &positions) const
{
  const auto of_position = conditions.find("position");
  if (of_position == conditions.end() || of_position->second.body.empty())
    return;
  const TangentialMotion tangential = chart == PositionChart::material ? TangentialMotion::physical
                                      : chart == PositionChart::ale    ? TangentialMotion::mesh
                                                                       : TangentialMotion::none;
  keep_on_bodies(of_position->second, surface, current.fields[0], tangential, positions);
}

// Weights and rigid motions of the present shape.
void SurfaceProblem::renew_gauge()
{
  node_areas       = nodal_weights(surface, current.fields[0]);
  rigid_directions = rigid_gauge ? weighted_rigid_motions(surface, current.fields[0]) : std::vector<NodalVectors>();
  moved_in_chart   = 0.;
}

double SurfaceProblem::constraint_residual(const std::size_t k, const TermValues &values, const double lambda) const
{
  return values.constraints[k] - set.constraints[k].target - lambda / set.constraints[k].stiffness;
}

void SurfaceProblem::linearize()
{
  const Timing::Scope scope(timing, "assembly");
  for (std::size_t f = 0; f < field_layout.fields().size(); ++f)
    if (const Field &field = field_layout.fields()[f]; chart_follows_values(field))
      system->set_chart(f, chart_of_field(surface, field, current.fields[0], current.fields[f], conditions));
  if (!system->numbering().charts[0].on_body.empty())
  {
    NodalChart positions = system->numbering().charts[0];
    keep_nodes_on_bodies(positions);
    carry_hanging_nodes(surface, positions);
    system->set_chart(0, std::move(positions));
  }
  std::vector<double> of_pairs;
  if (pair_terms)
  {
    of_pairs = pair_terms->evaluate(current.fields[0], Order::hessian);
    system->make_room(pair_terms->elements());
  }
  system->begin();
  TermValues mesh_values{{0.}, {}, {}, {}};
  Element mesh_element;
  std::vector<std::vector<double>> no_constraints;
  const bool with_mesh          = chart == PositionChart::ale;
  const FieldValues mesh_fields = with_mesh ? FieldValues{current.fields[0]} : FieldValues{};
  current_values =
      assembler.loop(set, current.fields, current.multipliers, Order::hessian,
                     [&](const Cell &cell, const Element &element, const auto &constraint_gradients)
                     {
                       const bool has_mesh = with_mesh && cell.set == 0;
                       if (has_mesh)
                         mesh_assembler->evaluate(mesh_set, mesh_fields, {}, Order::hessian, cell, mesh_values,
                                                  mesh_element, no_constraints);
                       system->add_cell(cell, element, constraint_gradients, has_mesh ? &mesh_element : nullptr);
                     });
  current_values.pairs = std::move(of_pairs);
  if (pair_terms)
    for (const ContactElement &element : pair_terms->elements())
      system->add_pair(element);
  for (std::size_t k = 0; k < set.constraints.size(); ++k)
    system->set_constraint(k, 1. / set.constraints[k].stiffness + current_values.compliances[k],
                           constraint_residual(k, current_values, current.multipliers[k]));
  for (std::size_t k = 0; k < rigid_directions.size(); ++k)
    system->set_rigid_motion(k, rigid_directions[k], 1. / rigid_rho, current.rigid_reactions[k]);
  system->finish();
}

double SurfaceProblem::relative_residual() const
{
  return system->residual_norm() / std::max(system->contribution_norm(), smallest_forces);
}

double SurfaceProblem::constraint_violation() const
{
  double largest = 0.; // targets far below one, in internal units, are held absolutely
  for (std::size_t k = 0; k < set.constraints.size(); ++k)
    largest = std::max(largest, std::abs(constraint_residual(k, current_values, current.multipliers[k])) /
                                    std::max(1., std::abs(set.constraints[k].target)));
  return largest;
}

void SurfaceProblem::add_drag(const double zeta)
{
  const Numbering &numbering = system->numbering();
  std::vector<double> weights(numbering.n_nodal, 0.);
  for (std::size_t f = 0; f < numbering.n_fields(); ++f)
    if (is_moving(f))
      for (std::size_t I = 0; I < surface.n_nodes; ++I)
        for (unsigned int a = 0; a < numbering.count(f, I); ++a)
          weights[numbering.first_of(f, I) + a] += node_areas[I];
  system->add_to_diagonal(weights, zeta);
}

int SurfaceProblem::expected_negative_pivots() const
{
  const Numbering &numbering = system->numbering();
  std::size_t n              = numbering.n_constraints + numbering.n_rigid;
  for (std::size_t f = 0; f < numbering.n_fields(); ++f)
    if (is_multiplier(f))
      n += numbering.n_unknowns_of(f);
  return elimination.negative_eigenvalues() + static_cast<int>(n);
}

bool SurfaceProblem::is_multiplier(const std::size_t field) const
{
  return field_layout.fields()[field].role == FieldRole::multiplier;
}

bool SurfaceProblem::is_moving(const std::size_t f) const
{
  const Field &field = field_layout.fields()[f];
  return field.role == FieldRole::independent &&
         (field.space == FieldSpace::vectors || field.space == FieldSpace::unit_vectors);
}

TermValues SurfaceProblem::evaluate(const SurfaceState &state) const
{
  const Timing::Scope scope(timing, "assembly");
  TermValues values = assembler.loop(set, state.fields, state.multipliers, Order::value);
  if (pair_terms)
    values.pairs = pair_terms->evaluate(state.fields[0], Order::value);
  return values;
}

double SurfaceProblem::try_step(const std::vector<double> &direction, const double length)
{
  trial = current;
  try
  {
    for (std::size_t f = 0; f < field_layout.fields().size(); ++f)
      system->prolongate(direction, is_multiplier(f) ? 1. : length, f, trial.fields[f]);
  }
  catch (const SolveError &)
  {
    return std::numeric_limits<double>::infinity(); // a step too far from a body
  }
  trial.multipliers = full_step_multipliers(direction);
  for (std::size_t k = 0; k < trial.rigid_reactions.size(); ++k)
    trial.rigid_reactions[k] += direction[system->numbering().n_nodal + trial.multipliers.size() + k];
  if (!elimination.empty() && !elimination.solve(set, trial.multipliers, trial.fields))
    return std::numeric_limits<double>::infinity();
  try
  {
    trial_values = evaluate(trial);
  }
  catch (const SolveError &)
  {
    return std::numeric_limits<double>::infinity(); // too deep in each other
  }
  return merit_of(trial_values, trial.multipliers, direction);
}

void SurfaceProblem::accept_trial()
{
  double largest = 0.; // of a node, not of a component: when the chart is renewed must not depend on the orientation
  for (std::size_t I = 0; I < surface.n_nodes; ++I)
    largest = std::max(largest, norm(vector_at(trial.fields[0], I) - vector_at(current.fields[0], I)));
  moved_in_chart += largest;
  current        = trial;
  current_values = trial_values;
  if (renews_chart && moved_in_chart > chart_reach)
  {
    system->set_charts(charts_here());
    renew_gauge();
  }
}

} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/edge_loops.h>
#include <pellicle/discretization/hanging_nodes.h>
#include <pellicle/discretization/split_line.h>
#include <pellicle/discretization/surface_quality.h>
#include <pellicle/models/contact_augmentation.h>
#include <pellicle/models/random_vectors.h>
#include <pellicle/models/state_transfer.h>
#include <pellicle/models/surface_model.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pellicle
{
namespace
{
// Divides by the scene's length and moves the centroid of the nodes to the origin (a meridian only along z), so that
// round-off knows neither units nor place.
std::array<double, 3> normalise(SurfaceDiscretization &discretization, const double length, const bool stays,
                                const MirrorPlanes &planes)
{
  std::array<double, 3> centre{};
  const bool meridian = discretization.kind == SurfaceDiscretization::Kind::meridian;
  for (unsigned int c = meridian ? 2 : 0; c < 3; ++c)
  {
    // An open surface has no volume of its own: that over its rim's plane, where it starts, must stay what it is.
    if (stays || planes.normal_to[c] || discretization.mirror || !discretization.is_closed())
      continue;
    for (std::size_t I = 0; I < discretization.n_nodes; ++I)
      centre[c] += discretization.positions[3 * I + c] / static_cast<double>(discretization.n_nodes);
  }
  for (std::size_t I = 0; I < discretization.n_nodes; ++I)
    for (unsigned int c = 0; c < 3; ++c)
      discretization.positions[3 * I + c] = (discretization.positions[3 * I + c] - centre[c]) / length;
  for (double &x : discretization.mesh_reference)
    x /= length;
  return centre;
}

/** Passes iterations on with the energy in the user's units. */
class InUsersUnits : public Observer
{
public:
  InUsersUnits(Observer &observer, const Scales &unit)
      : observer(observer)
      , unit(unit)
  {
  }
  void on_iteration(const IterationReport &report) override
  {
    IterationReport scaled_report = report;
    scaled_report.energy *= unit.of(dimensions::energy);
    observer.on_iteration(scaled_report);
  }

private:
  Observer &observer;
  const Scales &unit;
};
} // namespace

SurfaceModel::SurfaceModel(const SurfaceScene &scene, const Communicator &communicator, Timing &timing)
    : newton(scene.newton)
    , unit(scene.scales())
    , communicator(communicator)
    , timing(timing)
    , discretization(scene.start_mesh())
    , planes(scene.mesh.mirror_planes())
    , euler_number(
          euler_characteristic(planes.any() ? UnfoldedSurface(discretization, planes).surface() : discretization))
    , own_surroundings(scene.surroundings())
    , own_measures(scene.measures(unit))
    , stability_parameters(scene.stability)
    , analyses_stability(scene.has_analysis("stability"))
{
  centroid = normalise(discretization, unit.length, scene.has_origin(), planes);
  add_node_noise(scene.node_noise());
  join_hanging_nodes(discretization); // which a scene may have placed as it places the others
  set_blas_threads(newton.threads);
  take_from_mesh(scene);
  PotentialSet potentials = potentials_of(scene);
  if (const std::string line = scene.split_line(); !line.empty())
    split = split_along(discretization, line);
  own_conditions = scene.conditions(solved_mesh(), targets);
  active_sets    = scene.active_sets(solved_mesh(), targets);
  for (const auto &active : active_sets)
  {
    active->take(targets);
    active->add_potentials(potentials);
  }
  // Held rims fix the surface in space; there are no rigid motions left.
  if (const auto position = own_conditions.find("position");
      position != own_conditions.end() && !position->second.only.empty())
    discretization.rigid_motions.clear();
  problem = std::make_unique<SurfaceProblem>(solved_mesh(), std::move(potentials), own_conditions, communicator,
                                             newton.linear_solver, timing);
  solver  = make_linear_solver(newton.linear_solver);
  add_pairs(scene, communicator);
  check_constraints_are_independent();
}

void SurfaceModel::add_node_noise(const NodeNoise &noise)
{
  if (noise.fraction == 0.)
    return;
  double area = 0.;
  for (const double a : nodal_areas(discretization, discretization.positions))
    area += a;
  const bool meridian              = discretization.kind == SurfaceDiscretization::Kind::meridian;
  const double spacing             = meridian ? std::sqrt(area) / static_cast<double>(discretization.n_nodes)
                                              : std::sqrt(area / static_cast<double>(discretization.n_nodes));
  const NodalVectors displacements = random_vectors(discretization, noise.fraction * spacing, noise.seed);
  for (std::size_t i = 0; i < displacements.size(); ++i)
    discretization.positions[i] += displacements[i];
}

void SurfaceModel::add_pairs(const SurfaceScene &scene, const Communicator &communicator)
{
  auto terms = scene.pair_terms(solved_mesh(), targets);
  if (terms.empty())
    return;
  const auto pairs = std::make_shared<PairTerms>(std::move(terms), communicator);
  try
  {
    problem->set_pairs(pairs);
  }
  catch (const SolveError &error)
  {
    throw UserError(std::string("The start shape cannot be used. ") + error.what() + " Move the parts apart.");
  }
  active_sets.push_back(std::make_unique<ContactAugmentation>(pairs, scene.multiplier_tolerance()));
}

// On a sphere dA = (2/R) dV: the two rows of the border would be multiples of each other. What counts is motion along
// the normal, and of edge loops all of it.
void SurfaceModel::check_constraints_are_independent()
{
  constexpr double smallest_sine_squared = 1e-6;
  const auto &constraints                = problem->potentials().constraints;
  std::vector<std::size_t> hard;
  for (std::size_t k = 0; k < constraints.size(); ++k)
    if (!std::isfinite(constraints[k].stiffness) && !constraints[k].self_term)
      hard.push_back(k);
  if (hard.size() < 2)
    return;
  const std::vector<NodalVectors> gradients = problem->nodal_forces().constraints;
  const NodalVectors normals                = nodal_normals(solved_mesh(), solved_mesh().positions);
  const std::vector<bool> on_edge           = nodes_of_edges(solved_mesh());
  const auto product                        = [&](const NodalVectors &a, const NodalVectors &b)
  {
    double sum = 0.;
    for (std::size_t I = 0; I < solved_mesh().n_nodes; ++I)
    {
      double full = 0., a_n = 0., b_n = 0.;
      for (unsigned int c = 0; c < 3; ++c)
      {
        full += a[3 * I + c] * b[3 * I + c];
        a_n += a[3 * I + c] * normals[3 * I + c];
        b_n += b[3 * I + c] * normals[3 * I + c];
      }
      sum += on_edge[I] ? full : a_n * b_n;
    }
    return sum;
  };
  for (std::size_t i = 0; i < hard.size(); ++i)
    for (std::size_t j = i + 1; j < hard.size(); ++j)
    {
      const NodalVectors &a = gradients[hard[i]], &b = gradients[hard[j]];
      const double ab = product(a, b);
      if (1. - ab * ab / (product(a, a) * product(b, b)) < smallest_sine_squared)
        throw UserError("The start shape is a sphere: " + constraints[hard[i]].measure->name() + " and " +
                        constraints[hard[j]].measure->name() +
                        " have parallel gradients there, so their multipliers are not determined. Start slightly off "
                        "the sphere, for example with "
                        "Vesicle/Start shape = prolate or ellipsoid with Semi axes = 1, 1, 1.02, or drop one of the "
                        "two constraints.");
    }
}

void SurfaceModel::update(const SurfaceScene &scene)
{
  newton                  = scene.newton;
  PotentialSet potentials = potentials_of(scene);
  own_conditions          = scene.conditions(solved_mesh(), targets);
  if (active_sets.empty())
    problem->set_conditions(own_conditions);
  for (const auto &active : active_sets)
  {
    active->take(targets);
    active->add_potentials(potentials);
  }
  problem->set_potentials(std::move(potentials));
}

bool SurfaceModel::start_from(const SurfaceModel &solved)
{
  PELLICLE_ASSERT(unit.length == solved.unit.length && unit.energy == solved.unit.energy,
                  "models of one scene have the same units");
  const Vector3<double> shift       = (1. / unit.length) * (origin() - solved.origin());
  std::optional<SurfaceState> state = transferred_state(*solved.problem, *problem, shift);
  if (!state)
    return false;
  for (const auto &active : active_sets)
    if (!active->take_over(state->fields))
      return false;
  problem->set_state(std::move(*state));
  if (!active_sets.empty())
    apply_active_sets();
  return true;
}

PotentialSet SurfaceModel::potentials_of(const SurfaceScene &scene)
{
  targets           = scene.targets(unit);
  targets.reference = reference;
  scene.add_references(solved_mesh(), targets);
  targets.euler_characteristic = euler_number;
  for (SceneEdge &edge : targets.edges)
  {
    if (const auto known = conormals.find(edge.name); known != conormals.end())
      edge.conormals = known->second;
    for (const EdgeLoop &loop : discretization.edges)
      if (loop.name == edge.name)
        edge.length = loop_length(loop, discretization.positions);
  }
  return scene.potentials(unit, targets);
}

// What potentials need to know of the start shape and the reference shape, at quadrature points.
void SurfaceModel::take_from_mesh(const SurfaceScene &scene)
{
  const bool has_skin = !is_reparametrisation_invariant(scene.potentials(unit));
  if (has_skin)
  {
    NodalVectors positions = discretization.positions;
    if (const std::optional<NodalVectors> given = scene.reference_positions())
    {
      positions = *given;
      for (double &x : positions)
        x /= unit.length;
    }
    reference = std::make_shared<const std::vector<ReferenceMetric>>(reference_metric(discretization, positions));
  }
  for (auto &[name, of_rim] : scene.rim_conormals(discretization))
    conormals[name] = std::make_shared<const std::vector<Vector3<double>>>(std::move(of_rim));
}

NodalVectors SurfaceModel::mesh_reference() const
{
  return newton.mesh_reference == "start shape" && !solved_mesh().mesh_reference.empty() ? solved_mesh().mesh_reference
                                                                                         : problem->state().fields[0];
}

bool SurfaceModel::take_one_step()
{
  const NodalVectors preferred = mesh_reference();
  Observer nobody;
  return EquilibriumSearch(newton, *problem, *solver, timing, preferred, 0, nobody).take_one_step();
}

StepResult SurfaceModel::solve(const int step, Observer &observer)
{
  const SurfaceState before    = problem->state();
  const NodalVectors preferred = mesh_reference();
  InUsersUnits energies(observer, unit);
  EquilibriumSearch search(newton, *problem, *solver, timing, preferred, step, energies);
  last_stability.reset();
  if (active_sets.empty())
    search.run();
  else
    solve_with_active_sets(search);
  count_unknowns();
  last_linear_solver.reset();
  if (search.result().converged && newton.condition_estimate)
    look_at_matrix(search);
  if (search.result().converged && analyses_stability)
    look_at_stability(search);
  if (!search.result().converged)
  {
    last_iterate = problem->state();
    problem->set_state(before);
  }
  return search.result();
}

void SurfaceModel::start_motion(const TimeParameters &time)
{
  current_motion = make_motion(time, {newton, *problem, *solver, communicator, timing});
  count_unknowns();
}

StepResult SurfaceModel::move(const double time, const int step, Observer &observer)
{
  InUsersUnits energies(observer, unit);
  return current_motion->advance(time, step, energies);
}

void SurfaceModel::apply_active_sets()
{
  NodalConditions conditions = own_conditions;
  SurfaceState state         = problem->state();
  bool rigid_gauge           = true;
  for (const auto &active : active_sets)
  {
    active->add_conditions(conditions);
    active->place(state.fields);
    rigid_gauge = rigid_gauge && active->leaves_rigid_motions();
  }
  problem->set_rigid_gauge(rigid_gauge);
  problem->set_state(std::move(state)); // energies of potentials that know the statuses are others now
  problem->set_conditions(std::move(conditions));
}

void SurfaceModel::solve_with_active_sets(EquilibriumSearch &search)
{
  try
  {
    if (settle_active_sets(search))
      return;
  }
  catch (const SolveError &error)
  {
    search.fail(error.what());
  }
  std::string reason = search.result().failure;
  for (const auto &active : active_sets)
    if (const std::string more = active->about_failure(); !more.empty())
      reason = more + " (" + reason + ")";
  search.fail(reason);
}

bool SurfaceModel::settle_active_sets(EquilibriumSearch &search)
{
  constexpr int most_rounds = 60;
  for (const auto &active : active_sets)
    active->begin_step(*problem);
  for (int round = 0; round < most_rounds; ++round)
  {
    apply_active_sets();
    if (!search.run())
      return false;
    std::size_t changes = 0;
    for (const auto &active : active_sets)
      changes += active->update(*problem);
    if (changes == 0)
      return true;
  }
  std::string names;
  for (const auto &active : active_sets)
    names += (names.empty() ? "" : ", ") + active->name();
  search.fail("the active set (" + names + ") did not settle in " + std::to_string(most_rounds) + " rounds");
  return false;
}

// And, if that is wanted, along the mode of the lowest eigenvalue, then downhill, until there is none below zero. The
// modes of one state show how it is left, not where that leads: the next state may have unstable modes of its own.
void SurfaceModel::look_at_stability(EquilibriumSearch &search)
{
  constexpr int most_descents = 8;
  constexpr double amplitude  = 0.05; // largest displacement, internal length
  const bool follow           = stability_parameters.follow_unstable_mode;
  for (int descents = 0;; ++descents)
  {
    const SurfaceState equilibrium = problem->state();
    last_stability                 = analyse_stability(
                        *problem, *solver, static_cast<unsigned int>(std::max(stability_parameters.eigenvalues, follow ? 1 : 0)));
    problem->set_state(equilibrium);
    if (planes.any() && descents == 0)
      search.warn("Mesh/Symmetry: the stability is that against deformations with the symmetry of the mesh.");
    if (last_stability && !last_stability->failure.empty())
      search.warn("The lowest eigenvalues were not found: " + last_stability->failure);
    if (!last_stability || last_stability->negative_eigenvalues == 0)
      return;
    if (!follow || last_stability->modes.empty() || descents == most_descents)
    {
      search.warn("The equilibrium is unstable: " + std::to_string(last_stability->negative_eigenvalues) +
                  " negative eigenvalues of the second variation." +
                  (follow ? "" : " Stability/Follow unstable mode = true goes downhill from it."));
      return;
    }
    const NodalVectors &mode = last_stability->modes.front();
    double largest           = 0.;
    for (const double component : mode)
      largest = std::max(largest, std::abs(component));
    SurfaceState displaced = equilibrium;
    problem->displace(displaced, last_stability->field, amplitude / largest, mode);
    problem->set_state(displaced);
    if (!search.descend())
      return;
  }
}

void SurfaceModel::show_last_iterate()
{
  if (last_iterate.fields.empty())
    return;
  const SurfaceState kept = problem->state();
  try
  {
    problem->set_state(last_iterate);
  }
  catch (const SolveError &)
  {
    problem->set_state(kept); // a shape without a moment cannot be shown
  }
}

void SurfaceModel::look_at_matrix(EquilibriumSearch &search)
{
  try
  {
    problem->linearize();
    solver->factorize(problem->matrix());
    if (const std::optional<Conditioning> conditioning = solver->conditioning(problem->matrix()))
      last_linear_solver = LinearSolverReport{solver->name(), *conditioning, {}};
    if (const std::optional<Inertia> inertia = solver->inertia(); inertia && last_linear_solver)
      last_linear_solver->negative_pivots = inertia->negative;
  }
  catch (const SolveError &error)
  {
    search.warn(std::string("No condition number of the matrix at the equilibrium: ") + error.what());
  }
}

void SurfaceModel::count_unknowns()
{
  const Numbering &numbering = problem->numbering();
  last_unknown_counts.clear();
  for (std::size_t f = 0; f < problem->layout().fields().size(); ++f)
    last_unknown_counts.emplace_back(problem->layout().fields()[f].name, numbering.n_unknowns_of(f));
  if (numbering.n_constraints > 0)
    last_unknown_counts.emplace_back("multipliers", numbering.n_constraints);
  if (numbering.n_rigid > 0)
    last_unknown_counts.emplace_back("rigid motions", numbering.n_rigid);
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
// SurfaceModel::follow_branch(): the model's parameter, and what happens at bifurcations.
#include <pellicle/base/exceptions.h>
#include <pellicle/models/surface_branch.h>
#include <pellicle/models/surface_model.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace pellicle
{
namespace
{
double scale_of(const BranchParameters &branch, const double value)
{
  if (branch.scale > 0.)
    return branch.scale;
  const double distance = branch.steps.upper - branch.steps.lower;
  if (std::isfinite(distance) && distance > 0.)
    return distance;
  return value != 0. ? std::abs(value) : 1.;
}

std::vector<ParameterDerivative> of_parameter(std::vector<ParameterDerivative> all, const std::string &parameter)
{
  std::set<std::string> names;
  for (const ParameterDerivative &derivative : all)
    names.insert(derivative.parameter);
  std::string possible;
  for (const std::string &name : names)
    possible += (possible.empty() ? "" : ", ") + name;
  all.erase(std::remove_if(all.begin(), all.end(), [&](const auto &d) { return d.parameter != parameter; }), all.end());
  if (all.empty())
    throw UserError("Continuation/Parameter = " + parameter +
                    " is not possible in this scene. Possible are: " + possible + ".");
  return all;
}

/** Analysed on the symmetric matrix of another chart; then back at the same state in the branch's own one. */
std::optional<Stability> stability_in_passing(SurfaceProblem &problem, LinearSolver &solver, SurfaceBranch &along,
                                              const unsigned int n_eigenvalues)
{
  const SurfaceState state           = problem.state();
  std::optional<Stability> stability = analyse_stability(problem, solver, n_eigenvalues);
  problem.set_state(state);
  along.use_own_chart();
  problem.set_state(state);
  return stability;
}

/** The mode whose eigenvalue is nearest to zero. */
NodalVectors critical_mode(const Stability &stability)
{
  const auto nearest = std::min_element(stability.lowest.begin(), stability.lowest.end(),
                                        [](const double a, const double b) { return std::abs(a) < std::abs(b); });
  return stability.modes[static_cast<std::size_t>(nearest - stability.lowest.begin())];
}
} // namespace

ContinuationResult SurfaceModel::follow_branch(const BranchParameters &branch, const double value,
                                               const SceneAt &scene_at, Observer &observer,
                                               const std::function<void(const PointOnBranch &)> &on_point,
                                               const BranchMemory &memory)
{
  BranchProgress now;
  if (memory.from != nullptr)
    now = *memory.from;
  else
  {
    now.scale = scale_of(branch, value);
    now.mesh_reference =
        solved_mesh().mesh_reference.empty() ? problem->state().fields[0] : solved_mesh().mesh_reference;
  }

  SceneParameter parameter;
  parameter.name        = branch.parameter;
  parameter.value       = value;
  parameter.scale       = now.scale;
  parameter.potentials  = [&](const double p) { return potentials_of(*scene_at(p)); };
  parameter.derivatives = [&](const double p)
  { return of_parameter(scene_at(p)->derivatives(unit, targets), branch.parameter); };
  parameter.derivatives(value);

  const PositionChart chart = problem->needs_material_chart() ? PositionChart::material
                              : newton.chart == "graph"       ? PositionChart::graph
                                                              : PositionChart::ale;
  Archive state;
  if (memory.from != nullptr)
    problem->exchange(state);
  SurfaceBranch along(*problem, std::move(parameter), chart, now.mesh_reference);
  if (memory.from != nullptr)
  {
    along.set_parameter(now.position.parameter);
    Archive same(state.content());
    problem->exchange(same);
    along.use_own_chart();
  }
  Continuation continuation(branch.steps, newton, *solver, timing);

  bool at_bifurcation = false;
  const auto visit    = [&](const BranchPoint &point)
  {
    const SurfaceState at_point = problem->state();
    const bool lists_modes      = analyses_stability && stability_parameters.eigenvalues > 0;
    last_stability              = stability_in_passing(
                     *problem, *solver, along, lists_modes ? static_cast<unsigned int>(stability_parameters.eigenvalues) : 0);

    PointOnBranch here{point, std::nullopt};
    at_bifurcation = false;
    if (last_stability && !point.is_fold)
    {
      here.negative_eigenvalues = last_stability->negative_eigenvalues;
      at_bifurcation            = now.count && *now.count != *here.negative_eigenvalues;
      now.count                 = here.negative_eigenvalues;
      if (!at_bifurcation)
        now.before = {at_point, point.parameter, *now.count};
    }
    else if (point.is_fold)
      now.count.reset(); // here it changes without a bifurcation
    on_point(here);
    if (at_bifurcation)
      observer.on_message("A bifurcation: the number of negative eigenvalues has changed to " +
                          std::to_string(*here.negative_eigenvalues) + " at " + branch.parameter + " = " +
                          std::to_string(point.parameter));
    return !(at_bifurcation && branch.at_bifurcation == "switch");
  };
  const auto after_point = [&](const BranchPosition &position)
  {
    now.position = position;
    if (memory.after_point)
      memory.after_point(now);
  };

  // Onto the crossing branch, along the mode that is critical there: first to the bifurcation, for beside it that
  // branch may be out of reach or absent. Further bifurcations are only reported.
  const auto visit_only = [&](const BranchPoint &point)
  {
    visit(point);
    if (point.arc_length == 0.)
      now.count.reset(); // at the bifurcation itself the number is left to round-off
    return true;
  };
  ContinuationResult other;
  if (now.has_switched)
    other = continuation.go_on(along, now.position, observer, visit_only, after_point);
  else
  {
    const StartDirection start =
        branch.direction == "increasing" ? StartDirection::increasing() : StartDirection::decreasing();
    ContinuationResult &result = now.before_switch;
    result = memory.from != nullptr ? continuation.go_on(along, now.position, observer, visit, after_point)
                                    : continuation.run(along, start, observer, visit, after_point);
    if (result.end != ContinuationEnd::stopped)
      return result;
    StartDirection sideways;
    try
    {
      const Stability there = go_to_bifurcation(along, now.before, {problem->state(), along.parameter(), *now.count});
      sideways              = StartDirection::along(problem->direction_of(critical_mode(there)), branch.amplitude);
    }
    catch (const SolveError &error)
    {
      result.end     = ContinuationEnd::failed;
      result.failure = std::string("the bifurcation could not be located: ") + error.what();
      return result;
    }
    now.count.reset();
    now.has_switched = true;
    other            = continuation.run(along, sideways, observer, visit_only, after_point);
  }
  other.points += now.before_switch.points;
  other.folds += now.before_switch.folds;
  other.iterations += now.before_switch.iterations;
  other.rejected_steps += now.before_switch.rejected_steps;
  return other;
}

// False position on the critical eigenvalue, which is nearly linear in the parameter; Illinois' halving where one end
// stays.
Stability SurfaceModel::go_to_bifurcation(SurfaceBranch &along, const PlaceOnBranch &before, const PlaceOnBranch &after)
{
  constexpr double nearness = 1e-4; // of the eigenvalue, relative to the larger one of the ends
  constexpr int most_steps  = 20;
  const int fewer           = std::min(before.negative_eigenvalues, after.negative_eigenvalues);
  const auto analyse        = [&]
  {
    const std::optional<Stability> stability =
        stability_in_passing(*problem, *solver, along, static_cast<unsigned int>(fewer) + 2);
    if (!stability || stability->modes.empty())
      throw SolveError("its critical mode was not found" + (stability ? ": " + stability->failure : ""));
    return *stability;
  };
  const auto go = [&](const double parameter, const SurfaceState &state)
  {
    along.set_parameter(parameter);
    problem->set_state(state);
  };

  struct End
  {
    PlaceOnBranch place;
    double mu;
  };
  const auto critical = static_cast<std::size_t>(fewer);
  End b{after, analyse().lowest[critical]};
  go(before.parameter, before.state);
  End a{before, analyse().lowest[critical]};
  const double small = nearness * std::max(std::abs(a.mu), std::abs(b.mu));

  NewtonParameters corrector = newton;
  corrector.initial_drag     = 0.;
  Observer nobody;
  const End *stayed = nullptr;
  for (int i = 0; i < most_steps; ++i)
  {
    const double parameter = (b.mu * a.place.parameter - a.mu * b.place.parameter) / (b.mu - a.mu);
    go(parameter, std::abs(a.mu) < std::abs(b.mu) ? a.place.state : b.place.state);
    const NewtonResult result = Newton(corrector, *solver, timing).solve(along, 0, nobody);
    if (!result.converged)
      throw SolveError(result.failure);
    const Stability there = analyse();
    const double mu       = there.lowest[critical];
    if (std::abs(mu) < small)
      return there;
    const bool like_a = (mu > 0.) == (a.mu > 0.);
    End &replaced = like_a ? a : b, &kept = like_a ? b : a;
    replaced = {{problem->state(), parameter, there.negative_eigenvalues}, mu};
    if (stayed == &kept)
      kept.mu *= 0.5;
    stayed = &kept;
  }
  throw SolveError("its critical eigenvalue does not come to zero");
}
} // namespace pellicle

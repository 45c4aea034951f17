// SPDX-License-Identifier: LGPL-2.1-or-later
// solve_scene(): once, or along the scene's own load path and then in steps of a parameter.
#include <pellicle/apps/branch_run.h>
#include <pellicle/apps/surface_run.h>
#include <pellicle/base/exact_text.h>
#include <pellicle/base/expression.h>
#include <pellicle/models/jump_detector.h>
#include <pellicle/models/self_contact.h>

#include <cmath>
#include <utility>

namespace pellicle
{
namespace
{
/** Messages of others as the middle of a sentence. */
std::string without_full_stop(std::string text)
{
  while (!text.empty() && text.back() == '.')
    text.pop_back();
  return text;
}

/**
 * The integral of K over 2 pi is the Euler characteristic. Summed cell by cell, a resolved shape is off by a few
 * hundredths (a very coarse one by a few tenths), a mesh that has folded by more.
 */
void warn_of_folds(const SurfaceModel &model, RunResult &result)
{
  constexpr double largest_defect = 0.5;
  if (!model.mesh().is_closed())
    return;
  const int exact = model.scene_targets().euler_characteristic;
  for (const auto &[name, value] : result.quantities)
    if (name == "gauss_bonnet" && std::abs(value - exact) > largest_defect)
      result.warnings.push_back("gauss_bonnet is " + exact_text(value) + " and should be " + std::to_string(exact) +
                                ": the mesh does not resolve this shape or has folded, and the state may be spurious. "
                                "Use Newton/Chart = automatic, a finer mesh, or load steps.");
}

/** A surface of a drop that leaves its line downwards goes through the dry substrate, which it does not see. */
void warn_of_penetration(RunResult &result)
{
  for (const auto &[name, value] : result.quantities)
    if (name.rfind("apparent_contact_angle_degrees", 0) == 0 && value > 180.)
    {
      result.warnings.push_back(name + " is " + exact_text(value) +
                                ": the drop leans over its contact line and through the dry substrate. Contact with it "
                                "is not part of the model; a smaller weight or inclination avoids it.");
      return;
    }
}

/** A number of the scene goes from one value to another: a stage of the scene's own load path, or section Load. */
struct Leg
{
  std::string stage; ///< its name; empty: section Load
  std::string parameter;
  double from = 0., to = 0.;

  bool is_stage() const { return !stage.empty(); }
  double at(const double t) const { return from + t * (to - from); }
};

/** Stages that load anything, then what section Load asks for. */
std::vector<Leg> legs_of(const SurfaceSceneFile &file, const SurfaceScene &scene)
{
  std::vector<Leg> legs;
  for (const LoadStage &stage : scene.load_stages())
    if (const double whole = file.number(stage.parameter); whole != 0.)
      legs.push_back({stage.name, stage.parameter, 0., whole});
  const std::string &parameter = scene.load.parameter;
  if (!parameter.empty())
    legs.push_back({"", parameter, file.number(parameter), evaluate_number(scene.load.to)});
  return legs;
}

/** The walk along all legs. */
class Walk
{
public:
  Walk(std::vector<Leg> legs, SurfaceSceneFile &file, const SurfaceScene &first, SurfaceModel &model,
       Observer &observer, const SolutionSink &sink, RunMemory &memory)
      : file(file)
      , first(first)
      , model(model)
      , observer(observer)
      , sink(sink)
      , memory(memory)
      , legs(std::move(legs))
  {
  }

  RunResult run()
  {
    for (const Leg &leg : legs)
      if (leg.is_stage())
        file.set(leg.parameter, leg.from, "Load path");
    memory.take_up([&](Archive &archive) { exchange(archive); });
    const bool arrived = followed || (legs.empty() ? solve_once() : walk_all_legs());
    result.status      = arrived ? RunStatus::converged : RunStatus::failed;
    if (arrived && !first.branch.parameter.empty())
      follow_branch();
    if (result.status == RunStatus::failed && result.quantities.empty())
    {
      // Not even the first equilibrium was found: what there is to see is where the iteration ended.
      model.show_last_iterate();
      result.quantities = model.quantities();
      sink(model, 0, legs.empty() ? 0. : legs[0].from);
    }
    describe(first, model, result);
    if (!arrived)
      explain_or_continue();
    if (result.status == RunStatus::converged)
    {
      warn_of_folds(model, result);
      warn_of_penetration(result);
    }
    return result;
  }

private:
  /** All that the walk needs to go on after a step. */
  void exchange(Archive &archive)
  {
    double end = legs.empty() ? 0. : legs.back().to;
    archive.name("load path");
    archive | here | position | accepted | end | jumps | self_contact | result | followed;
    if (archive.is_reading())
    {
      n_kept = result.newton.steps;
      go_back_to_last_step(end);
    }
    model.exchange(archive);
  }

  /** Parameters as they were at the last step of a walk whose last leg went to `end`. */
  void go_back_to_last_step(const double end)
  {
    if (leg() == nullptr)
      return;
    if (!leg()->is_stage() && leg()->to != end)
    {
      const double ratio = (end - leg()->from) / (leg()->to - leg()->from);
      position           = {ratio * position.t, ratio * position.next_step};
      if (!(position.t >= 0. && position.t <= 1.))
        throw UserError("Load/To = " + exact_text(leg()->to) + ": the run that goes on is at " + leg()->parameter +
                        " = " + exact_text(accepted) + " already, on its way from " + exact_text(leg()->from) +
                        ". Give a value that lies ahead.");
    }
    for (std::size_t i = 0; i < here; ++i)
      file.set(legs[i].parameter, legs[i].at(1.), "Load path");
    go_to(accepted, "Load path");
  }

  /** After a step; where a stage begins there was none. */
  void keep()
  {
    if (result.newton.steps == n_kept)
      return;
    n_kept = result.newton.steps;
    memory.after_step([&](Archive &archive) { exchange(archive); });
  }

  void follow_branch()
  {
    run_branch(file, first.branch, model, observer, sink, result, followed,
               [&] { memory.after_step([&](Archive &archive) { exchange(archive); }); });
  }

  bool solve_once()
  {
    if (!has_equilibrium() && !is_found([&] { return solve(0., 0.); }))
      return false;
    keep();
    return true;
  }

  /** As it was read last. */
  const SurfaceScene &scene() const { return read_last ? *read_last : first; }

  /** Another value of the leg's parameter. */
  void go_to(const double value, const std::string &origin)
  {
    file.set(leg()->parameter, value, origin);
    read_last = file.read();
    model.update(scene());
  }

  const Leg *leg() const { return here < legs.size() ? &legs[here] : nullptr; }
  bool has_stages() const { return !legs.empty() && legs[0].is_stage(); }
  bool has_equilibrium() const { return result.newton.steps > 0; }

  template <typename F>
  bool is_found(const F &f)
  {
    try
    {
      return f();
    }
    catch (const SolveError &error)
    {
      failure = error.what();
      return false;
    }
  }

  bool walk_all_legs()
  {
    const auto after_step = [&](const LoadPosition &reached)
    {
      position = reached;
      keep();
    };
    for (; here < legs.size(); ++here, position = {})
    {
      if (position.t < 0.)
      {
        jumps           = JumpDetector(legs[here].parameter);
        suspected_jumps = 0;
        accepted        = legs[here].from;
      }
      if (!is_found(
              [&]
              {
                return walk_load(
                           first.load, [&](const double t) { return attempt(t); }, position, after_step) == 1.;
              }) &&
          !is_found_at_once(after_step))
        return false;
    }
    --here;
    return true;
  }

  /** The whole of a first stage of which not even the smallest part has led to an equilibrium. Weak loads may be the
   * harder ones: under weak tensions a contact line that is free slides as far as under strong ones, over a solid that
   * they do not deform. */
  bool is_found_at_once(const std::function<void(const LoadPosition &)> &after_step)
  {
    if (here > 0 || !leg()->is_stage() || has_equilibrium())
      return false;
    const std::string before = failure;
    if (is_found([&] { return attempt(1.); }))
    {
      after_step({1., 0.});
      return true;
    }
    failure = before;
    return false;
  }

  /** At t of the leg. Where it begins there is an equilibrium already, or, at the first stage, need not be one. */
  bool attempt(const double t)
  {
    if (t == 0. && (leg()->is_stage() || has_equilibrium()))
    {
      if (has_equilibrium())
        jumps.accept(model, scene(), leg()->from);
      return true;
    }
    const double value = leg()->at(t);
    if (t > 0.)
      go_to(value, "Load step " + std::to_string(result.newton.steps));
    return solve(t, value);
  }

  bool solve(const double t, const double value)
  {
    const int step            = result.newton.steps;
    const SurfaceState before = model.equilibrium().state();
    const StepResult outcome  = model.solve(step, observer);
    result.newton.iterations += outcome.iterations;
    result.newton.rejected += outcome.rejected;
    result.newton.final_relative_residual = outcome.relative_residual;
    if (!outcome.converged)
    {
      failure = outcome.failure;
      return false;
    }
    if (leg() != nullptr && left_the_branch(value, before, outcome.iterations))
    {
      failure = "the state found is on another branch";
      return false;
    }
    result.warnings.insert(result.warnings.end(), outcome.warnings.begin(), outcome.warnings.end());
    for (const std::string &warning : outcome.warnings)
      observer.on_message(warning);
    report(t, value, outcome.iterations);
    sink(model, step, legs.empty() ? step : has_stages() ? static_cast<double>(here) + t : value);
    ++result.newton.steps;
    return true;
  }

  bool left_the_branch(const double value, const SurfaceState &before, const int iterations)
  {
    // A jump is believed, and reported, after a few attempts with shorter steps or when no shorter one is allowed; a
    // load path of the scene's own must not jump at all.
    constexpr int attempts_before_a_jump_counts = 4, iterations_of_a_hard_step = 12;
    const double tolerance = iterations > iterations_of_a_hard_step ? JumpDetector::close : JumpDetector::usual;
    if (!jumps.has_jumped(model, scene(), value, tolerance))
      suspected_jumps = 0;
    else if (leg()->is_stage() ||
             (++suspected_jumps < attempts_before_a_jump_counts &&
              0.5 * std::abs(value - accepted) > first.load.smallest_step * std::abs(leg()->to - leg()->from)))
    {
      model.go_to(before);
      return true;
    }
    else
    {
      suspected_jumps = 0;
      result.warnings.push_back(
          "Just before " + leg()->parameter + " = " + exact_text(value) +
          " the branch of equilibria ends (a fold): the state has jumped to another branch. Section "
          "Continuation passes folds without a jump.");
      observer.on_message(result.warnings.back());
    }
    jumps.accept(model, scene(), value);
    accepted = value;
    return false;
  }

  void report(const double t, const double value, const int iterations)
  {
    StepReport done;
    done.step = result.newton.steps;
    if (!legs.empty())
      done.fraction_done = (static_cast<double>(here) + t) / static_cast<double>(legs.size());
    if (has_stages())
      done.stepped.emplace_back("load", leg()->is_stage() ? static_cast<double>(here) + t : static_cast<double>(here));
    if (!legs.empty() && !legs.back().is_stage())
      done.stepped.emplace_back(legs.back().parameter, leg()->is_stage() ? legs.back().from : value);
    done.iterations   = iterations;
    result.quantities = model.quantities();
    done.quantities   = result.quantities;
    if (model.stability())
      done.quantities.emplace_back("negative_eigenvalues", model.stability()->negative_eigenvalues);
    observer.on_step(done);
    const std::string place = legs.empty() ? "" : leg()->parameter + " = " + exact_text(value);
    if (const std::optional<std::string> warning = self_contact.look(result.quantities, place))
    {
      result.warnings.push_back(*warning);
      observer.on_message(*warning);
    }
  }

  /** The walk has ended on a leg: says so, or follows the branch through the fold if section Continuation names the
   * parameter that got stuck. */
  void explain_or_continue()
  {
    if (leg() == nullptr || (!has_equilibrium() && !leg()->is_stage()))
    {
      result.message =
          "Newton's method found no equilibrium: " + without_full_stop(failure) +
          ". Try a start shape nearer to the solution, load steps towards it (section Load), or a finer mesh.";
      return;
    }
    const bool can_continue = has_equilibrium() && model.energy_slope(scene(), leg()->parameter);
    if (leg()->is_stage() && can_continue)
    {
      go_to(accepted, "Load path"); // the state is there already
      if (first.branch.parameter == leg()->parameter)
      {
        result.warnings.push_back(where_it_stopped() + ". The branch is followed from there by arc length; loads that "
                                                       "come later are not applied.");
        observer.on_message(result.warnings.back());
        result.status = RunStatus::converged;
        follow_branch();
        return;
      }
    }
    const std::optional<double> fold = leg()->is_stage() && can_continue ? fold_ahead() : std::optional<double>();
    result.message                   = where_it_stopped() + " (" + without_full_stop(failure) + "). ";
    result.message +=
        fold ? "The load path folds at " + leg()->parameter + " = " + exact_text(*fold) +
                   ": beyond it there is no equilibrium nearby."
             : "There may be no equilibrium nearby beyond it (a fold); a finer mesh or a smaller Load/Smallest step "
               "may help.";
    if (leg()->is_stage() && can_continue)
      result.message += " Continuation/Parameter = " + leg()->parameter + " with Direction = " + direction() +
                        " follows the branch through a fold.";
  }

  std::string where_it_stopped() const
  {
    if (!leg()->is_stage())
      return "Load stepping stopped at " + leg()->parameter + " = " + exact_text(accepted) + " on the way to " +
             exact_text(leg()->to);
    return "Load stepping stopped at " + leg()->stage + " = " + exact_text(accepted / leg()->to) + " (" +
           leg()->parameter + " = " + exact_text(accepted) + " on the way to " + exact_text(leg()->to) + ")";
  }

  const char *direction() const { return leg()->to > leg()->from ? "increasing" : "decreasing"; }

  /** Whether the branch turns back soon after the last equilibrium, and where. */
  std::optional<double> fold_ahead()
  {
    BranchParameters probe;
    probe.parameter        = leg()->parameter;
    probe.direction        = direction();
    probe.scale            = std::abs(leg()->to - leg()->from);
    probe.steps.max_points = 8;
    const auto scene_at    = [&](const double value)
    {
      file.set(leg()->parameter, value, "Load path");
      return file.read();
    };
    std::optional<double> fold;
    Observer nobody;
    is_found(
        [&]
        {
          model.follow_branch(probe, accepted, scene_at, nobody,
                              [&](const SurfaceModel::PointOnBranch &point)
                              {
                                if (point.point.is_fold && !fold)
                                  fold = point.point.parameter;
                              });
          return true;
        });
    return fold;
  }

  SurfaceSceneFile &file;
  const SurfaceScene &first;
  SurfaceModel &model;
  Observer &observer;
  const SolutionSink &sink;
  RunMemory &memory;
  RunResult result;
  std::unique_ptr<SurfaceScene> read_last;
  std::vector<Leg> legs;
  std::size_t here = 0;  ///< number of the leg
  LoadPosition position; ///< on it
  JumpDetector jumps{""};
  SelfContactWatch self_contact;
  int suspected_jumps = 0;
  double accepted     = 0.; ///< value of the leg's parameter at the last equilibrium
  int n_kept          = 0;  ///< steps of which the last one was offered to the memory
  std::optional<BranchRecord> followed;
  std::string failure;
};
} // namespace

RunResult solve_scene(SurfaceSceneFile &file, const SurfaceScene &first, SurfaceModel &model, Observer &observer,
                      const SolutionSink &sink, RunMemory &memory)
{
  return Walk(legs_of(file, first), file, first, model, observer, sink, memory).run();
}

RunResult solve_here(SurfaceSceneFile &file, const SurfaceScene &scene, SurfaceModel &model, Observer &observer,
                     const SolutionSink &sink)
{
  RunMemory nothing_to_keep;
  return Walk({}, file, scene, model, observer, sink, nothing_to_keep).run();
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/apps/branch_run.h>
#include <pellicle/apps/surface_run.h>
#include <pellicle/base/exact_text.h>
#include <pellicle/base/expression.h>
#include <pellicle/base/scene_file.h>
#include <pellicle/discretization/surface_quality.h>
#include <pellicle/models/jump_detector.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace pellicle
{
namespace
{
SceneEntries entries_of(const CommandLine &command_line)
{
  SceneEntries entries = read_scene_file(command_line.scene_file);
  apply_overrides(entries, command_line.overrides);
  for (const SceneEntry &entry : entries.entries)
    if (entry.path() == "Mesh/File" && !entry.value.empty() && std::filesystem::path(entry.value).is_relative())
    {
      const std::filesystem::path folder = std::filesystem::absolute(command_line.scene_file).parent_path();
      set_entry(entries, "Mesh/File", (folder / entry.value).lexically_normal().string(), entry.origin);
      break;
    }
  return entries;
}

std::vector<std::string> sections_of_others(const EffectLibrary &library, const std::vector<std::string> &effects)
{
  std::vector<std::string> sections;
  for (const std::string &name : library.names())
    if (std::find(effects.begin(), effects.end(), name) == effects.end())
      sections.push_back(section_name(name));
  return sections;
}
/** Calls f and puts "Load/Name = value: " before the message of a UserError. */
template <typename F>
double number_of_load(const std::string &name, const std::string &value, const F &f)
{
  try
  {
    return f();
  }
  catch (const UserError &error)
  {
    throw UserError("Load/" + name + " = " + value + ": " + error.what());
  }
}

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
  const int exact = euler_characteristic(model.mesh());
  for (const auto &[name, value] : result.quantities)
    if (name == "gauss_bonnet" && std::abs(value - exact) > largest_defect)
      result.warnings.push_back("gauss_bonnet is " + exact_text(value) + " and should be " + std::to_string(exact) +
                                ": the mesh does not resolve this shape or has folded, and the state may be spurious. "
                                "Use Newton/Chart = automatic, a finer mesh, or load steps.");
}
} // namespace

SurfaceSceneFile::SurfaceSceneFile(const SurfaceApplication &application, const CommandLine &command_line)
    : application(application)
    , scene(application.name, entries_of(command_line))
    , effects(scene.effects(application.default_effects, application.library.names()))
    , analyses(scene.analyses({}, application.analysis_names()))
{
}

std::unique_ptr<SurfaceScene> SurfaceSceneFile::read()
{
  std::unique_ptr<SurfaceScene> parameters = application.scene(effects, analyses);
  scene.read(parameters->sections(), sections_of_others(application.library, effects));
  parameters->check();
  return parameters;
}

void SurfaceSceneFile::set(const std::string &path, const double value, const std::string &origin)
{
  scene.set(path, exact_text(value), origin);
}

void SurfaceSceneFile::set_text(const std::string &path, const std::string &value, const std::string &origin)
{
  scene.set(path, value, origin);
}

double SurfaceSceneFile::number(const std::string &path) const
{
  return evaluate_number(scene.value(path));
}

std::string SurfaceSceneFile::used_text()
{
  return scene.used_text(application.scene(effects, analyses)->sections(), effects, analyses);
}

std::unique_ptr<SurfaceScene> scene_at_start_of_load(SurfaceSceneFile &file, const LoadParameters &load)
{
  const double own = number_of_load("Parameter", load.parameter, [&] { return file.number(load.parameter); });
  const double from =
      load.from.empty() ? own : number_of_load("From", load.from, [&] { return evaluate_number(load.from); });
  const double to = load.to.empty() ? own : number_of_load("To", load.to, [&] { return evaluate_number(load.to); });
  file.set(load.parameter, to, "Load/To");
  file.read();
  file.set(load.parameter, from, "Load/From");
  std::unique_ptr<SurfaceScene> scene = file.read();
  scene->load.to                      = exact_text(to);
  return scene;
}

std::string commented_scene_of(const SurfaceApplication &application)
{
  const std::unique_ptr<SurfaceScene> listed = application.scene(application.default_effects, {});
  SceneDescription description;
  description.application    = application.name;
  description.effects        = application.default_effects;
  description.known_effects  = application.library.names();
  description.known_analyses = application.analysis_names();
  description.sections       = listed->sections();
  std::vector<std::unique_ptr<Effect>> others;
  for (const std::string &name : application.library.names())
    if (!listed->has_effect(name))
    {
      others.push_back(application.library.create(name));
      ParameterSection section(section_name(name));
      others.back()->bind(section);
      description.unlisted.push_back({name, section});
    }
  return commented_scene(description);
}

void describe(const SurfaceScene &scene, const SurfaceModel &model, RunResult &result)
{
  for (const auto &effect : scene.effects)
    result.effects.push_back(effect->name());
  result.analyses = scene.analyses;
  result.n_cells  = model.n_cells();
  result.degree   = model.mesh().degree;
  for (const auto &[name, n] : model.unknown_counts())
  {
    result.unknowns.blocks.emplace_back(name, n);
    result.unknowns.total += n;
  }
  if (const std::optional<Stability> &stability = model.stability())
  {
    result.stability                       = StabilityCounts{};
    result.stability->negative_eigenvalues = stability->negative_eigenvalues;
    for (const double eigenvalue : stability->lowest)
      result.stability->lowest.push_back(eigenvalue * model.scales().of({1, -4}));
  }
}

RunResult solve_scene(SurfaceSceneFile &file, const SurfaceScene &first, SurfaceModel &model, Observer &observer,
                      const SolutionSink &sink)
{
  RunResult result;
  const LoadParameters &load = first.load;
  const bool stepping        = !load.parameter.empty();
  const double from          = stepping ? file.number(load.parameter) : 0.;
  const double to            = stepping ? evaluate_number(load.to) : 0.;
  std::string failure;

  const auto report = [&](const int step, const double fraction_done, const double value, const int iterations)
  {
    StepReport done;
    done.step              = step;
    done.fraction_done     = fraction_done;
    done.stepped_parameter = load.parameter;
    done.stepped_value     = value;
    done.iterations        = iterations;
    result.quantities      = model.quantities();
    done.quantities        = result.quantities;
    if (model.stability())
      done.quantities.emplace_back("negative_eigenvalues", model.stability()->negative_eigenvalues);
    observer.on_step(done);
  };
  JumpDetector jumps(load.parameter);
  int suspected_jumps   = 0;
  double accepted_value = from;
  // A jump is believed, and reported, after a few attempts with shorter steps or when no shorter one is allowed.
  constexpr int attempts_before_a_jump_counts = 4;
  const auto left_the_branch = [&](const SurfaceScene &scene, const double value, const SurfaceState &before)
  {
    if (!jumps.has_jumped(model, scene, value))
      suspected_jumps = 0;
    else if (++suspected_jumps < attempts_before_a_jump_counts &&
             0.5 * std::abs(value - accepted_value) > load.smallest_step * std::abs(to - from))
    {
      model.go_to(before);
      return true;
    }
    else
    {
      suspected_jumps = 0;
      result.warnings.push_back(
          "Just before " + load.parameter + " = " + exact_text(value) +
          " the branch of equilibria ends (a fold): the state has jumped to another branch. Section "
          "Continuation passes folds without a jump.");
      observer.on_message(result.warnings.back());
    }
    jumps.accept(model, scene, value);
    accepted_value = value;
    return false;
  };
  const auto attempt = [&](const double t)
  {
    const int step            = result.newton.steps;
    const double value        = stepping ? from + t * (to - from) : step;
    const SurfaceState before = model.equilibrium().state();
    if (stepping && t > 0.)
    {
      file.set(load.parameter, value, "Load step " + std::to_string(step));
      model.update(*file.read());
    }
    const StepResult outcome = model.solve(step, observer);
    result.newton.iterations += outcome.iterations;
    result.newton.rejected += outcome.rejected;
    result.newton.final_relative_residual = outcome.relative_residual;
    if (!outcome.converged)
    {
      failure = outcome.failure;
      return false;
    }
    if (stepping && left_the_branch(*file.read(), value, before))
    {
      failure = "the state found is on another branch";
      return false;
    }
    result.warnings.insert(result.warnings.end(), outcome.warnings.begin(), outcome.warnings.end());
    for (const std::string &warning : outcome.warnings)
      observer.on_message(warning);
    report(step, stepping ? t : 1., value, outcome.iterations);
    sink(model, step, value);
    ++result.newton.steps;
    return true;
  };

  double reached = 1.;
  try
  {
    if (stepping)
      reached = walk_load(load, attempt);
    else
      reached = attempt(0.) ? 1. : -1.;
  }
  catch (const SolveError &error)
  {
    failure = error.what();
    reached = -1.;
  }

  result.status = reached == 1. ? RunStatus::converged : RunStatus::failed;
  if (reached < 0.)
    result.message =
        "Newton's method found no equilibrium: " + without_full_stop(failure) +
        ". Try a start shape nearer to the solution, load steps towards it (section Load), or a finer mesh.";
  else if (reached < 1.)
    result.message = "Load stepping stopped at " + load.parameter + " = " + exact_text(from + reached * (to - from)) +
                     " on the way to " + exact_text(to) + " (" + without_full_stop(failure) +
                     "). There may be no equilibrium nearby beyond it (a fold); a finer mesh or a smaller "
                     "Load/Smallest step may help.";
  if (result.status == RunStatus::converged && !first.branch.parameter.empty())
    run_branch(file, first.branch, model, observer, sink, result);
  if (result.status == RunStatus::converged)
    warn_of_folds(model, result);
  if (result.status == RunStatus::failed && result.quantities.empty())
  {
    // Not even the first equilibrium was found: what there is to see is where the iteration ended.
    model.show_last_iterate();
    result.quantities = model.quantities();
    sink(model, 0, stepping ? from : 0.);
  }
  describe(first, model, result);
  return result;
}
} // namespace pellicle

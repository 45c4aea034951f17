// SPDX-License-Identifier: LGPL-2.1-or-later
#include "checkpoints.h"
#include "mpi_session.h"
#include "run_output.h"
#include "validation_report.h"

#include <pellicle/apps/accuracy_run.h>
#include <pellicle/apps/surface_application.h>
#include <pellicle/apps/surface_run.h>
#include <pellicle/apps/time_run.h>
#include <pellicle/output/atomic_file.h>
#include <pellicle/output/summary.h>

#include <mpi.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <variant>

namespace pellicle
{
namespace
{
namespace fs = std::filesystem;

void print_result(const RunResult &result, const fs::path &directory)
{
  for (const auto &[name, value] : result.quantities)
    std::printf("  %-32s %.10g\n", name.c_str(), value);
  std::printf("%s: %s after %d iterations, %.2f s; results in %s\n", result.application.c_str(),
              status_name(result.status), result.newton.iterations, result.seconds.total, directory.c_str());
  std::fflush(stdout);
}

/** The commented scene with the effects of the scene on the command line, or the application's own list if there is
 * none. */
void write_parameters(const SurfaceApplication &application, const CommandLine &command_line)
{
  SurfaceApplication listed = application;
  if (!command_line.scene_file.empty())
    listed.default_effects = SurfaceSceneFile(application, command_line).effect_names();
  write_whole_file(command_line.write_parameters_file, commented_scene_of(listed));
}

/** Where the run writes: what the command line says, else where the earlier run wrote, else a folder with the scene's
 * name. */
fs::path directory_of(const CommandLine &command_line)
{
  if (!command_line.output_directory.empty())
    return command_line.output_directory;
  if (!command_line.restart_directory.empty())
    return command_line.restart_directory;
  return fs::path("output") / fs::path(command_line.scene_file).stem();
}

int run(const SurfaceApplication &application, const CommandLine &command_line, const Communicator &communicator,
        Timing &timing, bool &has_begun)
{
  const bool first_process = communicator.rank() == 0;
  if (!command_line.write_parameters_file.empty())
  {
    if (first_process)
      write_parameters(application, command_line);
    return 0;
  }

  std::optional<EarlierRun> earlier;
  if (!command_line.restart_directory.empty())
    earlier.emplace(application.name, command_line.restart_directory);
  SurfaceSceneFile file(application, command_line, earlier ? earlier->scene_text() : "");
  std::unique_ptr<SurfaceScene> scene = file.read();
  const std::string used_text         = file.used_text();
  if (earlier)
    earlier->check_scene(used_text);
  const auto whole_run =
      std::find_if(application.analyses.begin(), application.analyses.end(),
                   [&](const WholeRunAnalysis &analysis) { return scene->has_analysis(analysis.name); });
  if (whole_run != application.analyses.end() && scene->checkpoint.every > 0)
    throw UserError("Checkpoint/Every = " + std::to_string(scene->checkpoint.every) + ": the analysis '" +
                    whole_run->name + "' writes no checkpoints. Set it to 0.");
  if (scene->accuracy.is_wanted() && scene->checkpoint.every > 0)
    throw UserError("Checkpoint/Every = " + std::to_string(scene->checkpoint.every) +
                    ": a run towards Accuracy/Target writes no checkpoints. Set one of them to 0.");
  if (!scene->load.parameter.empty())
    scene = scene_at_start_of_load(file, scene->load);
  const bool has_own_mesh = !scene->accuracy.is_wanted() || command_line.validate; // else it is made level by level
  auto model              = has_own_mesh ? std::make_unique<SurfaceModel>(*scene, communicator, timing) : nullptr;
  if (command_line.validate)
  {
    if (first_process)
      write_validation_report(*scene, *model, timing, std::cout);
    return 0;
  }

  const fs::path directory = directory_of(command_line);
  RunOutput output(first_process, directory, earlier ? earlier->directory() : "", *scene, command_line.verbosity,
                   timing);
  output.write_scene(used_text);
  has_begun = true;
  if (earlier)
    for (const std::string &warning : earlier->warnings())
      output.observer().on_message(warning);
  Checkpoints checkpoints(application.name, used_text, scene->checkpoint, directory, output,
                          earlier ? &*earlier : nullptr);
  const SolutionSink write_solution = [&](const SurfaceModel &solved, const int step, const double time)
  { output.write_solution(solved, step, time); };
  RunResult result;
  if (whole_run != application.analyses.end())
  {
    model = whole_run->run({file, communicator, timing, output.observer(), write_solution}, *scene, result);
    describe(*scene, *model, result);
  }
  else if (scene->accuracy.is_wanted())
    model = run_to_accuracy({file, communicator, timing, output.observer(), write_solution}, *scene, result);
  else if (scene->motion() != nullptr)
    result = run_in_time(*scene, *model, output.observer(), write_solution, checkpoints);
  else
    result = solve_scene(file, *scene, *model, output.observer(), write_solution, checkpoints);
  result.application = application.name;
  if (earlier)
    result.warnings.insert(result.warnings.end(), earlier->warnings().begin(), earlier->warnings().end());
  output.finish(*model, result);
  if (first_process)
  {
    if (command_line.verbosity != Verbosity::quiet)
      print_result(result, directory);
    if (result.status != RunStatus::converged)
      std::cerr << application.name << ": " << result.message << std::endl;
  }
  return result.status == RunStatus::converged ? 0 : 1;
}
} // namespace

std::unique_ptr<SurfaceScene> SurfaceApplication::scene(const std::vector<std::string> &effects,
                                                        const std::vector<std::string> &listed_analyses) const
{
  std::unique_ptr<SurfaceScene> result = empty_scene(effects);
  list_effects(*result, library, effects, listed_analyses);
  return result;
}

std::vector<std::string> SurfaceApplication::analysis_names() const
{
  std::vector<std::string> names{"stability"};
  for (const WholeRunAnalysis &analysis : analyses)
    names.push_back(analysis.name);
  return names;
}

int run_surface_application(int argc, char **argv, const SurfaceApplication &application)
{
  Timing timing;
  const MpiSession session(argc, argv);
  const Communicator communicator;
  const bool first_process = communicator.rank() == 0;
  const auto complain      = [&](const std::string &text)
  {
    if (first_process)
      std::cerr << application.name << ": " << text << std::endl;
  };

  const auto parsed = parse_command_line(argc, argv, application.name, application.description);
  if (const auto *end = std::get_if<CommandLineExit>(&parsed))
  {
    if (first_process)
      (end->status == 0 ? std::cout : std::cerr) << end->text << std::flush;
    return end->status;
  }
  const auto end_with = [&](const int status, const std::string &reason)
  {
    complain(reason);
    if (!all_processes_arrive())
      MPI_Abort(MPI_COMM_WORLD, status);
    return status;
  };
  std::signal(SIGXFSZ, SIG_IGN); // a file that may not grow further is an error of the write that meets it
  bool has_begun = false;
  try
  {
    return run(application, std::get<CommandLine>(parsed), communicator, timing, has_begun);
  }
  catch (const WriteError &error)
  {
    return end_with(has_begun ? 1 : 2, error.what());
  }
  catch (const UserError &error)
  {
    return end_with(2, error.what());
  }
  catch (const SolveError &error) // before the first solve, whose errors are results
  {
    return end_with(1, std::string("the scene is not solved: ") + error.what());
  }
  catch (const std::exception &error)
  {
    return end_with(1, std::string("stopped by an error that should not happen: ") + error.what());
  }
}
} // namespace pellicle

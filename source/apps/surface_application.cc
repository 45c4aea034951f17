// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mpi_session.h"
#include "run_output.h"

#include <pellicle/apps/surface_application.h>
#include <pellicle/apps/surface_run.h>
#include <pellicle/apps/time_run.h>
#include <pellicle/output/atomic_file.h>
#include <pellicle/output/summary.h>

#include <mpi.h>

#include <algorithm>
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

void print_validation(const SurfaceScene &scene, const SurfaceModel &model)
{
  std::cout << "The scene is valid.\nEffects:";
  for (const auto &effect : scene.effects)
    std::cout << "\n  " << effect->name() << ": " << effect->description();
  std::cout << "\nMesh: " << model.n_cells() << " cells of degree " << model.mesh().degree << ", "
            << model.mesh().n_nodes << " nodes\nFields:";
  for (const Field &field : model.equilibrium().layout().fields())
    std::cout << ' ' << field.name;
  std::cout << std::endl;
}

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

int run(const SurfaceApplication &application, const CommandLine &command_line, const Communicator &communicator,
        Timing &timing)
{
  const bool first_process = communicator.rank() == 0;
  if (!command_line.write_parameters_file.empty())
  {
    if (first_process)
      write_parameters(application, command_line);
    return 0;
  }

  SurfaceSceneFile file(application, command_line);
  std::unique_ptr<SurfaceScene> scene = file.read();
  const std::string used_text         = file.used_text();
  if (!scene->load.parameter.empty())
    scene = scene_at_start_of_load(file, scene->load);
  auto model = std::make_unique<SurfaceModel>(*scene, communicator, timing);
  if (command_line.validate)
  {
    if (first_process)
      print_validation(*scene, *model);
    return 0;
  }

  const fs::path directory = command_line.output_directory.empty()
                                 ? fs::path("output") / fs::path(command_line.scene_file).stem()
                                 : fs::path(command_line.output_directory);
  RunOutput output(first_process, directory, *scene, command_line.verbosity, timing);
  output.write_scene(used_text);
  const SolutionSink write_solution = [&](const SurfaceModel &solved, const int step, const double time)
  { output.write_solution(solved, step, time); };
  RunResult result;
  const auto whole_run =
      std::find_if(application.analyses.begin(), application.analyses.end(),
                   [&](const WholeRunAnalysis &analysis) { return scene->has_analysis(analysis.name); });
  if (whole_run != application.analyses.end())
  {
    model = whole_run->run({file, communicator, timing, output.observer(), write_solution}, *scene, result);
    describe(*scene, *model, result);
  }
  else if (scene->motion() != nullptr)
    result = run_in_time(*scene, *model, output.observer(), write_solution);
  else
    result = solve_scene(file, *scene, *model, output.observer(), write_solution);
  result.application = application.name;
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

  const auto leave = [](const int status)
  {
    if (!all_processes_arrive())
      MPI_Abort(MPI_COMM_WORLD, status);
    return status;
  };

  const auto parsed = parse_command_line(argc, argv, application.name, application.description);
  if (const auto *end = std::get_if<CommandLineExit>(&parsed))
  {
    if (first_process)
      (end->status == 0 ? std::cout : std::cerr) << end->text << std::flush;
    return end->status;
  }
  try
  {
    return run(application, std::get<CommandLine>(parsed), communicator, timing);
  }
  catch (const UserError &error)
  {
    complain(error.what());
    return leave(2);
  }
  catch (const SolveError &error) // before the first solve, whose errors are results
  {
    complain(std::string("the scene is not solved: ") + error.what());
    return leave(1);
  }
  catch (const std::exception &error)
  {
    complain(std::string("stopped by an error that should not happen: ") + error.what());
    return leave(1);
  }
}
} // namespace pellicle

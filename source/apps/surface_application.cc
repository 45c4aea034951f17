// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/apps/phase_diagram.h>
#include <pellicle/apps/surface_application.h>
#include <pellicle/apps/surface_run.h>
#include <pellicle/output/atomic_file.h>
#include <pellicle/output/observer_list.h>
#include <pellicle/output/picture.h>
#include <pellicle/output/progress.h>
#include <pellicle/output/run_files.h>
#include <pellicle/output/summary.h>
#include <pellicle/output/vtu.h>

#include <mpi.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>
#include <thread>

namespace pellicle
{
namespace
{
namespace fs = std::filesystem;

/** MPI for the lifetime of a run, unless somebody initialised it before. */
class MpiSession
{
public:
  MpiSession(int &argc, char **&argv)
  {
    int running = 0;
    MPI_Initialized(&running);
    if (running == 0)
    {
      // Started by hand and not by mpirun, Open MPI would launch a daemon and look for networks: 0.3 s for one process
      // that talks to nobody.
      if (std::getenv("OMPI_COMM_WORLD_SIZE") == nullptr && std::getenv("PMIX_RANK") == nullptr &&
          std::getenv("PMI_RANK") == nullptr)
      {
        constexpr int keep_users_choice = 0;
        setenv("OMPI_MCA_ess_singleton_isolated", "1", keep_users_choice);
        // Isolated processes would all use the same session folder and take it away from under each other; one process
        // needs none.
        setenv("OMPI_MCA_orte_create_session_dirs", "0", keep_users_choice);
        setenv("OMPI_MCA_pml", "ob1", keep_users_choice);
        setenv("OMPI_MCA_btl", "self", keep_users_choice);
      }
      MPI_Init(&argc, &argv);
      own = true;
    }
  }
  ~MpiSession()
  {
    if (own)
      MPI_Finalize();
  }
  MpiSession(const MpiSession &)            = delete;
  MpiSession &operator=(const MpiSession &) = delete;

private:
  bool own = false;
};

/**
 * True if all processes come here within a second. A bad scene stops all of them alike, and then MPI can end in an
 * orderly way; an error of one process (files are the first one's business) leaves the others waiting in a computation,
 * and only an abort ends those.
 */
bool all_processes_arrive()
{
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Ibarrier(MPI_COMM_WORLD, &request);
  int arrived = 0;
  for (int waits = 0; arrived == 0 && waits < 100; ++waits)
  {
    MPI_Test(&request, &arrived, MPI_STATUS_IGNORE);
    if (arrived == 0)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return arrived != 0;
}

/** The files and the terminal lines of a run. On processes other than the first it does nothing. */
class RunOutput
{
public:
  RunOutput(const bool first_process, fs::path output_directory, const SurfaceScene &scene, const Verbosity verbosity,
            Timing &timing)
      : writes(first_process)
      , directory(std::move(output_directory))
      , parameters(scene.output)
      , timing(timing)
  {
    if (!writes)
      return;
    prepare_output_directory(directory);
    files.emplace(directory);
    solutions.emplace(directory);
    progress.emplace(std::cout, verbosity, standard_output_is_terminal());
    observers = std::make_unique<ObserverList>(std::vector<Observer *>{&*files, &*progress});
  }

  Observer &observer() { return writes ? static_cast<Observer &>(*observers) : nobody; }

  void write_scene(const std::string &text) const
  {
    if (writes)
      write_whole_file(directory / "used.prm", text);
  }

  void write_solution(const SurfaceModel &model, const int step, const double time)
  {
    if (!writes || !parameters.solution)
      return;
    const Timing::Scope scope(timing, "output");
    last_solution = solutions->write(model.sample(), step, time);
  }

  /** Picture and summary; the summary comes last. */
  void finish(const SurfaceModel &model, RunResult &result)
  {
    if (!writes)
      return;
    {
      const Timing::Scope scope(timing, "output");
      if (parameters.picture && result.status == RunStatus::converged)
        draw(model, result);
    }
    progress.reset(); // ends its line
    result.seconds = {timing.total(), timing.seconds("assembly"), timing.seconds("linear solve"),
                      timing.seconds("output")};
    write_summary(directory, result);
  }

private:
  void draw(const SurfaceModel &model, RunResult &result)
  {
    // Without Output/Solution the renderer still needs a file to read; it does not stay.
    const fs::path vtu = last_solution.empty() ? directory / "picture.vtu" : last_solution;
    if (last_solution.empty())
      write_vtu(vtu, model.sample());
    if (const std::optional<std::string> reason = render_picture(vtu, directory / "picture.png", result.application))
    {
      progress->on_message(*reason);
      result.warnings.push_back(*reason);
    }
    if (last_solution.empty())
      fs::remove(vtu);
  }

  bool writes;
  fs::path directory, last_solution;
  OutputParameters parameters;
  Timing &timing;
  Observer nobody;
  std::optional<RunFiles> files;
  std::optional<SolutionFiles> solutions;
  std::optional<Progress> progress;
  std::unique_ptr<ObserverList> observers;
};

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
  SurfaceScene scene          = file.read();
  const std::string used_text = file.used_text();
  if (!scene.load.parameter.empty())
    scene = scene_at_start_of_load(file, scene.load);
  auto model = std::make_unique<SurfaceModel>(scene, communicator, timing);
  if (command_line.validate)
  {
    if (first_process)
      print_validation(scene, *model);
    return 0;
  }

  const fs::path directory = command_line.output_directory.empty()
                                 ? fs::path("output") / fs::path(command_line.scene_file).stem()
                                 : fs::path(command_line.output_directory);
  RunOutput output(first_process, directory, scene, command_line.verbosity, timing);
  output.write_scene(used_text);
  const auto sink = [&](const SurfaceModel &solved, const int step, const double time)
  { output.write_solution(solved, step, time); };
  RunResult result;
  if (scene.has_analysis("phase diagram"))
  {
    model = run_phase_diagram(file, scene, communicator, timing, output.observer(), sink, result);
    describe(scene, *model, result);
  }
  else
    result = solve_scene(file, scene, *model, output.observer(), sink);
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
  try
  {
    return run(application, std::get<CommandLine>(parsed), communicator, timing);
  }
  catch (const UserError &error)
  {
    complain(error.what());
    if (!all_processes_arrive())
      MPI_Abort(MPI_COMM_WORLD, 2);
    return 2;
  }
  catch (const std::exception &error)
  {
    complain(std::string("stopped by an error that should not happen: ") + error.what());
    if (!all_processes_arrive())
      MPI_Abort(MPI_COMM_WORLD, 1);
    return 1;
  }
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "run_output.h"

#include <pellicle/output/atomic_file.h>
#include <pellicle/output/picture.h>
#include <pellicle/output/summary.h>

#include <iostream>
#include <utility>
#include <vector>

namespace pellicle
{
namespace fs = std::filesystem;

RunOutput::RunOutput(const bool first_process, fs::path output_directory, const SurfaceScene &scene,
                     const Verbosity verbosity, Timing &timing)
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

void RunOutput::write_scene(const std::string &text) const
{
  if (writes)
    write_whole_file(directory / "used.prm", text);
}

void RunOutput::write_solution(const SurfaceModel &model, const int step, const double time)
{
  if (!writes || !parameters.solution)
    return;
  const Timing::Scope scope(timing, "output");
  last_solution = solutions->write(model.sample(), step, time, model.body_samples());
}

void RunOutput::finish(const SurfaceModel &model, RunResult &result)
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

void RunOutput::draw(const SurfaceModel &model, RunResult &result)
{
  // Without Output/Solution the renderer still needs a file to read; it does not stay.
  const fs::path vtu = last_solution.empty() ? directory / "picture.vtu" : last_solution;
  if (last_solution.empty())
    write_vtu(vtu, model.sample());
  const SurfaceSample bodies = model.surroundings();
  const fs::path beside      = bodies.n_cells > 0 ? directory / "substrate.vtu" : fs::path();
  if (!beside.empty())
    write_vtu(beside, bodies);
  if (const std::optional<std::string> reason =
          render_picture(vtu, beside, directory / "picture.png", result.application))
  {
    progress->on_message(*reason);
    result.warnings.push_back(*reason);
  }
  if (last_solution.empty())
  {
    fs::remove(vtu);
    if (!beside.empty())
      fs::remove(beside);
  }
}
} // namespace pellicle

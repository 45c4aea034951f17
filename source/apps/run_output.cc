// SPDX-License-Identifier: LGPL-2.1-or-later
#include "run_output.h"

#include <pellicle/models/director_defects.h>
#include <pellicle/output/atomic_file.h>
#include <pellicle/output/picture.h>
#include <pellicle/output/summary.h>

#include <iostream>
#include <utility>
#include <vector>

namespace pellicle
{
namespace fs = std::filesystem;

RunOutput::RunOutput(const bool first_process, fs::path output_directory, fs::path earlier, const SurfaceScene &scene,
                     const Verbosity verbosity, Timing &timing)
    : writes(first_process)
    , directory(std::move(output_directory))
    , earlier_directory(std::move(earlier))
    , parameters(scene.output)
    , timing(timing)
{
  if (!writes)
    return;
  std::error_code missing;
  if (!earlier_directory.empty() && fs::equivalent(directory, earlier_directory, missing))
    prepare_continued_directory(directory);
  else
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

void RunOutput::exchange(Archive &archive)
{
  if (!writes)
    return;
  files->exchange(archive);
  solutions->exchange(archive, earlier_directory);
  last_solution = solutions->last();
}

void RunOutput::write_solution(const SurfaceModel &model, const int step, const double time)
{
  if (!writes)
    return;
  const Timing::Scope scope(timing, "output");
  write_defects(model, step);
  if (parameters.solution)
    last_solution = solutions->write(model.sample(), step, time, model.body_samples());
}

void RunOutput::write_defects(const SurfaceModel &model, const int step)
{
  const auto defects = director_defects(model);
  if (!defects)
    return;
  for (const Defect &defect : *defects)
  {
    const Vector3<double> x = model.origin() + model.scales().length * defect.position;
    files->on_row({"defects",
                   {{"step", std::to_string(step)},
                    {"x", number_text(x[0])},
                    {"y", number_text(x[1])},
                    {"z", number_text(x[2])},
                    {"charge", std::to_string(defect.charge)}}});
  }
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
  // Without Output/Solution the renderer still needs files to read; they do not stay.
  std::vector<fs::path> temporary;
  const auto written = [&](const char *name, const SurfaceSample &sample)
  {
    temporary.push_back(directory / name);
    write_vtu(temporary.back(), sample);
    return temporary.back();
  };
  const fs::path vtu = last_solution.empty() ? written("picture.vtu", model.sample()) : last_solution;
  const std::vector<NamedSample> bodies = model.body_samples();
  const SurfaceSample surroundings      = model.surroundings();
  const fs::path png                    = directory / "picture.png";
  std::optional<std::string> reason;
  if (!bodies.empty())
    reason = render_section(vtu, written("picture_body.vtu", bodies[0].sample), png, result.application);
  else if (surroundings.n_cells == 0)
    reason = render_picture(vtu, "", png, result.application);
  else
  {
    const fs::path beside = directory / "substrate.vtu";
    write_vtu(beside, surroundings);
    if (last_solution.empty())
      temporary.push_back(beside);
    reason = render_picture(vtu, beside, png, result.application);
  }
  if (reason)
  {
    progress->on_message(*reason);
    result.warnings.push_back(*reason);
  }
  std::error_code ignored;
  for (const fs::path &path : temporary)
    fs::remove(path, ignored);
}
} // namespace pellicle

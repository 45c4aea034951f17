// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/apps/command_line.h>
#include <pellicle/base/timing.h>
#include <pellicle/models/run_result.h>
#include <pellicle/models/surface_model.h>
#include <pellicle/models/surface_scene.h>
#include <pellicle/output/observer_list.h>
#include <pellicle/output/progress.h>
#include <pellicle/output/run_files.h>
#include <pellicle/output/vtu.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace pellicle
{
/** The files and the terminal lines of a run. On processes other than the first it does nothing. */
class RunOutput
{
public:
  /** Makes the directory, or takes the results of an earlier run out of it.
   * `earlier_directory`: of the run that goes on, whose solutions stay; empty: a new one. */
  RunOutput(bool first_process, std::filesystem::path output_directory, std::filesystem::path earlier_directory,
            const SurfaceScene &scene, Verbosity verbosity, Timing &timing);

  /** Whether this is the process that writes. */
  bool is_written() const { return writes; }
  Observer &observer() { return writes ? static_cast<Observer &>(*observers) : nobody; }

  void write_scene(const std::string &text) const;
  /** Tables and solutions so far. On processes other than the first it writes and reads nothing. */
  void exchange(Archive &archive);
  /** The surface with its fields, and where its directors have defects. */
  void write_solution(const SurfaceModel &model, int step, double time);

  /** Picture and summary; the summary comes last. */
  void finish(const SurfaceModel &model, RunResult &result);

private:
  void write_defects(const SurfaceModel &model, int step);
  void draw(const SurfaceModel &model, RunResult &result);

  bool writes;
  std::filesystem::path directory, earlier_directory, last_solution;
  OutputParameters parameters;
  Timing &timing;
  Observer nobody;
  std::optional<RunFiles> files;
  std::optional<SolutionFiles> solutions;
  std::optional<Progress> progress;
  std::unique_ptr<ObserverList> observers;
};
} // namespace pellicle

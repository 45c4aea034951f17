// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/apps/command_line.h>
#include <pellicle/apps/run_memory.h>
#include <pellicle/apps/surface_application.h>
#include <pellicle/base/scene.h>
#include <pellicle/base/scene_text.h>
#include <pellicle/models/run_result.h>
#include <pellicle/models/surface_model.h>

#include <functional>
#include <memory>

namespace pellicle
{
/** A scene file with its effects: reads the parameter structs anew whenever a load step changes one of them. */
class SurfaceSceneFile
{
public:
  /** Reads file and overrides; a relative Mesh/File counts from the scene's folder. Throws UserError.
   * `earlier_text`: used_text() of the run that goes on, which takes the place of a scene file that is not given. */
  SurfaceSceneFile(const SurfaceApplication &application, const CommandLine &command_line,
                   const std::string &earlier_text = "");

  /** The parameter structs as the scene stands now, checked. */
  std::unique_ptr<SurfaceScene> read();
  /** Sets a parameter to a number. */
  void set(const std::string &path, double value, const std::string &origin);
  /** Sets a parameter to a text. */
  void set_text(const std::string &path, const std::string &value, const std::string &origin);
  /** The number that a parameter has now. Throws UserError if there is none. */
  double number(const std::string &path) const;
  /** Names of the listed effects. */
  const std::vector<std::string> &effect_names() const { return effects; }
  /** used.prm. */
  std::string used_text();

private:
  const SurfaceApplication &application;
  Scene scene;
  std::vector<std::string> effects, analyses;
};

/** What --write-parameters and the manual describe: all parameters of the effects, listed ones first. */
std::string commented_scene_of(const SurfaceApplication &application);

/**
 * Moves the stepped parameter to Load/From and returns the scene there. Throws UserError if Load/Parameter is not a
 * number of this scene, or if From or To is not a value that it can have: a mistake there must not come to light after
 * hours.
 */
std::unique_ptr<SurfaceScene> scene_at_start_of_load(SurfaceSceneFile &file, const LoadParameters &load);

/** Entries that a matrix has in both triangles, whether both are stored or one. */
std::size_t n_entries(const SparseMatrix &matrix);

/** What summary.json says of scene and model whatever the analysis: effects, mesh, loops, unknowns,
 * stability. */
void describe(const SurfaceScene &scene, const SurfaceModel &model, RunResult &result);

/** Called after every equilibrium: step, value of the stepped parameter (the step's number without load stepping). */
using SolutionSink = std::function<void(const SurfaceModel &model, int step, double time)>;

/** What a run works with. */
class RunContext
{
public:
  SurfaceSceneFile &file;
  const Communicator &communicator;
  Timing &timing;
  Observer &observer;
  const SolutionSink &sink;
};

/** Solves a scene at once from the model's present state, as if it had no load path. Returns what solve_scene() does.
 */
RunResult solve_here(SurfaceSceneFile &file, const SurfaceScene &scene, SurfaceModel &model, Observer &observer,
                     const SolutionSink &sink);

/**
 * Solves a scene, load steps included. Returns everything that summary.json says but the seconds of output; never
 * throws for a solve that failed.
 */
RunResult solve_scene(SurfaceSceneFile &file, const SurfaceScene &first, SurfaceModel &model, Observer &observer,
                      const SolutionSink &sink, RunMemory &memory);
} // namespace pellicle

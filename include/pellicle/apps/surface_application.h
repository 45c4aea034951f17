// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/models/surface_scene.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace pellicle
{
class RunContext;
struct RunResult;

/** An analysis that takes the place of solving the scene once or in load steps. */
struct WholeRunAnalysis
{
  std::string name;
  /** Returns the model at the last state. */
  std::function<std::unique_ptr<SurfaceModel>(const RunContext &context, const SurfaceScene &scene, RunResult &result)>
      run;
};

/** What makes an application of the surface model: its name, the effects it offers and those it lists by default, its
 * scenes. */
struct SurfaceApplication
{
  std::string name;
  std::string description; ///< one or two sentences for --help
  EffectLibrary library;
  std::vector<std::string> default_effects;
  /** An empty scene of the application's own kind, which may depend on the listed effects. */
  std::function<std::unique_ptr<SurfaceScene>(const std::vector<std::string> &effects)> empty_scene;
  /** Analyses of its own, beside "stability". */
  std::vector<WholeRunAnalysis> analyses = {};

  /** A scene with effects at their defaults. Throws UserError for an unknown effect. */
  std::unique_ptr<SurfaceScene> scene(const std::vector<std::string> &effects,
                                      const std::vector<std::string> &listed_analyses) const;
  /** All that can be listed. */
  std::vector<std::string> analysis_names() const;
};

/**
 * The whole of an application: command line, scene, model, load steps, files (doc of every part: the manual's interface
 * page). Initialises MPI if nobody has.
 *
 * @return exit status: 0 solved; 1 did not converge or refused to go on; 2 bad command line or scene.
 */
int run_surface_application(int argc, char **argv, const SurfaceApplication &application);
} // namespace pellicle

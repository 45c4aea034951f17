// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "recorder.h"

#include <pellicle/apps/surface_run.h>
#include <pellicle/models/accuracy.h>

#include <memory>

namespace pellicle
{
/** A scene on one of the meshes that an accuracy is looked for with. */
struct Level
{
  LevelMesh mesh;
  SurfaceSceneFile file; ///< as the scene stands where the level is solved
  std::unique_ptr<SurfaceScene> scene;
  std::unique_ptr<SurfaceModel> model;
  Recorder record  = {};
  RunResult result = {};

  bool is_solved() const { return result.status == RunStatus::converged; }
};

/** Makes levels of a scene. */
class LevelMaker
{
public:
  /** The context's file stands at the start of section Load, as `first` does. */
  LevelMaker(const RunContext &context, const SurfaceScene &first);

  /** Solved as the scene says, along its load path. */
  std::unique_ptr<Level> walked(const LevelMesh &mesh) const;
  /** At the end of the load path with the state of a solved level, not solved itself; null if that cannot be carried
   * over. */
  std::unique_ptr<Level> continued(const LevelMesh &mesh, const Level &solved) const;
  /** From the state at which it stands: at first without drag, which keeps Newton's method from leaving it. */
  void solve(Level &level) const;

private:
  SurfaceSceneFile with_mesh(const SurfaceSceneFile &file, const LevelMesh &mesh) const;
  std::unique_ptr<Level> at_start(const LevelMesh &mesh, const SurfaceSceneFile &file) const;
  bool has_load_path() const;

  const RunContext &context;
  const SurfaceScene &first;
  const SurfaceSceneFile start;
  const SolutionSink nowhere = [](const SurfaceModel &, int, double) {};
};
} // namespace pellicle

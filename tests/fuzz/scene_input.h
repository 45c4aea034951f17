// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "memory_file.h"

#include <pellicle/apps/surface_run.h>

#include <memory>
#include <string>
#include <vector>

namespace pellicle::fuzz
{
/**
 * A scene with what stands on the command line beside it, in comments: `#:vesicle` names the application (the first
 * one without it), `#:set Mesh/Degree=4` is an argument of --set.
 */
class SceneInput
{
public:
  /** `overrides` come after those of the input. Throws UserError for a scene that cannot be read. */
  explicit SceneInput(const std::string &input, const std::vector<std::string> &overrides = {});

  SurfaceSceneFile &file() { return *scene_file; }
  const SurfaceApplication &application() const { return *chosen; }

private:
  MemoryFile memory;
  const SurfaceApplication *chosen;
  std::unique_ptr<SurfaceSceneFile> scene_file;
};
} // namespace pellicle::fuzz

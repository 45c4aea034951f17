// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "run_output.h"

#include <pellicle/apps/run_memory.h>
#include <pellicle/output/checkpoint_files.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pellicle
{
/** A run that is to go on: its last checkpoint. */
class EarlierRun
{
public:
  /** Throws UserError if there is no checkpoint that can be used, or if it is of another application or version. */
  EarlierRun(const std::string &application, std::filesystem::path output_directory);

  const std::filesystem::path &directory() const { return output_directory; }
  /** Of the checkpoint. */
  const std::filesystem::path &path() const { return file.path; }
  const std::string &scene_text() const { return scene; }
  /** Newer checkpoints that are damaged. */
  const std::vector<std::string> &warnings() const { return file.warnings; }
  /** Throws UserError if a scene differs in a parameter on which what was computed depends. */
  void check_scene(const std::string &used_text) const;
  /** Gives files and state of the run to be read. Throws UserError if they do not fit. Returns the number of steps. */
  int read(RunOutput &output, const RunState &state);

private:
  std::filesystem::path output_directory;
  FoundCheckpoint file;
  Archive archive;
  std::string scene;
};

/** Writes a checkpoint after every so many steps, and lets a run take up an earlier one. */
class Checkpoints : public RunMemory
{
public:
  /** `earlier`: null for a run that begins; must outlive this object. */
  Checkpoints(std::string application, std::string scene_text, const CheckpointParameters &parameters,
              std::filesystem::path output_directory, RunOutput &output, EarlierRun *earlier);

  bool take_up(const RunState &state) override;
  void after_step(const RunState &state) override;

private:
  std::string application, scene_text;
  CheckpointParameters parameters;
  std::filesystem::path directory;
  RunOutput &output;
  EarlierRun *earlier;
  std::optional<CheckpointFiles> files; ///< made with the first one
  int n_steps = 0;
};
} // namespace pellicle

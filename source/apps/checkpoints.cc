// SPDX-License-Identifier: LGPL-2.1-or-later
#include "checkpoints.h"

#include <pellicle/base/scene_file.h>
#include <pellicle/base/version.h>

#include <map>
#include <utility>

namespace pellicle
{
namespace
{
namespace fs = std::filesystem;

/** Of the layout of what follows. */
constexpr int format = 1;

/** What a checkpoint begins with. */
struct Origin
{
  int format_number = format;
  std::string application, program_version, scene_text;

  void exchange(Archive &archive)
  {
    archive.name("run");
    archive | format_number | application | program_version | scene_text;
  }
};

/** Parameters that only say how far to go, how to solve and what to write. */
bool may_change(const std::string &parameter)
{
  for (const char *section : {"Output/", "Checkpoint/", "Newton/"})
    if (parameter.rfind(section, 0) == 0)
      return true;
  for (const char *name : {"Load/To", "Load/Steps", "Load/Smallest step", "Continuation/Maximum points"})
    if (parameter == name)
      return true;
  return false;
}

std::map<std::string, std::string> values_of(const std::string &scene_text)
{
  std::map<std::string, std::string> values;
  for (const SceneEntry &entry : scan_scene(scene_text, "scene").entries)
    values[entry.path()] = entry.value;
  return values;
}
} // namespace

EarlierRun::EarlierRun(const std::string &application, fs::path directory)
    : output_directory(std::move(directory))
    , file(read_last_checkpoint(output_directory))
    , archive(file.content)
{
  Origin origin;
  try
  {
    archive | origin;
  }
  catch (const ArchiveMismatch &)
  {
    origin.format_number = 0;
  }
  if (origin.format_number != format || origin.program_version != version())
    throw UserError("The checkpoint '" + file.path.string() + "' was written by " +
                    (origin.program_version.empty() ? "another version" : "version " + origin.program_version) +
                    " of the program, and this is version " + version() +
                    ". Go on with that version, or run the scene from its start.");
  if (origin.application != application)
    throw UserError("The checkpoint '" + file.path.string() + "' was written by the application '" +
                    origin.application + "', not by '" + application + "'. Go on with that one.");
  scene = origin.scene_text;
}

void EarlierRun::check_scene(const std::string &used_text) const
{
  std::map<std::string, std::string> then = values_of(scene), now = values_of(used_text);
  for (const auto &[path, value] : now)
    if (!may_change(path) && then[path] != value)
      throw UserError(path + " = " + value + ": the run in '" + output_directory.string() + "' has " +
                      (then[path].empty() ? "none" : then[path]) +
                      ". A run that goes on may change only the sections Output, Checkpoint and Newton, Load/To, "
                      "Load/Steps, Load/Smallest step and Continuation/Maximum points. Leave the others as they are, "
                      "or run the scene from its start.");
  for (const auto &[path, value] : then)
    if (!may_change(path) && now.find(path) == now.end())
      throw UserError(path + " is missing: the run in '" + output_directory.string() + "' has " + value +
                      ". Give the same scene, or none.");
}

int EarlierRun::read(RunOutput &output, const RunState &state)
{
  int n_steps = 0;
  std::string of_files;
  try
  {
    archive | n_steps | of_files;
    Archive in_files(of_files);
    output.exchange(in_files); // first: they stay if the state does not fit
    state(archive);
  }
  catch (const ArchiveMismatch &error)
  {
    throw UserError("The checkpoint '" + file.path.string() + "' does not fit this scene: " + error.what() +
                    ". A mesh file or the program may have changed since. Run the scene from its start.");
  }
  return n_steps;
}

Checkpoints::Checkpoints(std::string application, std::string scene_text, const CheckpointParameters &parameters,
                         fs::path output_directory, RunOutput &output, EarlierRun *earlier)
    : application(std::move(application))
    , scene_text(std::move(scene_text))
    , parameters(parameters)
    , directory(std::move(output_directory))
    , output(output)
    , earlier(earlier)
{
}

bool Checkpoints::take_up(const RunState &state)
{
  if (earlier == nullptr)
    return false;
  n_steps = earlier->read(output, state);
  std::error_code missing;
  if (output.is_written() && fs::equivalent(directory, earlier->directory(), missing))
    remove_later_checkpoints(earlier->path());
  return true;
}

void Checkpoints::after_step(const RunState &state)
{
  ++n_steps;
  if (parameters.every == 0 || n_steps % parameters.every != 0)
    return;
  Origin origin{format, application, version(), scene_text};
  Archive files_so_far, archive;
  output.exchange(files_so_far);
  std::string of_files = files_so_far.content();
  archive | origin | n_steps | of_files;
  state(archive);
  if (!output.is_written())
    return;
  if (!files)
    files.emplace(directory, parameters.keep);
  files->write(n_steps, archive.content());
}
} // namespace pellicle

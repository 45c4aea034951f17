// SPDX-License-Identifier: LGPL-2.1-or-later
// What --restart does until it would compute: checkpoints as they are on the disc, and true ones of small runs with
// changes behind their checksums.
#include "scene_input.h"
#include "targets.h"

#include "../../source/apps/checkpoints.h"
#include "../../source/apps/mpi_session.h"

#include <pellicle/apps/time_run.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace pellicle::fuzz
{
namespace
{
namespace fs = std::filesystem;

const std::vector<std::string> small_scenes = {
    R"(#:vesicle
set Effects = helfrich bending, area constraint, volume constraint
subsection Vesicle
  set Reduced volume = 0.95
end
subsection Load
  set Parameter = Vesicle/Reduced volume
  set To        = 0.94
  set Steps     = 1
end
)",
    R"(#:droplet_contact
set Effects = liquid surface, volume constraint, contact
subsection Droplet
  set Base          = membrane
  set Contact angle = 180
  set Volume        = 4.18879
end
subsection Substrate
  set Plate distance = 1.9
end
)",
    R"(#:droplet_contact
set Effects = liquid surface, volume constraint, wetting, line pinning
subsection Droplet
  set Contact angle = 90
end
subsection Line pinning
  set Advancing angle = 100
  set Receding angle  = 80
end
subsection Load
  set Parameter = Droplet/Volume
  set To        = 2.2
  set Steps     = 1
end
)",
    R"(#:director_membrane
set Effects = director, director friction
subsection Surface
  set Motion = held
end
subsection Vesicle
  set Start shape = ellipsoid
end
subsection Director field
  set Start = towards z
end
subsection Time
  set Integrator = minimising
  set Step       = 0.2
  set End time   = 0.2
end
)"};

SceneInput input_of(const std::string &scene)
{
  return SceneInput(scene, {"Mesh/Symmetry=axial", "Mesh/Degree=2", "Mesh/Refinements=1"});
}

/** A folder that goes away with the process. */
class Folder
{
public:
  Folder()
  {
    std::string name = (fs::temp_directory_path() / "pellicle-fuzz-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
      throw std::runtime_error("no folder for files");
    path = name;
  }
  ~Folder()
  {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  Folder(const Folder &)            = delete;
  Folder &operator=(const Folder &) = delete;

  fs::path path;
};

/** Reads and stops there. */
class OnlyReading : public RunMemory
{
public:
  struct Done
  {
  };
  explicit OnlyReading(Checkpoints &checkpoints)
      : checkpoints(checkpoints)
  {
  }
  bool take_up(const RunState &state) override
  {
    checkpoints.take_up(state);
    throw Done();
  }

private:
  Checkpoints &checkpoints;
};

/** Runs a scene, or goes on with an earlier run until it would compute. */
void run_scene(SceneInput &input, const fs::path &directory, EarlierRun *earlier)
{
  std::unique_ptr<SurfaceScene> scene = input.file().read();
  const std::string used_text         = input.file().used_text();
  if (earlier != nullptr)
    earlier->check_scene(used_text);
  if (!scene->load.parameter.empty())
    scene = scene_at_start_of_load(input.file(), scene->load);
  Timing timing;
  const Communicator communicator;
  SurfaceModel model(*scene, communicator, timing);
  RunOutput output(true, directory, earlier != nullptr ? earlier->directory() : "", *scene, Verbosity::quiet, timing);
  CheckpointParameters every_step;
  every_step.every = 1;
  every_step.keep  = 1;
  Checkpoints checkpoints(input.application().name, used_text, every_step, directory, output, earlier);
  const SolutionSink nothing = [](const SurfaceModel &, int, double) {};
  Observer nobody;
  const auto run_with = [&](RunMemory &memory)
  {
    return scene->motion() != nullptr ? run_in_time(*scene, model, nobody, nothing, memory)
                                      : solve_scene(input.file(), *scene, model, nobody, nothing, memory);
  };
  if (earlier == nullptr)
  {
    if (run_with(checkpoints).status != RunStatus::converged)
      throw std::logic_error("a small scene has no solution");
    return;
  }
  OnlyReading memory(checkpoints);
  try
  {
    run_with(memory);
  }
  catch (const OnlyReading::Done &)
  {
  }
}

/** The contents of true checkpoints, one of each small scene. */
const std::vector<std::string> &true_contents()
{
  static const std::vector<std::string> all = []
  {
    std::vector<std::string> contents;
    for (const std::string &scene : small_scenes)
    {
      const Folder folder;
      SceneInput input = input_of(scene);
      run_scene(input, folder.path, nullptr);
      contents.push_back(read_last_checkpoint(folder.path).content);
    }
    return contents;
  }();
  return all;
}

/** Changes bytes of a text: each change is two bytes of place, one of length, and the new bytes. */
std::string with_changes(std::string content, const std::string &changes)
{
  const auto byte = [&](const std::size_t i) { return static_cast<unsigned char>(changes[i]); };
  for (std::size_t i = 0; i + 3 < changes.size();)
  {
    const std::size_t place = (256u * byte(i) + byte(i + 1)) % content.size();
    const std::size_t n = std::min({std::size_t{byte(i + 2)} % 16u, content.size() - place, changes.size() - i - 3});
    content.replace(place, n, changes, i + 3, n);
    i += 3 + n;
  }
  return content;
}
} // namespace

/** The first byte says what the rest is: changes to the checkpoint of a small scene, or a file as a whole. */
void read_checkpoint(const std::string &input)
{
  int argc    = 0;
  char **argv = nullptr;
  static const MpiSession session(argc, argv);
  if (input.empty())
    return;
  const std::size_t chosen = static_cast<unsigned char>(input[0]) % (small_scenes.size() + 1);
  const Folder folder;
  const bool is_file = chosen == small_scenes.size();
  CheckpointFiles(folder.path, 1).write(1, is_file ? "" : with_changes(true_contents()[chosen], input.substr(1)));
  if (is_file)
    std::ofstream(folder.path / "checkpoint" / "step_000001.bin", std::ios::binary) << input.substr(1);

  SceneInput scene = input_of(small_scenes[is_file ? 0 : chosen]);
  try
  {
    EarlierRun earlier(scene.application().name, folder.path);
    run_scene(scene, folder.path, &earlier);
  }
  catch (const UserError &refusal)
  {
    if (!is_file && input.size() == 1)
      throw std::logic_error(std::string("a true checkpoint is refused: ") + refusal.what());
    throw;
  }
}
} // namespace pellicle::fuzz

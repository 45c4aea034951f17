// SPDX-License-Identifier: LGPL-2.1-or-later
#include "level.h"

#include <utility>

namespace pellicle
{
namespace
{
constexpr const char *origin = "Accuracy", *drag = "Newton/Initial drag";

/** The scene as the file stands, on the level's mesh; no scene file says which of its cells are cut further. */
std::unique_ptr<SurfaceScene> on_mesh(std::unique_ptr<SurfaceScene> scene, const LevelMesh &mesh)
{
  scene->mesh.cut = mesh.cut;
  return scene;
}
} // namespace

LevelMaker::LevelMaker(const RunContext &context, const SurfaceScene &first)
    : context(context)
    , first(first)
    , start(context.file)
{
}

SurfaceSceneFile LevelMaker::with_mesh(const SurfaceSceneFile &file, const LevelMesh &mesh) const
{
  SurfaceSceneFile changed = file;
  for (const auto &[path, value] : first.level_settings(mesh))
    changed.set(path, value, origin);
  return changed;
}

std::unique_ptr<Level> LevelMaker::at_start(const LevelMesh &mesh, const SurfaceSceneFile &file) const
{
  auto level   = std::make_unique<Level>(Level{mesh, file, nullptr, nullptr});
  level->scene = on_mesh(
      first.load.parameter.empty() ? level->file.read() : scene_at_start_of_load(level->file, first.load), mesh);
  level->model = std::make_unique<SurfaceModel>(*level->scene, context.communicator, context.timing);
  return level;
}

bool LevelMaker::has_load_path() const
{
  return !first.load.parameter.empty() || !first.load_stages().empty();
}

std::unique_ptr<Level> LevelMaker::walked(const LevelMesh &mesh) const
{
  std::unique_ptr<Level> level = at_start(mesh, with_mesh(start, mesh));
  RunMemory nothing_to_keep;
  level->result = solve_scene(level->file, *level->scene, *level->model, level->record, nowhere, nothing_to_keep);
  return level;
}

std::unique_ptr<Level> LevelMaker::continued(const LevelMesh &mesh, const Level &solved) const
{
  if (solved.model->mesh().cell_places.empty())
    return nullptr;
  SurfaceSceneFile file = with_mesh(start, mesh);
  file.set(drag, 0., origin);
  std::unique_ptr<Level> level = at_start(mesh, file);
  if (has_load_path())
  {
    SurfaceSceneFile at_end = with_mesh(solved.file, mesh);
    at_end.set(drag, 0., origin);
    auto moved = std::make_unique<Level>(Level{mesh, at_end, on_mesh(at_end.read(), mesh), std::move(level->model)});
    moved->model->update(*moved->scene);
    level = std::move(moved);
  }
  return level->model->start_from(*solved.model) ? std::move(level) : nullptr;
}

void LevelMaker::solve(Level &level) const
{
  level.result = solve_here(level.file, *level.scene, *level.model, level.record, nowhere);
  if (level.is_solved() || first.newton.initial_drag == 0.)
    return;
  level.file.set(drag, first.newton.initial_drag, origin);
  level.scene = on_mesh(level.file.read(), level.mesh);
  level.model->update(*level.scene);
  level.record = {};
  level.result = solve_here(level.file, *level.scene, *level.model, level.record, nowhere);
}
} // namespace pellicle

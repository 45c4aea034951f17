// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/apps/surface_run.h>
#include <pellicle/base/exact_text.h>
#include <pellicle/base/expression.h>
#include <pellicle/base/scene_file.h>

#include <algorithm>
#include <filesystem>

namespace pellicle
{
namespace
{
// Eigenvalues of the second variation: energy over the square of the L2 norm of a displacement, or of a change of
// directors.
constexpr Dimension per_displacement{1, -4}, per_director{1, -2};

SceneEntries entries_of(const CommandLine &command_line, const std::string &earlier_text)
{
  SceneEntries entries = command_line.scene_file.empty() ? scan_scene(earlier_text, "scene of the checkpoint")
                                                         : read_scene_file(command_line.scene_file);
  apply_overrides(entries, command_line.overrides);
  for (const SceneEntry &entry : entries.entries)
    if (entry.path() == "Mesh/File" && !entry.value.empty() && std::filesystem::path(entry.value).is_relative())
    {
      const std::filesystem::path folder = std::filesystem::absolute(command_line.scene_file).parent_path();
      set_entry(entries, "Mesh/File", (folder / entry.value).lexically_normal().string(), entry.origin);
      break;
    }
  return entries;
}

std::vector<std::string> sections_of_others(const EffectLibrary &library, const std::vector<std::string> &effects)
{
  std::vector<std::string> sections;
  for (const std::string &name : library.names())
    if (std::find(effects.begin(), effects.end(), name) == effects.end())
      sections.push_back(section_name(name));
  return sections;
}
/** Calls f and puts "Load/Name = value: " before the message of a UserError. */
template <typename F>
double number_of_load(const std::string &name, const std::string &value, const F &f)
{
  try
  {
    return f();
  }
  catch (const UserError &error)
  {
    throw UserError("Load/" + name + " = " + value + ": " + error.what());
  }
}
} // namespace

SurfaceSceneFile::SurfaceSceneFile(const SurfaceApplication &application, const CommandLine &command_line,
                                   const std::string &earlier_text)
    : application(application)
    , scene(application.name, entries_of(command_line, earlier_text))
    , effects(scene.effects(application.default_effects, application.library.names()))
    , analyses(scene.analyses({}, application.analysis_names()))
{
}

std::unique_ptr<SurfaceScene> SurfaceSceneFile::read()
{
  std::unique_ptr<SurfaceScene> parameters = application.scene(effects, analyses);
  scene.read(parameters->sections(), sections_of_others(application.library, effects));
  parameters->check();
  return parameters;
}

void SurfaceSceneFile::set(const std::string &path, const double value, const std::string &origin)
{
  scene.set(path, exact_text(value), origin);
}

void SurfaceSceneFile::set_text(const std::string &path, const std::string &value, const std::string &origin)
{
  scene.set(path, value, origin);
}

double SurfaceSceneFile::number(const std::string &path) const
{
  return evaluate_number(scene.value(path));
}

std::string SurfaceSceneFile::used_text()
{
  return scene.used_text(application.scene(effects, analyses)->sections(), effects, analyses);
}

std::unique_ptr<SurfaceScene> scene_at_start_of_load(SurfaceSceneFile &file, const LoadParameters &load)
{
  const double own = number_of_load("Parameter", load.parameter, [&] { return file.number(load.parameter); });
  const double from =
      load.from.empty() ? own : number_of_load("From", load.from, [&] { return evaluate_number(load.from); });
  const double to = load.to.empty() ? own : number_of_load("To", load.to, [&] { return evaluate_number(load.to); });
  file.set(load.parameter, to, "Load/To");
  file.read();
  file.set(load.parameter, from, "Load/From");
  std::unique_ptr<SurfaceScene> scene = file.read();
  scene->load.to                      = exact_text(to);
  return scene;
}

std::string commented_scene_of(const SurfaceApplication &application)
{
  const std::unique_ptr<SurfaceScene> listed = application.scene(application.default_effects, {});
  SceneDescription description;
  description.application    = application.name;
  description.effects        = application.default_effects;
  description.known_effects  = application.library.names();
  description.known_analyses = application.analysis_names();
  description.sections       = listed->sections();
  std::vector<std::unique_ptr<Effect>> others;
  for (const std::string &name : application.library.names())
    if (!listed->has_effect(name))
    {
      others.push_back(application.library.create(name));
      ParameterSection section(section_name(name));
      others.back()->bind(section);
      description.unlisted.push_back({name, section});
    }
  return commented_scene(description);
}

std::size_t n_entries(const SparseMatrix &matrix)
{
  const std::size_t stored = matrix.columns.size(), diagonal = static_cast<std::size_t>(matrix.size);
  return matrix.symmetry == MatrixSymmetry::symmetric ? 2 * stored - diagonal : stored;
}

void describe(const SurfaceScene &scene, const SurfaceModel &model, RunResult &result)
{
  for (const auto &effect : scene.effects)
    result.effects.push_back(effect->name());
  result.analyses = scene.analyses;
  result.n_cells  = model.n_cells();
  result.degree   = model.mesh().degree;
  for (const auto &[name, n] : model.unknown_counts())
  {
    result.unknowns.blocks.emplace_back(name, n);
    result.unknowns.total += n;
  }
  if (!model.unknown_counts().empty())
    result.unknowns.matrix_entries = n_entries(model.equilibrium().matrix());
  result.loops         = cell_loops(model.equilibrium().discretization(), model.equilibrium().potentials());
  result.linear_solver = model.linear_solver();
  if (const std::optional<Stability> &stability = model.stability())
  {
    result.stability                       = StabilityCounts{};
    result.stability->negative_eigenvalues = stability->negative_eigenvalues;
    for (const double eigenvalue : stability->lowest)
      result.stability->lowest.push_back(eigenvalue *
                                         model.scales().of(stability->field == 0 ? per_displacement : per_director));
  }
}
} // namespace pellicle

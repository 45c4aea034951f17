// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/apps/phase_diagram.h>
#include <pellicle/base/exact_text.h>
#include <pellicle/models/jump_detector.h>
#include <pellicle/models/vesicle_scene.h>
#include <pellicle/potentials/energies/helfrich_bending.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace pellicle
{
namespace
{
constexpr const char *reduced_volume = "Vesicle/Reduced volume";
constexpr double smallest_step       = 1. / 16.; // of the way to the next volume, before it counts as out of reach

/** Where the start shape lies near the branch of its name. */
double good_start(const std::string &branch)
{
  static const std::map<std::string, double> volumes{{"prolate", 0.9}, {"oblate", 0.9}, {"stomatocyte", 0.62}};
  return volumes.at(branch);
}

/** One branch: its model and the rows of its states. */
class BranchOfDiagram
{
public:
  BranchOfDiagram(SurfaceSceneFile &file, const std::string &name, SurfaceModel &model, Observer &observer,
                  const SolutionSink &sink, RunResult &result)
      : file(file)
      , name(name)
      , model(model)
      , observer(observer)
      , sink(sink)
      , result(result)
  {
  }

  bool solve_at(const double volume)
  {
    file.set(reduced_volume, volume, "Phase diagram");
    const std::unique_ptr<SurfaceScene> scene = file.read();
    const SurfaceState before                 = model.equilibrium().state();
    model.update(*scene);
    const StepResult outcome = model.solve(result.newton.steps, observer);
    result.newton.iterations += outcome.iterations;
    result.newton.rejected += outcome.rejected;
    if (!outcome.converged)
      return false;
    result.newton.final_relative_residual = outcome.relative_residual;
    if (jumps.has_jumped(model, *scene, volume))
    {
      model.go_to(before);
      return false;
    }
    jumps.accept(model, *scene, volume);
    reached = volume;
    return true;
  }

  /** Back to the first state of the branch. */
  void go_back(const SurfaceState &state, const double volume)
  {
    file.set(reduced_volume, volume, "Phase diagram");
    const std::unique_ptr<SurfaceScene> scene = file.read();
    model.update(*scene);
    model.go_to(state);
    jumps.accept(model, *scene, volume);
    reached = volume;
  }

  /** From the present state to the next volume, in parts if need be. */
  bool walk(const double from, const double to)
  {
    LoadParameters steps;
    steps.steps         = 1;
    steps.smallest_step = smallest_step;
    return walk_load(steps, [&](const double t) { return t == 0. || solve_at(from + t * (to - from)); }) == 1.;
  }

  void add_row(std::vector<TableRow> &rows, const bool is_fold, const std::optional<int> negative)
  {
    TableRow row{"phase_diagram", {{"branch", name}, {"is_fold", is_fold ? "1" : "0"}}};
    row.fields.emplace_back("negative_eigenvalues", negative ? std::to_string(*negative) : "");
    const std::unique_ptr<SurfaceScene> scene = file.read();
    row.fields.emplace_back("bending_rigidity",
                            exact_text(scene->find<HelfrichBendingEffect>()->parameters.bending_rigidity));
    result.quantities = model.quantities();
    double volume     = 0.;
    for (const auto &[quantity, value] : result.quantities)
    {
      row.fields.emplace_back(quantity, exact_text(value));
      if (quantity == "reduced_volume")
        volume = value;
    }
    observer.on_message(name + ": v = " + exact_text(volume) + (is_fold ? " (fold)" : ""));
    sink(model, result.newton.steps++, volume);
    rows.push_back(std::move(row));
  }
  void add_row(std::vector<TableRow> &rows)
  {
    add_row(rows, false,
            model.stability() ? std::optional<int>(model.stability()->negative_eigenvalues) : std::nullopt);
  }

  /** Along the list of volumes, and where it gets no further along the arc. */
  std::vector<TableRow> go(double from, const std::vector<double> &volumes, BranchParameters arc)
  {
    std::vector<TableRow> rows;
    for (const double volume : volumes)
    {
      if (walk(from, volume))
      {
        add_row(rows);
        from = volume;
        continue;
      }
      if (arc.steps.max_points == 0)
        break;
      from          = reached; // parts of the way
      arc.parameter = reduced_volume;
      arc.direction = volume > from ? "increasing" : "decreasing";
      arc.scale     = 1.;
      go_back(model.equilibrium().state(), from);
      const auto scene_at = [&](const double v)
      {
        file.set(reduced_volume, v, "Phase diagram");
        return file.read();
      };
      bool is_start = true;
      const ContinuationResult outcome =
          model.follow_branch(arc, from, scene_at, observer,
                              [&](const SurfaceModel::PointOnBranch &here)
                              {
                                if (!is_start)
                                  add_row(rows, here.point.is_fold, here.negative_eigenvalues);
                                is_start = false;
                              });
      result.newton.iterations += outcome.iterations;
      break;
    }
    return rows;
  }

private:
  SurfaceSceneFile &file;
  const std::string name;
  SurfaceModel &model;
  Observer &observer;
  const SolutionSink &sink;
  RunResult &result;
  JumpDetector jumps{reduced_volume};
  double reached = 0.; ///< volume of the last state that was found
};
} // namespace

std::unique_ptr<SurfaceModel> run_phase_diagram(const RunContext &context, const SurfaceScene &scene, RunResult &result)
{
  SurfaceSceneFile &file                = context.file;
  const PhaseDiagramParameters &diagram = dynamic_cast<const VesicleScene &>(scene).phase_diagram;
  std::vector<double> volumes           = diagram.reduced_volumes;
  std::sort(volumes.begin(), volumes.end());
  std::unique_ptr<SurfaceModel> model;
  std::string missing;
  for (const std::string &name : diagram.branch_names())
  {
    const auto start = std::min_element(volumes.begin(), volumes.end(),
                                        [&](const double a, const double b)
                                        { return std::abs(a - good_start(name)) < std::abs(b - good_start(name)); });
    file.set_text("Vesicle/Start shape", name, "Phase diagram/Branches");
    file.set(reduced_volume, *start, "Phase diagram/Reduced volumes");
    model = std::make_unique<SurfaceModel>(*file.read(), context.communicator, context.timing);
    BranchOfDiagram branch(file, name, *model, context.observer, context.sink, result);
    if (!branch.solve_at(*start))
    {
      missing += (missing.empty() ? "" : ", ") + name;
      continue;
    }
    BranchParameters arc = scene.branch;
    arc.steps.max_points = diagram.fold_points;

    std::vector<TableRow> rows;
    branch.add_row(rows);
    const SurfaceState at_start = model->equilibrium().state();
    std::vector<TableRow> down  = branch.go(*start, {std::make_reverse_iterator(start), volumes.rend()}, arc);
    branch.go_back(at_start, *start);
    std::vector<TableRow> up = branch.go(*start, {start + 1, volumes.end()}, arc);

    std::reverse(down.begin(), down.end());
    for (std::vector<TableRow> *part : {&down, &rows, &up})
      for (const TableRow &row : *part)
        context.observer.on_row(row);
  }
  result.status = missing.empty() ? RunStatus::converged : RunStatus::failed;
  if (!missing.empty())
    result.message = "No equilibrium was found to start these branches from: " + missing +
                     ". A finer mesh, or reduced volumes nearer to 0.9 (0.62 for stomatocytes) may help.";
  return model;
}
} // namespace pellicle

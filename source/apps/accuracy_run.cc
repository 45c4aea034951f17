// SPDX-License-Identifier: LGPL-2.1-or-later
#include "level.h"
#include "level_table.h"

#include <pellicle/apps/accuracy_run.h>
#include <pellicle/base/exact_text.h>
#include <pellicle/models/error_estimate.h>
#include <pellicle/models/headline.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace pellicle
{
namespace
{
/** Of all errors, in the cells that an adaptive run cuts together. */
constexpr double share_of_worst = 0.7;
constexpr double longest_step   = 1e-2; ///< internal units: beyond it one step of Newton's method is not believed

class AccuracyRun
{
public:
  AccuracyRun(const RunContext &context, const SurfaceScene &first)
      : context(context)
      , parameters(first.accuracy)
      , own{static_cast<unsigned int>(first.mesh.degree), static_cast<unsigned int>(first.mesh.refinements)}
      , range(first.level_range())
      , quantity(first.headline_quantity())
      , maker(context, first)
      , table(context, quantity, smallest_headline(first))
  {
  }

  std::unique_ptr<SurfaceModel> run(RunResult &result)
  {
    std::unique_ptr<Level> level = coarsest();
    if (level->is_solved())
    {
      table.add(record_of(*level));
      while (std::unique_ptr<Level> next = after(*level))
      {
        level = std::move(next);
        if (is_done())
          break;
      }
    }
    return finish(*level, result);
  }

private:
  /** The first mesh of the range or, where it leads to no equilibrium, the scene's own. */
  std::unique_ptr<Level> coarsest() const
  {
    std::unique_ptr<Level> level = maker.walked(range.first);
    const bool is_own            = own.degree == range.first.degree && own.refinements == range.first.refinements;
    return level->is_solved() || is_own ? std::move(level) : maker.walked(own);
  }

  LevelRecord record_of(const Level &level) const
  {
    LevelRecord record{
        level.mesh, level.result.n_cells, level.result.unknowns.total, headline_of(*level.model, quantity), {}};
    const SurfaceDiscretization &mesh = level.model->mesh();
    if (parameters.refinement == "adaptive" && !mesh.cell_places.empty() && mesh.bulks.empty())
      record.worst = cells_with_most(share_of_worst, error_indicators(level.model->equilibrium()), mesh.cell_places);
    return record;
  }

  double absolute_target() const { return std::max(parameters.target, LevelTable::round_off) * table.unit_of_errors(); }
  bool is_met() const { return table.relative_error() <= parameters.target; }
  bool is_done() const { return is_met() || table.relative_error() <= LevelTable::round_off || !reason.empty(); }

  /** None, and why, where meshes or limits end. */
  std::optional<LevelMesh> next_mesh()
  {
    const std::optional<LevelMesh> mesh = next_level(table.levels(), range);
    if (!mesh)
      reason = "no finer mesh is offered";
    else if (static_cast<int>(table.levels().size()) >= parameters.max_levels)
      reason = "Accuracy/Maximum levels = " + std::to_string(parameters.max_levels) + " is reached: raise it";
    else if (expected_unknowns(table.levels().back(), *mesh, range) > parameters.max_unknowns)
      reason =
          "a finer mesh would have more than Accuracy/Maximum unknowns = " + std::to_string(parameters.max_unknowns) +
          ": raise it if there is memory";
    return reason.empty() ? mesh : std::nullopt;
  }

  /** The next level, solved and in the table; null where the one before is the last one. */
  std::unique_ptr<Level> after(const Level &level)
  {
    const std::optional<LevelMesh> mesh = next_mesh();
    if (!mesh)
    {
      table.set_error(expected_error(table.errors()));
      return nullptr;
    }
    std::unique_ptr<Level> next = maker.continued(*mesh, level);
    const bool is_solved        = next ? is_improved(*next) : is_solved_anew(*mesh, next);
    return is_solved ? std::move(next) : nullptr;
  }

  /**
   * On a mesh to which the level's state was carried over. One step of Newton's method there tells whether the level's
   * error is small enough; the estimate then is off by the square of the step's length. If it is not, or if the step is
   * long, the new level is solved, and what it is tells the error.
   */
  bool is_improved(Level &next)
  {
    const double seen   = headline_near(*next.model, quantity);
    const double length = length_of_step(next);
    double estimate     = length <= longest_step ? estimate_of(next, seen) : std::numeric_limits<double>::infinity();
    if (!(estimate <= absolute_target()))
    {
      if (!is_solved(next))
      {
        table.set_error(std::isfinite(length) ? estimate_of(next, seen) : expected_error(table.errors()));
        return false;
      }
      estimate = estimate_of(next, seen);
    }
    table.set_error(estimate);
    if (is_done())
      return false;
    table.add(record_of(next));
    return true;
  }

  /** Of the level before: from its value, that of its state on the next mesh, and that of the next one's state. Where
   * it was made by cutting some cells the errors of the others remain, and the next cut need not find them: then half
   * of the change that it has brought counts as well. */
  double estimate_of(const Level &next, const double seen)
  {
    const std::vector<LevelRecord> &levels = table.levels();
    const LevelRecord &last                = levels.back();
    richer.resize(table.errors().size());
    richer.push_back({seen - last.value, headline_near(*next.model, quantity) - seen});
    const double estimate = estimate_from(richer);
    if (levels.size() < 2 || last.mesh.cut.size() == levels[levels.size() - 2].mesh.cut.size())
      return estimate;
    return std::max(estimate, 0.5 * std::abs(last.value - levels[levels.size() - 2].value));
  }

  /** Takes a step of Newton's method; the largest change of a coordinate, internal units. Infinite: none was taken. */
  static double length_of_step(Level &level)
  {
    const NodalVectors before = level.model->equilibrium().state().fields[0];
    if (!level.model->take_one_step())
      return std::numeric_limits<double>::infinity();
    const NodalVectors &after = level.model->equilibrium().state().fields[0];
    double largest            = 0.;
    for (std::size_t i = 0; i < before.size(); ++i)
      largest = std::max(largest, std::abs(after[i] - before[i]));
    return largest;
  }

  bool is_solved(Level &level)
  {
    maker.solve(level);
    if (!level.is_solved())
      reason = "no equilibrium was found on a finer mesh: " + level.result.message;
    return level.is_solved();
  }

  /** On a mesh that has nothing in common with the ones before, or where the load path decides: what errors there are
   * follows from the sequence of values. */
  bool is_solved_anew(const LevelMesh &mesh, std::unique_ptr<Level> &next)
  {
    next = maker.walked(mesh);
    if (!next->is_solved())
    {
      reason = "no equilibrium was found on a finer mesh: " + next->result.message;
      table.set_error(expected_error(table.errors()));
      return false;
    }
    const LevelRecord record   = record_of(*next);
    std::vector<double> values = table.values();
    values.push_back(record.value);
    table.set_error(estimates_of_sequence(values).back());
    const std::vector<double> errors = table.errors();
    table.add(record);
    if (errors.size() > 1 && table.relative(expected_error(errors)) <= parameters.target)
      table.set_error(expected_error(errors));
    return true;
  }

  std::unique_ptr<SurfaceModel> finish(Level &level, RunResult &result) const
  {
    level.record.replay(context.observer);
    context.sink(*level.model, std::max(0, level.result.newton.steps - 1), 0.);
    result = level.result;
    if (std::isfinite(table.relative_error()))
      result.quantities.emplace_back("estimated_relative_error", table.relative_error());
    if (level.is_solved() && !is_met())
    {
      result.status  = RunStatus::target_not_met;
      result.message = message(result);
    }
    return std::move(level.model);
  }

  std::string message(const RunResult &result) const
  {
    const std::string error =
        std::isfinite(table.relative_error())
            ? "the estimated relative error of " + quantity + " is " + exact_text(table.relative_error())
            : "the error of " + quantity + " could not be estimated";
    const std::string why =
        reason.empty() ? "smaller differences between levels are round-off; take a larger Target" : reason;
    return "Accuracy/Target = " + exact_text(parameters.target) + " was not met: " + error + " on " +
           std::to_string(result.n_cells) + " cells of degree " + std::to_string(result.degree) + " (" + why + ").";
  }

  const RunContext &context;
  const AccuracyParameters parameters;
  const LevelMesh own;
  const LevelRange range;
  const std::string quantity;
  const LevelMaker maker;
  LevelTable table;
  std::vector<RicherSpace> richer; ///< of the levels with an estimate
  std::string reason;              ///< why it ends without the target
};
} // namespace

std::unique_ptr<SurfaceModel> run_to_accuracy(const RunContext &context, const SurfaceScene &scene, RunResult &result)
{
  return AccuracyRun(context, scene).run(result);
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/apps/branch_run.h>
#include <pellicle/base/exact_text.h>

namespace pellicle
{
void run_branch(SurfaceSceneFile &file, const BranchParameters &branch, SurfaceModel &model, Observer &observer,
                const SolutionSink &sink, RunResult &result, std::optional<BranchRecord> &record,
                const std::function<void()> &after_point)
{
  const std::optional<BranchRecord> earlier = record;
  int points                                = earlier ? earlier->points : 0;
  const auto on_point                       = [&](const SurfaceModel::PointOnBranch &here)
  {
    TableRow row{"branch", {{"point", std::to_string(points)}}};
    row.fields.emplace_back("arc_length", exact_text(here.point.arc_length));
    row.fields.emplace_back(branch.parameter, exact_text(here.point.parameter));
    row.fields.emplace_back("is_fold", here.point.is_fold ? "1" : "0");
    row.fields.emplace_back("negative_eigenvalues",
                            here.negative_eigenvalues ? std::to_string(*here.negative_eigenvalues) : "");
    result.quantities = model.quantities();
    for (const auto &[name, value] : result.quantities)
      row.fields.emplace_back(name, exact_text(value));
    observer.on_row(row);
    observer.on_message("point " + std::to_string(points) + ": " + branch.parameter + " = " +
                        exact_text(here.point.parameter) + (here.point.is_fold ? " (fold)" : ""));
    sink(model, result.newton.steps + points, here.point.parameter);
    ++points;
  };
  const auto scene_at = [&](const double value)
  {
    file.set(branch.parameter, value, "Continuation");
    return file.read();
  };

  SurfaceModel::BranchMemory memory;
  memory.from        = earlier ? &earlier->progress : nullptr;
  memory.after_point = [&](const SurfaceModel::BranchProgress &progress)
  {
    record = {points, progress};
    after_point();
  };
  const ContinuationResult outcome =
      model.follow_branch(branch, file.number(branch.parameter), scene_at, observer, on_point, memory);
  result.newton.iterations += outcome.iterations;
  result.newton.rejected += outcome.rejected_steps;
  if (outcome.end == ContinuationEnd::failed)
  {
    result.status  = RunStatus::failed;
    result.message = "The branch could be followed over " + std::to_string(outcome.points) + " points only (" +
                     outcome.failure + "). A finer mesh or a smaller Continuation/Smallest step may help.";
  }
}
} // namespace pellicle

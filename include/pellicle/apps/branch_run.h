// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/apps/surface_run.h>

#include <functional>
#include <optional>

namespace pellicle
{
/** How far run_branch() has come. */
struct BranchRecord
{
  int points = 0; ///< in the table
  SurfaceModel::BranchProgress progress;

  void exchange(Archive &archive) { archive | points | progress; }
};

/**
 * Follows a branch of equilibria from the model's present state (section Continuation). Each point is a row of
 * `branch.csv`: point, arc_length, the parameter under its name, is_fold, negative_eigenvalues, the quantities. Adds
 * to the result; a branch that could not be followed to its end makes it failed, with what was found in the files.
 *
 * @param record  where an earlier run stopped, to go on from there; holds how far this one has come when `after_point`
 *                is called.
 */
void run_branch(SurfaceSceneFile &file, const BranchParameters &branch, SurfaceModel &model, Observer &observer,
                const SolutionSink &sink, RunResult &result, std::optional<BranchRecord> &record,
                const std::function<void()> &after_point);
} // namespace pellicle

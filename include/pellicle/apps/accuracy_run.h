// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/apps/surface_run.h>

#include <memory>

namespace pellicle
{
/**
 * Solves a scene on finer and finer meshes until the estimated relative error of its headline quantity is below
 * Accuracy/Target. The coarsest level is solved as the scene says, along its load path; the next ones start from the
 * state before, at the end of the path, where that can be carried over (SurfaceModel::start_from()), and else anew.
 *
 * Each level is a row of `accuracy.csv` and a line for the user: level, degree, cells, unknowns, seconds since the
 * program began, the headline quantity, estimated_relative_error. The last level's iterations, steps and solution are
 * reported as those of the run. A target that is not reached makes the result target_not_met, with the best level.
 *
 * @param context  its file stands at the start of section Load.
 * Returns the model of the last level. Throws UserError for a scene that cannot be built.
 */
std::unique_ptr<SurfaceModel> run_to_accuracy(const RunContext &context, const SurfaceScene &scene, RunResult &result);
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/apps/surface_run.h>

namespace pellicle
{
/**
 * Follows a branch of equilibria from the model's present state (section Continuation). Each point is a row of
 * `branch.csv`: point, arc_length, the parameter under its name, is_fold, negative_eigenvalues, the quantities. Adds
 * to the result; a branch that could not be followed to its end makes it failed, with what was found in the files.
 */
void run_branch(SurfaceSceneFile &file, const BranchParameters &branch, SurfaceModel &model, Observer &observer,
                const SolutionSink &sink, RunResult &result);
} // namespace pellicle

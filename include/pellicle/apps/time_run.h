// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/apps/surface_run.h>

namespace pellicle
{
/**
 * Moves a scene in time as its section Time says. history.csv has a row at time 0 and one after each Time/Step, with
 * the column `time`. Returns everything that summary.json says but the seconds of output; never throws for a motion
 * that failed.
 */
RunResult run_in_time(const SurfaceScene &scene, SurfaceModel &model, Observer &observer, const SolutionSink &sink,
                      RunMemory &memory);
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/apps/surface_run.h>

#include <memory>

namespace pellicle
{
/**
 * The analysis "phase diagram": for each branch the equilibria at a list of reduced volumes, and the arc through the
 * fold where a branch ends before the list does. Each state is a row of `phase_diagram.csv`: branch, reduced_volume,
 * is_fold, negative_eigenvalues, bending_rigidity and the quantities, in the order along the branch.
 * `contrib/phase_diagram/plot.py` draws it and finds the crossings.
 *
 * Returns the model of the last branch, at its last state.
 */
std::unique_ptr<SurfaceModel> run_phase_diagram(const RunContext &context, const SurfaceScene &scene,
                                                RunResult &result);
} // namespace pellicle

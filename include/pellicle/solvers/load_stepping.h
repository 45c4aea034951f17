// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/parameters.h>

#include <functional>
#include <string>

namespace pellicle
{
/** Section "Load": a parameter of the scene that is changed in steps; steps of the stages of a scene's own load path.
 */
struct LoadParameters
{
  std::string parameter; ///< "Section/Name"; empty: no load stepping
  std::string from;      ///< number or expression; empty: the scene's own value of the parameter
  std::string to;
  int steps            = 10;
  double smallest_step = 1e-3;

  void bind(ParameterSection &section);
};

/** Where a walk is after a step, and how long the next one is. */
struct LoadPosition
{
  double t         = -1.; ///< negative: not even t = 0 is done
  double next_step = 0.;
};

/**
 * Walks t from 0 to 1 in steps of 1/steps at first: a step that fails is halved and tried again, a step that succeeds
 * lets the next one grow by half, up to four times the first. The first call is attempt(0).
 *
 * @param attempt  solves at t; returns whether it succeeded. After a failure it must have restored the last state.
 * @return         1 if the end was reached, else the last t that succeeded (negative if not even t = 0).
 * @param from     where an earlier walk stopped, to go on from there.
 * @param after_step  called after every success.
 */
double walk_load(const LoadParameters &parameters, const std::function<bool(double t)> &attempt, LoadPosition from = {},
                 const std::function<void(const LoadPosition &)> &after_step = {});
} // namespace pellicle

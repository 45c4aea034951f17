// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/parameters.h>

#include <functional>
#include <string>

namespace pellicle
{
/** Section "Time". */
struct TimeParameters
{
  double end_time           = 0.; ///< 0: statics
  double step               = 0.; ///< 0: a hundredth of the end time
  std::string integrator    = "minimising";
  double relative_tolerance = 1e-6;
  double absolute_tolerance = 1e-8;
  double energy_tolerance   = 1e-4;
  int output_every          = 1;

  void bind(ParameterSection &section);
  /** Throws UserError if the numbers contradict each other. */
  void check() const;
  /** Distance of the times at which the state is reported. */
  double interval() const { return step > 0. ? step : 0.01 * end_time; }
  /** Number of intervals up to the end; the last one may be shorter. */
  int n_intervals() const;
  /** The time at the end of an interval, counted from 1; exact for the last one. */
  double time_after(int interval) const;
};

/**
 * Walks from one time to another, at first in one step. A step that fails is halved and tried again, and after a
 * success the next one may be twice as long.
 *
 * @param attempt  makes a step of that length; returns whether it succeeded. After a failure it must have restored the
 * last state.
 * @return         whether the end was reached with steps of at least `smallest`.
 */
bool walk_time(double from, double to, double smallest, const std::function<bool(double length)> &attempt);
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exact_text.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/solvers/time_stepping.h>

#include <algorithm>
#include <cmath>

namespace pellicle
{
namespace
{
constexpr double most_intervals = 1e6;
} // namespace

void TimeParameters::bind(ParameterSection &section)
{
  section.number("End time", end_time, Range::non_negative(), dimensions::time,
                 "Time up to which the scene moves, from the start at time 0. 0: no time, the equilibrium is looked "
                 "for.");
  section.number("Step", step, Range::non_negative(), dimensions::time,
                 "Length of a minimising step, and distance of the times at which the state is reported. 0: End "
                 "time/100.");
  section.choice(
      "Integrator", integrator, {"minimising", "ida"},
      "minimising: each step makes E + dt D((y - y_old)/dt) a minimum; of first order, and the energy law "
      "E' + dt D <= E is checked at each step. ida: variable order and step (SUNDIALS), for motions with the "
      "surface held and a finite tilt modulus.");
  section.number("Relative tolerance", relative_tolerance, Range::between(1e-12, 1e-1), dimensions::none,
                 "Of the local error, for ida.");
  section.number("Absolute tolerance", absolute_tolerance, Range::between(1e-14, 1e-1), dimensions::none,
                 "Of the local error of components of directors, for ida.");
  section.number("Energy tolerance", energy_tolerance, Range::positive(), dimensions::none,
                 "A run with ida warns if energy_balance_error is larger.");
  section.integer("Output every", output_every, 1, 1000000,
                  "Write solution_NNNN.vtu after each so many reported times.");
}

void TimeParameters::check() const
{
  if (end_time == 0. && step > 0.)
    throw UserError("Time/Step = " + exact_text(step) + ", but Time/End time is 0: give the time at which to stop.");
  if (step > end_time)
    throw UserError("Time/Step = " + exact_text(step) +
                    " is longer than the whole motion, Time/End time = " + exact_text(end_time) + ".");
  if (end_time > most_intervals * interval())
    throw UserError("Time/Step = " + exact_text(step) +
                    " makes more than a million steps up to Time/End time = " + exact_text(end_time) + ".");
}

int TimeParameters::n_intervals() const
{
  // No sliver at the end for the sake of round-off.
  return end_time == 0. ? 0 : std::max(1, static_cast<int>(std::ceil(end_time / interval() - 1e-9)));
}

double TimeParameters::time_after(const int n) const
{
  return n == n_intervals() ? end_time : n * interval();
}

bool walk_time(const double from, const double to, const double smallest,
               const std::function<bool(double length)> &attempt)
{
  double left = to - from, step = left;
  while (left > 0.)
  {
    // The last step takes what is left, and no sliver remains behind.
    const double length = step > 0.99 * left ? left : step;
    if (attempt(length))
    {
      left = length == left ? 0. : left - length;
      step = 2. * length;
    }
    else
    {
      step = 0.5 * length;
      if (step < smallest)
        return false;
    }
  }
  return true;
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/observer.h>

#include <vector>

namespace pellicle
{
/** Keeps what a level of a run reports, for the case that it turns out to be the last one. */
class Recorder : public Observer
{
public:
  void on_iteration(const IterationReport &report) override { iterations.push_back(report); }
  void on_step(const StepReport &report) override { steps.push_back(report); }

  /** Iterations and steps; messages of levels are in their results' warnings. */
  void replay(Observer &observer) const
  {
    for (const IterationReport &report : iterations)
      observer.on_iteration(report);
    for (const StepReport &report : steps)
      observer.on_step(report);
  }

private:
  std::vector<IterationReport> iterations;
  std::vector<StepReport> steps;
};
} // namespace pellicle

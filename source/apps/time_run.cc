// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/apps/time_run.h>
#include <pellicle/base/exact_text.h>
#include <pellicle/base/exceptions.h>

namespace pellicle
{
namespace
{
void report(const SurfaceModel &model, const TimeParameters &time, const int step, const int iterations,
            RunResult &result, Observer &observer)
{
  StepReport done;
  done.step          = step;
  done.fraction_done = model.motion()->time() / time.end_time;
  done.stepped.emplace_back("time", model.motion()->time());
  done.iterations   = iterations;
  result.quantities = model.quantities();
  done.quantities   = result.quantities;
  observer.on_step(done);
}

void walk(const TimeParameters &time, SurfaceModel &model, Observer &observer, const SolutionSink &sink,
          RunMemory &memory, RunResult &result)
{
  int n_done       = 0;
  const auto state = [&](Archive &archive)
  {
    archive.name("motion in time");
    archive | n_done | result;
    model.exchange(archive);
    model.exchange_motion(time, archive);
  };
  if (!memory.take_up(state))
  {
    model.start_motion(time);
    report(model, time, 0, 0, result, observer);
    sink(model, 0, 0.);
  }
  for (int i = n_done + 1; i <= time.n_intervals(); ++i)
  {
    const StepResult outcome = model.move(time.time_after(i), i, observer);
    result.newton.iterations += outcome.iterations;
    result.newton.rejected += outcome.rejected;
    result.newton.final_relative_residual = outcome.relative_residual;
    for (const std::string &warning : outcome.warnings)
    {
      result.warnings.push_back(warning);
      observer.on_message(warning);
    }
    if (!outcome.converged)
      throw SolveError("The motion stopped at time " + exact_text(model.motion()->time()) + ": " + outcome.failure);
    ++result.newton.steps;
    report(model, time, i, outcome.iterations, result, observer);
    if (i % time.output_every == 0 || i == time.n_intervals())
      sink(model, i, time.time_after(i));
    n_done = i;
    memory.after_step(state);
  }
}
} // namespace

RunResult run_in_time(const SurfaceScene &scene, SurfaceModel &model, Observer &observer, const SolutionSink &sink,
                      RunMemory &memory)
{
  RunResult result;
  result.status = RunStatus::converged;
  try
  {
    walk(*scene.motion(), model, observer, sink, memory, result);
  }
  catch (const SolveError &error)
  {
    result.status  = RunStatus::failed;
    result.message = error.what();
    if (result.quantities.empty())
      result.quantities = model.quantities();
  }
  describe(scene, model, result);
  return result;
}
} // namespace pellicle

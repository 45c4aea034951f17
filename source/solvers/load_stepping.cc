// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/solvers/load_stepping.h>

#include <algorithm>

namespace pellicle
{
void LoadParameters::bind(ParameterSection &section)
{
  section.word("Parameter", parameter,
               "Parameter of the scene that changes in steps, as Section/Name, for example Vesicle/Reduced volume. "
               "Empty: one solve.");
  section.word(
      "From", from,
      "Its value at the first solve, a number or expression in the parameter's unit. Empty: the scene's own value.");
  section.word("To", to, "Its value at the last solve. Empty: the scene's own value of the parameter.");
  section.integer(
      "Steps", steps, 1, 100000,
      "Number of equal steps to begin with, of the parameter and of each stage of a scene that has a load path of its "
      "own. A step that fails is halved; after a success the next one may grow.");
  section.number("Smallest step", smallest_step, Range::between(1e-12, 1.), dimensions::none,
                 "Smallest step, as a fraction of the whole way (of a stage), before the run gives up.");
}

double walk_load(const LoadParameters &parameters, const std::function<bool(double t)> &attempt,
                 const LoadPosition from, const std::function<void(const LoadPosition &)> &after_step)
{
  LoadPosition at    = from;
  const double first = 1. / parameters.steps;
  const auto arrive  = [&](const double t, const double next_step)
  {
    at = {t, next_step};
    if (after_step)
      after_step(at);
  };
  if (at.t < 0.)
  {
    if (!attempt(0.))
      return -1.;
    arrive(0., first);
  }
  while (at.t < 1.)
  {
    // The last step ends at 1 exactly, and no sliver is left behind.
    const double next = at.t + at.next_step > 1. - 0.01 * first ? 1. : at.t + at.next_step;
    if (attempt(next))
      arrive(next, std::min(1.5 * at.next_step, 4. * first));
    else
    {
      at.next_step *= 0.5;
      if (at.next_step < parameters.smallest_step)
        return at.t;
    }
  }
  return 1.;
}
} // namespace pellicle

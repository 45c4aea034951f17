// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/models/active_set.h>
#include <pellicle/models/surface_problem.h>

#include <memory>
#include <string>
#include <utility>

namespace pellicle
{
/**
 * Multipliers of pair terms (contact of parts that deform) as an outer loop around equilibria: Uzawa's method. Each
 * round reduces what contact surfaces still penetrate by about stiffness/(stiffness + penalty).
 */
class ContactAugmentation : public ActiveSet
{
public:
  /** `tolerance`: largest change of a traction, relative to the largest one, at which multipliers are kept. */
  ContactAugmentation(std::shared_ptr<PairTerms> pairs, const double tolerance)
      : pairs(std::move(pairs))
      , tolerance(tolerance)
  {
  }

  const std::string &name() const override
  {
    static const std::string own_name = "multipliers of contact";
    return own_name;
  }
  std::size_t update(const SurfaceProblem &problem) override
  {
    return pairs->augment(problem.state().fields[0], tolerance) ? 1 : 0;
  }
  void exchange(Archive &archive) override { pairs->exchange(archive); }

private:
  std::shared_ptr<PairTerms> pairs;
  double tolerance;
};
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/potentials/contact/contact_law.h>

#include <algorithm>
#include <cmath>

namespace pellicle
{
ContactUpdate update_multipliers(std::vector<double> &multipliers, const std::vector<double> &gaps,
                                 const double penalty)
{
  PELLICLE_ASSERT(multipliers.size() == gaps.size(), "a multiplier and a gap for every point");
  ContactUpdate update;
  for (std::size_t q = 0; q < gaps.size(); ++q)
  {
    const double pressure = ContactResponse(gaps[q], multipliers[q], penalty).pressure;
    update.violation      = std::max(update.violation, std::abs(std::min(gaps[q], multipliers[q] / penalty)));
    update.n_active += pressure > 0. ? 1 : 0;
    multipliers[q] = pressure;
  }
  return update;
}
} // namespace pellicle

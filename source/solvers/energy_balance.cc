// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exact_text.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/solvers/energy_balance.h>

#include <algorithm>
#include <cmath>

namespace pellicle
{
namespace
{
constexpr double round_off = 1e-11; // relative; the error of an equilibrium's energy is quadratic in its residual
} // namespace

EnergyBalance::EnergyBalance(const double energy, const double scale)
    : start(energy)
    , present(energy)
    , scale(scale)
{
}

void EnergyBalance::add_minimising_step(const double energy, const double step_dissipation)
{
  const double excess = energy + step_dissipation - present;
  if (!(excess <= round_off * std::max({scale, std::abs(present), std::abs(energy)})))
    throw SolveError("A time step violates the energy law: energy " + exact_text(energy) +
                     " + step times dissipation " + exact_text(step_dissipation) + " exceeds the energy before it, " +
                     exact_text(present) + ", by " + exact_text(excess) +
                     " (internal units). A shorter Time/Step helps.");
  present = energy;
  work += 2. * step_dissipation;
}

void EnergyBalance::set(const double energy, const double dissipated)
{
  present = energy;
  work    = dissipated;
}

double EnergyBalance::relative_error() const
{
  return work > 0. ? (present - start + work) / work : 0.;
}
} // namespace pellicle

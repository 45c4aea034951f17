// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/models/jump_detector.h>

#include <cmath>

namespace pellicle
{
namespace
{
constexpr double round_off = 1e-7; // of the energy
} // namespace

std::optional<JumpDetector::State> JumpDetector::state_of(const SurfaceModel &model, const SurfaceScene &scene,
                                                          const double p) const
{
  if (const std::optional<double> slope = model.energy_slope(scene, parameter))
    return State{p, model.potential_energy(), *slope};
  return std::nullopt;
}

bool JumpDetector::has_jumped(const SurfaceModel &model, const SurfaceScene &scene, const double p,
                              const double tolerance) const
{
  const std::optional<State> now = state_of(model, scene, p);
  if (!last || !now)
    return false;
  const double step     = now->p - last->p;
  const double expected = 0.5 * (now->slope + last->slope) * step;
  const double allowed  = tolerance * 0.5 * (std::abs(now->slope) + std::abs(last->slope)) * std::abs(step) +
                         round_off * (1. + std::abs(now->energy));
  return std::abs(now->energy - last->energy - expected) > allowed;
}

void JumpDetector::accept(const SurfaceModel &model, const SurfaceScene &scene, const double p)
{
  last = state_of(model, scene, p);
}
} // namespace pellicle

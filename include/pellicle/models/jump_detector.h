// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/archive.h>
#include <pellicle/models/surface_model.h>

#include <optional>
#include <string>
#include <utility>

namespace pellicle
{
/**
 * Notices when a step in a parameter has left the branch of equilibria, as it does beyond a fold. Along a branch the
 * potential energy changes by the integral of its derivative with respect to the parameter (the conjugate force: P for
 * the volume, the force on a tip for its height), which is known at both ends of a step; a jump changes it by something
 * else.
 */
class JumpDetector
{
public:
  /** Disagreement of the trapezoidal rule with the change of energy, relative to that change, that counts as a jump: it
   * is better than `usual` on steps that a branch allows, and jumps are worse; on a long step a jump may be small
   * beside the rest. So a step that Newton's method found hard has to be `close`. */
  static constexpr double usual = 0.2, close = 0.03;

  explicit JumpDetector(std::string parameter)
      : parameter(std::move(parameter))
  {
  }

  /** Whether the model, now at an equilibrium with the value p, is on another branch than at the last accepted state.
   */
  bool has_jumped(const SurfaceModel &model, const SurfaceScene &scene, double p, double tolerance = usual) const;
  /** Takes the model's state as the one to compare with. */
  void accept(const SurfaceModel &model, const SurfaceScene &scene, double p);
  void exchange(Archive &archive) { archive | parameter | last; }

private:
  struct State
  {
    double p = 0., energy = 0., slope = 0.;
  };
  std::optional<State> state_of(const SurfaceModel &model, const SurfaceScene &scene, double p) const;

  std::string parameter;
  std::optional<State> last;
};
} // namespace pellicle

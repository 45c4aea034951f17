// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/effect.h>

namespace pellicle
{
/** The effect "contact": the surface does not go into the rigid bodies of the scene, without friction. It adds no term,
 * but inequalities at the nodes (NodalContact). */
class ContactEffect : public Effect
{
public:
  const std::string &name() const override;
  std::string description() const override;
  void contribute(const Scales & /*scales*/, const SceneTargets & /*targets*/, PotentialSet & /*set*/) const override {}
};
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/nodal_conditions.h>
#include <pellicle/potentials/effect.h>

#include <string>

namespace pellicle
{
class SurfaceProblem;

/**
 * Inequalities at nodes (contact, pinning), solved by a primal-dual active set: each node has a status that says which
 * equation holds there; an equilibrium is found with all statuses fixed; from its positions and forces follow new ones,
 * until none changes. Statuses live on from one load step to the next.
 */
class ActiveSet
{
public:
  virtual ~ActiveSet() = default;

  /** For messages: "contact", "line pinning". */
  virtual const std::string &name() const = 0;
  /** Takes over the numbers of a load step. */
  virtual void renew(const SceneTargets & /*targets*/) {}
  /** Called once before the first equilibrium of a load step. */
  virtual void begin_step(const SurfaceProblem & /*problem*/) {}
  /** Adds what the statuses ask of the nodes. */
  virtual void add_conditions(NodalConditions & /*conditions*/) const {}
  /** Adds the terms that the statuses bring. Number and places of the terms must not depend on the statuses; what they
   * hold may be shared with this object and change with them. */
  virtual void add_potentials(PotentialSet & /*set*/) const {}
  /** New statuses at the problem's present equilibrium; returns how many nodes changed theirs. */
  virtual std::size_t update(const SurfaceProblem &problem) = 0;
};
} // namespace pellicle

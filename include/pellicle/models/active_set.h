// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/field_layout.h>
#include <pellicle/assembly/nodal_conditions.h>
#include <pellicle/base/archive.h>
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
  /** Called once before the first equilibrium of a load step. */
  virtual void begin_step(const SurfaceProblem & /*problem*/) {}
  /** Takes over the numbers of a scene: of the first one, and of each load step before its first equilibrium. */
  virtual void take(const SceneTargets & /*targets*/) {}
  /** Adds what the statuses ask of the nodes. */
  virtual void add_conditions(NodalConditions & /*conditions*/) const {}
  /** Adds the terms that the statuses bring. Number and places of the terms must not depend on the statuses; what they
   * hold may be shared with this object and change with them. */
  virtual void add_potentials(PotentialSet & /*set*/) const {}
  /** Moves nodes to where their statuses want them before the next equilibrium is looked for: values of all fields, the
   * positions first. */
  virtual void place(FieldValues & /*fields*/) const {}
  /** Whether the scene's rigid motions still cost no energy with these statuses, so that they must be a gauge. */
  virtual bool leaves_rigid_motions() const { return true; }
  /** Takes over the statuses of an equilibrium that was found on another mesh, as far as they follow from its fields on
   * this one. False: they do not, since they remember the path that led there, which has to be walked anew. */
  virtual bool take_over(const FieldValues & /*fields*/) { return false; }
  /** New statuses at the problem's present equilibrium; returns how many nodes changed theirs. Throws SolveError if no
   * statuses can fulfil the inequalities. */
  virtual std::size_t update(const SurfaceProblem &problem) = 0;
  /** What the statuses tell about a solve that failed, for its message; empty: nothing. */
  virtual std::string about_failure() const { return ""; }
  /** All that lives on from one load step to the next. */
  virtual void exchange(Archive &archive) = 0;
};
} // namespace pellicle

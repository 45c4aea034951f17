// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>
#include <pellicle/kinematics/gap.h>
#include <pellicle/models/active_set.h>

#include <memory>
#include <vector>

namespace pellicle
{
/**
 * Frictionless contact of a surface with rigid bodies at its nodes: g_n >= 0, pressure >= 0, one of them zero ((72) of
 * Sauer 2014 at the nodes, which are Gauss-Lobatto points: all have positive shares of the surface). An active node
 * stays on its body; it is released when the body would have to pull, and a free one that has gone into a body becomes
 * active.
 *
 * The force of the body on a node is lambda_I n with lambda_I = n . (gradient of the Lagrangian with respect to x_I).
 */
class NodalContact : public ActiveSet
{
public:
  /** Nodes that touch a body at the start are active. `exempt`: nodes that the scene keeps on bodies anyhow. */
  NodalContact(const SurfaceDiscretization &surface, std::vector<std::shared_ptr<const RigidBody>> bodies,
               std::vector<bool> exempt);

  const std::string &name() const override;
  void take(const SceneTargets &targets) override;
  void add_conditions(NodalConditions &conditions) const override;
  /** Nodes that touch a body there are active. */
  bool take_over(const FieldValues &fields) override;
  std::size_t update(const SurfaceProblem &problem) override;
  /** Which bodies are touched, and by how many nodes. */
  std::string about_failure() const override;
  void exchange(Archive &archive) override;

  std::size_t n_active() const;
  /** Whether a node touches the given body now. */
  bool touches(std::size_t node, std::size_t body) const;

private:
  static constexpr int none = -1;
  void find_touching(const NodalVectors &positions);

  std::vector<std::shared_ptr<const RigidBody>> bodies;
  std::vector<bool> exempt;
  std::vector<int> touched; ///< number of the body, by node
};
} // namespace pellicle

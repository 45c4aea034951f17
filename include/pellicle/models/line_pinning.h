// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>
#include <pellicle/models/active_set.h>
#include <pellicle/potentials/wetting/line_friction.h>

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace pellicle
{
/**
 * Contact angle hysteresis: nodes of the contact line stick where receding angle < theta < advancing angle, and slip at
 * these angles. With the swept area as measure of slip the line's friction is rate independent, and a load step is the
 * minimum of energy + D (make_line_friction) from the line x_0 at its beginning:
 *
 * | status    | equation                       | goes over to                                         |
 * |-----------|--------------------------------|------------------------------------------------------|
 * | stuck     | x_I = x_0I                     | slip, where theta is beyond the angle of that slip   |
 * | advancing | theta_I = the advancing angle  | stuck, where the node has gone back                  |
 * | receding  | theta_I = the receding angle   | stuck, where the node has gone forward               |
 *
 * theta_I is the angle of the nodal equation, pull = gamma cos(theta_I) length (line_forces.h). A cell of the line has
 * one direction of slip: where two meet the node between them sticks.
 *
 * Before the first load step the line settles at theta of the effect `wetting`, if no force pulls along the substrate;
 * otherwise it sticks where the start shape has it.
 */
class LinePinning : public ActiveSet
{
public:
  LinePinning(const EdgeLoop &line, const SceneTargets &targets);

  const std::string &name() const override;
  void begin_step(const SurfaceProblem &problem) override;
  void take(const SceneTargets &targets) override;
  void add_conditions(NodalConditions &conditions) const override;
  void place(NodalVectors &positions) const override;
  void add_potentials(PotentialSet &set) const override;
  bool leaves_rigid_motions() const override;
  std::size_t update(const SurfaceProblem &problem) override;
  std::string about_failure() const override;

  struct Counts
  {
    std::size_t stuck = 0, advancing = 0, receding = 0;
  };
  Counts counts() const;

private:
  enum class Status
  {
    stuck,
    advancing,
    receding
  };
  struct Node
  {
    Status status  = Status::stuck;
    Status settled = Status::stuck; ///< at the last equilibrium
    Vector3<double> start;          ///< place at the beginning of the load step
    Vector3<double> across;         ///< direction of advance there
    std::vector<std::size_t> cells; ///< of the line, that have the node
  };
  const RigidBody &body() const;
  bool is_pulled_along() const;
  /** cos(theta) of a slip; of the wetting, where the line sticks. */
  double cosine(Status status) const;
  /** cos(theta) beyond which a node slips. */
  double threshold(Status status) const;
  bool may_slip(const Node &node, Status status) const;
  Status status_of_cell(std::size_t cell) const;
  void set_friction();
  /** Throws SolveError for statuses that were tried before in this load step. */
  void note_statuses();
  double dissipated_in_step(const NodalVectors &positions) const;

  const EdgeLoop &line;
  DropletTargets drop;
  std::map<std::size_t, Node> nodes;
  bool settling                               = false; ///< the line moves freely
  std::shared_ptr<LineFrictionState> friction = std::make_shared<LineFrictionState>();
  NodalVectors last_equilibrium;
  std::set<std::vector<Status>> tried;
};
} // namespace pellicle

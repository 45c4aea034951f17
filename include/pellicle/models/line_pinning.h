// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/models/active_set.h>
#include <pellicle/models/line_slip.h>

#include <map>
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
 * theta_I is the angle of the nodal equation, pull = gamma cos(theta_I) length (line_forces.h). Neighbours
 * that slip in different directions have a node between them that sticks (LineSlip).
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
  void place(FieldValues &fields) const override;
  void add_potentials(PotentialSet &set) const override;
  bool leaves_rigid_motions() const override;
  std::size_t update(const SurfaceProblem &problem) override;
  std::string about_failure() const override;
  void exchange(Archive &archive) override;

  using Counts = LineSlip::Counts;
  Counts counts() const { return slip.counts(); }

private:
  struct Node
  {
    Vector3<double> start;  ///< place at the beginning of the load step
    Vector3<double> across; ///< direction of advance there
  };
  const RigidBody &body() const;
  bool is_pulled_along() const;
  /** cos(theta) of a slip; of the wetting, where the line sticks. */
  double cosine(SlipStatus status) const;
  /** cos(theta) beyond which a node slips. */
  double threshold(SlipStatus status) const;
  void set_friction();
  std::vector<double> wetted_areas(const NodalVectors &positions) const;

  const EdgeLoop &line;
  DropletTargets drop;
  LineSlip slip;
  std::map<std::size_t, Node> nodes;
  bool settling = false; ///< the line moves freely
  NodalVectors last_equilibrium;
};
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/line_shift.h>
#include <pellicle/models/active_set.h>
#include <pellicle/models/line_slip.h>

#include <string>
#include <vector>

namespace pellicle
{
/**
 * Hysteresis of a contact line on a soft substrate: nodes of the line keep their material points while Eshelby's force
 * f per length (eshelby_forces.h) is within the thresholds of `free contact line`, and slip at these. The friction is
 * rate independent: a load step is the minimum of energy + D (make_material_line_friction) from the material line at
 * its beginning, D = Y times the change of the undeformed area inside it, where all of it advances:
 *
 * | status    | equation           | goes over to                                  |
 * |-----------|--------------------|-----------------------------------------------|
 * | stuck     | s_i = s_0i         | slip, where f is beyond the threshold of it   |
 * | advancing | f_i = Y_advancing  | stuck, where the node has gone back           |
 * | receding  | f_i = -Y_receding  | stuck, where the node has gone forward        |
 *
 * Before the first load step all nodes stick where the mesh has the line.
 */
class MaterialLinePinning : public ActiveSet
{
public:
  /** @param ridge  with the undeformed substrate as its positions; must outlive this object. */
  MaterialLinePinning(const SurfaceDiscretization &ridge, const SceneTargets &targets);

  const std::string &name() const override;
  void begin_step(const SurfaceProblem &problem) override;
  void take(const SceneTargets &targets) override;
  void add_conditions(NodalConditions &conditions) const override;
  void place(FieldValues &fields) const override;
  void add_potentials(PotentialSet &set) const override;
  std::size_t update(const SurfaceProblem &problem) override;
  std::string about_failure() const override;
  void exchange(Archive &archive) override;

  LineSlip::Counts counts() const { return slip.counts(); }

private:
  bool is_stuck(std::size_t node) const;
  void set_friction();
  std::vector<double> areas(const NodalVectors &material) const;

  const EdgeLoop &line;
  LineShift shift;
  LineThresholds thresholds;
  double tolerance     = 0.;    ///< of forces per length
  bool is_pulled_along = false; ///< gravity acts along the undeformed top
  LineSlip slip;
  std::size_t field = 0; ///< index of "material position"
  NodalVectors start;    ///< material points at the beginning of the load step
  NodalVectors last_equilibrium;
};
} // namespace pellicle

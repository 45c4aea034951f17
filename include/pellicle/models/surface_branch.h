// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/models/surface_problem.h>
#include <pellicle/solvers/parametrised_problem.h>

#include <functional>
#include <string>
#include <vector>

namespace pellicle
{
/** A parameter of a scene as continuation sees it, in the user's unit. */
struct SceneParameter
{
  std::string name; ///< "Section/Name"
  double value = 0.;
  double scale = 1.; ///< a change that counts as much as displacements of the order of the length
  /** Energies and constraints at a value of the parameter, internal units; may throw UserError for one out of range. */
  std::function<PotentialSet(double)> potentials;
  /** Their derivatives at a value of the parameter, for this parameter only. */
  std::function<std::vector<ParameterDerivative>(double)> derivatives;
};

/** Equilibria of a surface as functions of a scene's parameter. */
class SurfaceBranch : public ParametrisedProblem
{
public:
  /** Keeps references; mesh_reference as in SurfaceProblem::use_chart(). The problem is at an equilibrium. */
  SurfaceBranch(SurfaceProblem &problem, SceneParameter parameter, PositionChart chart,
                const NodalVectors &mesh_reference);
  ~SurfaceBranch() override { problem.renew_chart_on_the_way(true); }

  /** Back into the branch's own chart, after somebody used another one at the same state. */
  void use_own_chart() { problem.use_chart(chart, mesh_reference); }

  double parameter() const override { return scene_parameter.value; }
  void set_parameter(double value) override;
  std::vector<double> residual_derivative() override;
  std::vector<double> weights() const override;
  double parameter_scale() const override { return scene_parameter.scale; }
  bool begin_step() override;
  void remember() override;
  void recall() override;

  void linearize() override { problem.linearize(); }
  const SparseMatrix &matrix() const override { return problem.matrix(); }
  const std::vector<double> &residual() const override { return problem.residual(); }
  double relative_residual() const override { return problem.relative_residual(); }
  double constraint_violation() const override { return problem.constraint_violation(); }
  void add_drag(const double zeta) override { problem.add_drag(zeta); }
  bool is_variational() const override { return problem.is_variational(); }
  int expected_negative_pivots() const override { return problem.expected_negative_pivots(); }
  double merit_slope(const std::vector<double> &direction) const override { return problem.merit_slope(direction); }
  double merit(const std::vector<double> &direction) const override { return problem.merit(direction); }
  double try_step(const std::vector<double> &direction, const double length) override
  {
    return problem.try_step(direction, length);
  }
  void accept_trial() override { problem.accept_trial(); }
  double displacement(const std::vector<double> &direction) const override { return problem.displacement(direction); }
  double energy() const override { return problem.energy(); }

private:
  SurfaceProblem &problem;
  SceneParameter scene_parameter;
  const PositionChart chart;
  const NodalVectors &mesh_reference;
  SurfaceState remembered;
  double remembered_value = 0.;
};
} // namespace pellicle

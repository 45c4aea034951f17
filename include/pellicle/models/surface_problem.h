// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/assembler.h>
#include <pellicle/assembly/bordered_system.h>
#include <pellicle/models/internal_elimination.h>
#include <pellicle/solvers/equilibrium_problem.h>

#include <memory>
#include <string>
#include <vector>

namespace pellicle
{
/** All that changes in a solve, internal units. */
struct SurfaceState
{
  FieldValues fields;              ///< in the layout's order; `position` first
  std::vector<double> multipliers; ///< lambda of each constraint
  /**
   * Reactions mu of the rigid motions. The charts ask for zero normal forces at all nodes; the tangential forces that a
   * discrete equilibrium leaves may add up to a net force or torque (of the size of the discretisation error), and mu
   * balances that. Without it there would be no solution, but for shapes with enough symmetry.
   */
  std::vector<double> rigid_reactions;
};

/** How the position's tangential freedom is fixed. */
enum class PositionChart
{
  graph, ///< displacement along the nodal normals
  ale    ///< all components, mesh equations for the tangential ones
};

/**
 * Equilibrium of a surface under listed energies and constraints: mesh + fields + lists, in a chart. Internal fields
 * are eliminated after every change of the others, so Newton acts on the reduced energy.
 */
class SurfaceProblem : public EquilibriumProblem
{
public:
  /**
   * @param set      energies and constraints; may change its numbers (set_potentials), not its fields.
   * @throws UserError if the ALE chart is wanted and a potential is not reparametrisation invariant.
   */
  SurfaceProblem(const SurfaceDiscretization &discretization, PotentialSet set, const Communicator &communicator,
                 std::string linear_solver, Timing &timing);

  /** The same lists with other numbers: a load step. */
  void set_potentials(PotentialSet set);
  const PotentialSet &potentials() const { return set; }
  const FieldLayout &layout() const { return field_layout; }

  /** Chart at the current positions; `mesh_reference`: positions whose metric the ALE mesh energy prefers. */
  void use_chart(PositionChart chart, const NodalVectors &mesh_reference);

  const SurfaceState &state() const { return current; }
  /** Takes over a state and eliminates the internal fields. Throws SolveError if that fails. */
  void set_state(SurfaceState state);

  /** Energies and constraint values of the current state. */
  const TermValues &values() const { return current_values; }
  const Numbering &numbering() const { return system->numbering(); }
  /** Gradient of constraint k with respect to the chart's unknowns, at the last linearisation. */
  const std::vector<double> &constraint_gradient(const std::size_t k) const { return system->constraint_gradient(k); }
  std::vector<const AssemblyCounters *> counters() const;

  void linearize() override;
  const SparseMatrix &matrix() const override { return system->matrix(); }
  const std::vector<double> &residual() const override { return system->residual(); }
  double relative_residual() const override;
  double constraint_violation() const override;
  void add_drag(double zeta) override;
  bool is_variational() const override { return chart == PositionChart::graph; }
  int expected_negative_pivots() const override;
  double merit_slope(const std::vector<double> &direction) const override;
  double merit(const std::vector<double> &direction) const override;
  double try_step(const std::vector<double> &direction, double length) override;
  void accept_trial() override;
  double displacement(const std::vector<double> &direction) const override;
  double energy() const override;

private:
  TermValues evaluate(const FieldValues &fields) const;
  double merit_of(const TermValues &values, const std::vector<double> &direction) const;
  std::vector<double> full_step_multipliers(const std::vector<double> &direction) const;
  double constraint_residual(std::size_t k, const TermValues &values, double lambda) const;

  const SurfaceDiscretization &discretization;
  PotentialSet set;
  const Communicator &communicator;
  Timing &timing;
  FieldLayout field_layout;
  mutable Assembler assembler;
  InternalElimination elimination;

  std::vector<NodalChart> charts_here() const;
  void recentre_chart();

  PositionChart chart   = PositionChart::graph;
  double moved_in_chart = 0.; ///< largest displacement of a node, summed over steps since the chart was made
  std::unique_ptr<BorderedSystem> system;
  PotentialSet mesh_set;
  std::unique_ptr<FieldLayout> mesh_layout;
  std::unique_ptr<Assembler> mesh_assembler;
  std::vector<double> node_areas;
  std::vector<NodalVectors> rigid_directions;

  SurfaceState current, trial;
  TermValues current_values, trial_values;
};

/** Whether all listed terms are: only then may tangential equilibrium be replaced by mesh equations. */
bool is_reparametrisation_invariant(const PotentialSet &set);

/** Metric of a configuration at every quadrature point, as the reference of the mesh energy. */
std::vector<struct ReferenceMetric> reference_metric(const SurfaceDiscretization &discretization,
                                                     const NodalVectors &positions);
} // namespace pellicle

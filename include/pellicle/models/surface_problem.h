// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/assembler.h>
#include <pellicle/assembly/bordered_system.h>
#include <pellicle/assembly/pair_terms.h>
#include <pellicle/base/archive.h>
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

  void exchange(Archive &archive) { archive | fields | multipliers | rigid_reactions; }
};

/** How the position's tangential freedom is fixed; nodes of bodies, and those that a pair term holds tangentially, move
 * freely in each of them. */
enum class PositionChart
{
  graph,   ///< displacement along the nodal normals; sheets that meet at junctions follow these besides
  ale,     ///< all components, mesh equations for the tangential ones
  material ///< all components, all of them physical: potentials that act tangentially
};

/**
 * Equilibrium of a surface, and of the bodies that come with it, under listed energies and constraints: mesh + fields +
 * lists, in a chart. Pair terms (contact of parts that deform) may come in addition. Internal fields are eliminated
 * after every change of the others, so Newton acts on the reduced energy. Fields that are multipliers take full steps,
 * as the constraints' multipliers do.
 */
class SurfaceProblem : public EquilibriumProblem
{
public:
  /**
   * @param set      energies and constraints; may change its numbers (set_potentials), not its fields.
   * @param conditions  of the nodes of each field, from the edges of an open surface.
   */
  SurfaceProblem(const SurfaceDiscretization &discretization, PotentialSet set, NodalConditions conditions,
                 const Communicator &communicator, std::string linear_solver, Timing &timing);

  /** The same lists with other numbers: a load step. */
  void set_potentials(PotentialSet set);
  const PotentialSet &potentials() const { return set; }
  const FieldLayout &layout() const { return field_layout; }
  const SurfaceDiscretization &discretization() const { return surface; }

  /** Other conditions of the nodes' positions: they take effect with the next use_chart(). Nodes that are to stay on
   * bodies go there. */
  void set_conditions(NodalConditions conditions);
  const NodalConditions &nodal_conditions() const { return conditions; }
  /** Whether the discretization's rigid motions are a gauge (the default): not if something holds the surface in space.
   * It takes effect with the next use_chart(). */
  void set_rigid_gauge(const bool wanted) { rigid_gauge = wanted; }

  /** Terms that couple cells that meet; none to begin with. They take effect with the next use_chart(). Throws
   * SolveError with the term's name where they make no sense at the present state. */
  void set_pairs(std::shared_ptr<PairTerms> pairs);
  /** Null: none. */
  const std::shared_ptr<PairTerms> &pairs() const { return pair_terms; }
  /** Whether there are nodes whose tangential motion is physical other than those that are free in every chart: only
   * the material chart will do. Where there are no others, it is the natural one. */
  bool needs_material_chart() const;

  /** Chart at the current positions; `mesh_reference`: positions whose metric the ALE mesh energy prefers. Throws
   * UserError if it would hold back tangential motion that a potential sees. */
  void use_chart(PositionChart chart, const NodalVectors &mesh_reference);

  /** Whether the chart is renewed when the shape has moved far in it (the default). While it is not, directions keep
   * their meaning. */
  void renew_chart_on_the_way(const bool renew) { renews_chart = renew; }
  PositionChart position_chart() const { return chart; }

  const SurfaceState &state() const { return current; }
  /** Takes over a state and eliminates the internal fields. Throws SolveError if that fails. */
  void set_state(SurfaceState state);
  /** State, values and chart to the last bit: what is read is taken as it is, not solved for. The potentials and the
   * conditions are those it was written with. Throws ArchiveMismatch if it is of another mesh or list. */
  void exchange(Archive &archive);

  /** From the present state a time step of that length begins: until the next one, equilibrium means that energies +
   * length * D((y - y_old)/length) are stationary, D the listed dissipation potentials. */
  void begin_time_step(double length);
  /** length * D of the step so far. */
  double step_dissipation() const;

  /** Energies and constraint values of the current state. */
  const TermValues &values() const { return current_values; }
  const Numbering &numbering() const { return system->numbering(); }
  /** Gradients with respect to the nodal positions in R^3 at the current state: of energies + multipliers . constraints
   * (the forces that hold the nodes, where they are held), and of each constraint. */
  struct NodalForces
  {
    NodalVectors total;
    std::vector<NodalVectors> constraints;
  };
  NodalForces nodal_forces() const;
  /** The part of pair terms in the total. */
  NodalVectors pair_forces() const;
  /** The total of other energies with the same constraints; also with respect to another field of the layout. */
  NodalVectors nodal_forces(const PotentialSet &part, const std::string &field = "position") const;
  /** The body on which a node stays; null: none. */
  std::shared_ptr<const RigidBody> body_of(std::size_t node) const;
  /** Gradient of further energies (of fields that the layout has) with respect to the unknowns of the present chart;
   * zero in mesh equations. As long as a direction. */
  std::vector<double> gradient_of(const PotentialSet &further) const;
  /** Sum of further energies at the present state. */
  double value_of(const PotentialSet &further) const;
  /** Area of the node for each unknown that moves it against a physical force, zero for all others. */
  std::vector<double> area_weights() const;
  std::vector<const AssemblyCounters *> counters() const;

  void linearize() override;
  const SparseMatrix &matrix() const override { return system->matrix(); }
  const std::vector<double> &residual() const override { return system->residual(); }
  double relative_residual() const override;
  double constraint_violation() const override;
  void add_drag(double zeta) override;
  bool is_variational() const override { return !system->numbering().charts[0].has_mesh_equations(); }
  int expected_negative_pivots() const override;
  double merit_slope(const std::vector<double> &direction) const override;
  double merit(const std::vector<double> &direction) const override;
  double try_step(const std::vector<double> &direction, double length) override;
  void accept_trial() override;
  /** The largest change of a node's position, or of a director. */
  double displacement(const std::vector<double> &direction) const override;
  /** The direction that comes nearest to nodal displacements; its entries for other fields are zero. */
  std::vector<double> direction_of(const NodalVectors &displacements) const;
  /** Changes of a field's nodal values along a direction; displacements, of the position. */
  NodalVectors displacements(const std::vector<double> &direction, std::size_t field = 0) const;
  /** The field of which instability is a matter: the position or, on a surface that is held, the directors. */
  std::size_t field_that_moves() const;
  /** Adds changes to a field's nodal values; unit vectors keep their length. */
  void displace(SurfaceState &state, std::size_t field, double factor, const NodalVectors &changes) const;
  double energy() const override;

private:
  TermValues evaluate(const SurfaceState &state) const;
  TermValues at_full_multiplier_fields(const std::vector<double> &direction) const;
  double merit_of(const TermValues &values, const std::vector<double> &of_state,
                  const std::vector<double> &direction) const;
  std::vector<double> full_step_multipliers(const std::vector<double> &direction) const;
  double constraint_residual(std::size_t k, const TermValues &values, double lambda) const;
  bool is_multiplier(std::size_t field) const;
  /** Positions and directors: what a drag acts on, and whose largest change is a step's length. */
  bool is_moving(std::size_t field) const;

  const SurfaceDiscretization &surface;
  PotentialSet set;
  NodalConditions conditions;
  const Communicator &communicator;
  Timing &timing;
  FieldLayout field_layout;
  mutable Assembler assembler;
  InternalElimination elimination;

  std::vector<NodalChart> charts_here() const;
  NodalVectors transversal_directions() const;
  void keep_nodes_on_bodies(NodalChart &positions) const;
  void find_material_nodes();
  void find_sheet_carriers();
  std::size_t n_rigid() const { return rigid_gauge ? surface.rigid_motions.size() : 0; }
  void renew_gauge();

  std::shared_ptr<PairTerms> pair_terms;
  std::vector<bool> material;                                   ///< nodes that are free in every chart
  std::vector<std::vector<NodalChart::Carrier>> sheet_carriers; ///< in the graph chart of a surface with junctions

  PositionChart chart   = PositionChart::graph;
  bool renews_chart     = true;
  double moved_in_chart = 0.; ///< largest displacement of a node, summed over steps since the chart was made
  std::unique_ptr<BorderedSystem> system;
  PotentialSet mesh_set;
  std::unique_ptr<FieldLayout> mesh_layout;
  std::unique_ptr<Assembler> mesh_assembler;
  std::vector<double> node_areas;
  bool rigid_gauge = true;
  std::vector<NodalVectors> rigid_directions;

  SurfaceState current, trial;
  TermValues current_values, trial_values;
};

/** A quadratic term - (lambda^2/2) r of the Lagrangian is part of the energy that the internal fields yield: this gives
 * it back, sum of (lambda^2/2) r. */
double energy_of_self_terms(const TermValues &values, const std::vector<double> &multipliers);

/** Whether all listed terms of surfaces and edges are: only then may tangential equilibrium be replaced by mesh
 * equations. */
bool is_reparametrisation_invariant(const PotentialSet &set);

/** Metric of a configuration at every quadrature point, as the reference of the mesh energy. */
std::vector<ReferenceMetric> reference_metric(const SurfaceDiscretization &discretization,
                                              const NodalVectors &positions);
} // namespace pellicle

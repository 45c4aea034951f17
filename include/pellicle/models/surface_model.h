// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/archive.h>
#include <pellicle/base/observer.h>
#include <pellicle/base/timing.h>
#include <pellicle/models/equilibrium_search.h>
#include <pellicle/models/run_result.h>
#include <pellicle/models/shape_measures.h>
#include <pellicle/models/surface_motion.h>
#include <pellicle/models/surface_sample.h>
#include <pellicle/models/surface_scene.h>

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pellicle
{
class SurfaceBranch;

/**
 * A surface built from a scene: mesh, fields, lists, in internal units (length sqrt(A/4 pi), the effects' energy,
 * origin at the centroid). What users ask for is scaled back.
 */
class SurfaceModel
{
public:
  /**
   * Builds mesh, fields and lists. Throws UserError: a start shape that cannot be made, a list without energy, an exact
   * sphere under both area and volume constraints (their gradients are parallel).
   */
  SurfaceModel(const SurfaceScene &scene, const Communicator &communicator, Timing &timing);

  /** Takes over the numbers of a scene with the same effects and mesh: a load step. */
  void update(const SurfaceScene &scene);

  /**
   * Starts from the equilibrium of a model of the same scene on another mesh; see transferred_state(). This model is as
   * it was built, but for updates. False, and nothing has happened, if the meshes have no places in common or if the
   * scene's inequalities remember more than the state. Throws SolveError where the state makes no sense on this mesh.
   */
  bool start_from(const SurfaceModel &solved);

  /** One undamped Newton step towards an equilibrium that is near, with the active sets as they are. False, and the
   * state is what it was, if the equilibrium is not near. */
  bool take_one_step();

  /** Newton from the present state, in the charts that the scene asks for; then, if the scene lists it, the stability
   * of the equilibrium, and downhill where it is unstable and the scene wants that. On failure the state before the
   * call is restored. */
  StepResult solve(int step, Observer &observer);

  /** Begins to move from the present state, at time 0, down the energy against the listed dissipation potentials: see
   * make_motion() for what it throws. */
  void start_motion(const TimeParameters &time);
  /** Moves on to a later time. After a failure the model is where the motion stopped. */
  StepResult move(double time, int step, Observer &observer);
  /** The motion that was begun; null: none. */
  const SurfaceMotion *motion() const { return current_motion.get(); }

  /** The state at the end of a step, with all that lives on to the next one: a model of the same scene that reads it
   * goes on as this one would, to the last bit. Before reading update() has set the parameters of that step. Throws
   * ArchiveMismatch if it is of another mesh or list of effects. */
  void exchange(Archive &archive);
  /** The same for a motion, which comes after the model's state: one that is read goes on from there. */
  void exchange_motion(const TimeParameters &time, Archive &archive);

  /** The scene with another value of a parameter. May throw UserError. */
  using SceneAt = std::function<std::unique_ptr<SurfaceScene>(double)>;

  /** A state of a branch that was followed. */
  struct PointOnBranch
  {
    BranchPoint point;
    std::optional<int> negative_eigenvalues;
  };
  /** The last state of a branch off a bifurcation. */
  struct PlaceOnBranch
  {
    SurfaceState state;
    double parameter         = 0.;
    int negative_eigenvalues = 0;

    void exchange(Archive &archive) { archive | state | parameter | negative_eigenvalues; }
  };
  /** How far a branch has been followed: with the model's state at that point it can be followed further. */
  struct BranchProgress
  {
    BranchPosition position;
    double scale = 1.; ///< of the parameter
    NodalVectors mesh_reference;
    std::optional<int> count; ///< of negative eigenvalues at the last point that tells
    PlaceOnBranch before;
    bool has_switched = false;        ///< onto a crossing branch
    ContinuationResult before_switch; ///< of the branch until then

    void exchange(Archive &archive)
    {
      archive | position | scale | mesh_reference | count | before | has_switched | before_switch;
    }
  };
  /** Of a branch that can be taken up again. */
  struct BranchMemory
  {
    const BranchProgress *from = nullptr;                            ///< null: from the model's equilibrium
    std::function<void(const BranchProgress &progress)> after_point; ///< called after each point but the last one
  };

  /**
   * Follows the branch of equilibria through the present one, along a parameter whose value is now `value`, as the
   * scene's section Continuation says.
   *
   * @param on_point  called at every point of the branch, with the model at that state.
   * @param memory    where an earlier run stopped, with the model at that state; points before it are not made again.
   * Throws UserError if no listed effect knows the derivative with respect to the parameter.
   */
  ContinuationResult follow_branch(const BranchParameters &branch, double value, const SceneAt &scene_at,
                                   Observer &observer, const std::function<void(const PointOnBranch &)> &on_point,
                                   const BranchMemory &memory);
  ContinuationResult follow_branch(const BranchParameters &branch, const double value, const SceneAt &scene_at,
                                   Observer &observer, const std::function<void(const PointOnBranch &)> &on_point)
  {
    return follow_branch(branch, value, scene_at, observer, on_point, {});
  }

  /** The potential that is stationary at an equilibrium: energies and penalties; and its derivative with respect to a
   * parameter of the scene, at the equilibrium (none if no listed effect knows it). Internal units, parameters in the
   * user's. */
  double potential_energy() const;
  std::optional<double> energy_slope(const SurfaceScene &scene, const std::string &parameter) const;

  /** Goes to an equilibrium that was found before, with the same parameters. */
  void go_to(const SurfaceState &state) { problem->set_state(state); }

  /** Goes to the state at which the last solve gave up, so that it can be looked at. Does nothing if none did. */
  void show_last_iterate();

  /** Stability of the last equilibrium that was found; none if the scene does not list it or the solver cannot tell.
   * Internal units. */
  const std::optional<Stability> &stability() const { return last_stability; }

  /** Of the matrix of the last equilibrium that was found, without drag; none if the scene does not ask for it. */
  const std::optional<LinearSolverReport> &linear_solver() const { return last_linear_solver; }

  /** Reported quantities in the user's units, in the order of the documentation. */
  std::vector<std::pair<std::string, double>> quantities() const;
  /** Energies by name; tension, pressure and other multipliers. Internal units. */
  std::vector<NamedQuantity> energies() const;
  std::vector<NamedQuantity> forces() const;
  /** The surface with its fields, in the user's units. */
  SurfaceSample sample() const;
  /** Bodies that are solved for, with their fields, in the user's units (see sample_body()). */
  std::vector<NamedSample> body_samples() const;
  /** Bodies beside the surface, in the user's units; without cells if there are none. */
  SurfaceSample surroundings() const { return own_surroundings ? own_surroundings(*this) : SurfaceSample(); }

  /** Of the bodies, where the scene is about them, else of the surface. */
  std::size_t n_cells() const
  {
    return discretization.has_junctions() && !discretization.bulks.empty() ? discretization.bulks.front().n_cells
                                                                           : discretization.n_cells;
  }
  /** Unknowns of the linear system that was solved last: name of field or "multipliers" -> number; "total". */
  const std::vector<std::pair<std::string, std::size_t>> &unknown_counts() const { return last_unknown_counts; }

  /** Nodal positions of mesh(), internal units. */
  NodalVectors positions() const { return on_mesh(problem->state().fields[0]); }
  const std::vector<std::unique_ptr<ActiveSet>> &inequalities() const { return active_sets; }
  /** What the effects were given, internal units. */
  const SceneTargets &scene_targets() const { return targets; }
  /** Whether an energy of that name is listed. */
  bool has_energy(const std::string &name) const;
  const SurfaceProblem &equilibrium() const { return *problem; }
  const SurfaceDiscretization &mesh() const { return discretization; }
  const Scales &scales() const { return unit; }
  /** Where the origin of the internal coordinates is, in the user's units. */
  Vector3<double> origin() const { return {centroid[0], centroid[1], centroid[2]}; }

private:
  /** What the equations live on: its first nodes are those of mesh(). */
  const SurfaceDiscretization &solved_mesh() const { return split ? *split : discretization; }
  /** Values at the nodes of mesh(). */
  NodalVectors on_mesh(NodalVectors values) const
  {
    values.resize(3 * discretization.n_nodes);
    return values;
  }
  /** Also where the mesh is a part of the surface. */
  ShapeMeasures measure_whole() const;
  void add_node_noise(const NodeNoise &noise);
  void check_constraints_are_independent();
  void add_pairs(const SurfaceScene &scene, const Communicator &communicator);
  void take_from_mesh(const SurfaceScene &scene);
  PotentialSet potentials_of(const SurfaceScene &scene);
  void look_at_stability(EquilibriumSearch &search);
  /** An equilibrium of the active sets; why there is none, as far as they know, is the search's failure. */
  void solve_with_active_sets(EquilibriumSearch &search);
  /** Equilibria in turn with updates of the active sets, until no status changes. */
  bool settle_active_sets(EquilibriumSearch &search);
  void apply_active_sets();
  /** Positions whose metric the mesh energy prefers, for a solve that begins now. */
  NodalVectors mesh_reference() const;
  void count_unknowns();
  /** Of the matrix at the equilibrium that was found last; `search` takes what goes wrong as a warning. */
  void look_at_matrix(EquilibriumSearch &search);

  /** Between two places with different numbers of unstable modes, the model being at the second one: goes to where an
   * eigenvalue is zero, and returns those there. Throws SolveError. */
  Stability go_to_bifurcation(SurfaceBranch &along, const PlaceOnBranch &before, const PlaceOnBranch &after);

  NewtonParameters newton;
  Scales unit;
  const Communicator &communicator;
  Timing &timing;
  std::array<double, 3> centroid{};
  SurfaceDiscretization discretization;
  MirrorPlanes planes;                        ///< between which the discretization is a part of the surface
  int euler_number = 2;                       ///< Euler characteristic of the whole
  std::optional<SurfaceDiscretization> split; ///< along the line around a domain, where the moment jumps there
  std::unique_ptr<SurfaceProblem> problem;
  std::unique_ptr<LinearSolver> solver;
  std::unique_ptr<SurfaceMotion> current_motion;
  SurfaceState last_iterate;                                     ///< of the last solve that failed
  SceneTargets targets;                                          ///< what the effects were given, internal units
  std::shared_ptr<const std::vector<ReferenceMetric>> reference; ///< of elastic skins
  std::map<std::string, std::shared_ptr<const std::vector<Vector3<double>>>> conormals; ///< of rims, by their names
  NodalConditions own_conditions; ///< those of the scene, without active sets
  std::vector<std::unique_ptr<ActiveSet>> active_sets;
  Surroundings own_surroundings; ///< of the application
  SurfaceMeasures own_measures;  ///< of the application
  StabilityParameters stability_parameters;
  bool analyses_stability = false;
  std::optional<Stability> last_stability;
  std::optional<LinearSolverReport> last_linear_solver;
  std::vector<std::pair<std::string, std::size_t>> last_unknown_counts;
};
} // namespace pellicle

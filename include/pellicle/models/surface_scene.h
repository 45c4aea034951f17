// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/nodal_conditions.h>
#include <pellicle/assembly/pair_term.h>
#include <pellicle/base/parameters.h>
#include <pellicle/discretization/refinement.h>
#include <pellicle/discretization/surface_discretization.h>
#include <pellicle/discretization/symmetric_part.h>
#include <pellicle/models/accuracy.h>
#include <pellicle/models/active_set.h>
#include <pellicle/models/stability.h>
#include <pellicle/models/surface_sample.h>
#include <pellicle/potentials/potential_library.h>
#include <pellicle/solvers/continuation.h>
#include <pellicle/solvers/load_stepping.h>
#include <pellicle/solvers/newton.h>
#include <pellicle/solvers/time_stepping.h>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pellicle
{
class SurfaceModel;

/** Section "Mesh". */
struct MeshParameters
{
  int degree           = 3;
  int refinements      = 2;
  std::string symmetry = "none";
  std::string file;
  /** Cells that are cut further, see Refinement: of a run that adapts its mesh, not of the scene. */
  std::vector<CellPlace> cut;

  Refinement refinement() const { return {static_cast<unsigned int>(refinements), cut}; }
  void bind(ParameterSection &section);
  bool is_axial() const { return symmetry == "axial" || symmetry == "axial mirror"; }
  /** The planes between which only a part of the surface is meshed. */
  MirrorPlanes mirror_planes() const;
};

/** Section "Continuation". */
struct BranchParameters
{
  std::string parameter; ///< "Section/Name"; empty: no continuation
  std::string direction      = "increasing";
  std::string at_bifurcation = "report";
  double amplitude           = 0.05;
  double scale               = 0.; ///< 0: chosen
  ContinuationParameters steps;

  void bind(ParameterSection &section);
};

/** Section "Output". */
struct OutputParameters
{
  bool solution = true;
  bool picture  = true;

  void bind(ParameterSection &section);
};

/** Section "Checkpoint". */
struct CheckpointParameters
{
  int every = 0; ///< steps; 0: never
  int keep  = 2;

  void bind(ParameterSection &section);
};

/**
 * A stage of the load path that a scene has of its own: a number of the scene, such as a weight, goes from 0 to the
 * value that the scene gives it.
 */
struct LoadStage
{
  std::string name;      ///< for the user, of what goes on: "gravity"
  std::string parameter; ///< "Section/Name"
};

/** Random displacements of the nodes of a start shape, in fractions of their spacing. */
struct NodeNoise
{
  double fraction = 0.;
  int seed        = 1;
};

/** What a picture shows beside a solved model: bodies. The user's units. */
using Surroundings = std::function<SurfaceSample(const SurfaceModel &)>;

/** What an application measures on a solved model beside what every surface has. Internal units. */
using SurfaceMeasures = std::function<std::vector<NamedQuantity>(const SurfaceModel &)>;

/**
 * A scene with one surface: the parameters that all applications share, the listed effects, and what a SurfaceModel
 * asks of it. Applications derive their own (VesicleScene, DropletScene): plain structs that a library user fills and
 * that a scene file is read into.
 */
class SurfaceScene
{
public:
  MeshParameters mesh;
  LoadParameters load;
  NewtonParameters newton;
  StabilityParameters stability;
  BranchParameters branch;
  AccuracyParameters accuracy;
  OutputParameters output;
  CheckpointParameters checkpoint;
  std::vector<std::unique_ptr<Effect>> effects;
  std::vector<std::string> analyses;

  virtual ~SurfaceScene() = default;

  /** Sections bound to the members; they must not outlive this object. */
  std::vector<ParameterSection> sections();

  /** Cross-checks between parameters. Throws UserError. */
  virtual void check() const;

  bool has_effect(const std::string &name) const;
  /** The listed effect of a type; null if it is not listed. */
  template <typename EffectType>
  const EffectType *find() const
  {
    for (const auto &effect : effects)
      if (const auto *found = dynamic_cast<const EffectType *>(effect.get()))
        return found;
    return nullptr;
  }
  bool has_analysis(const std::string &name) const;

  /** The scene's own length, and an energy typical of the effects. */
  Scales scales() const;
  /** Mesh and start shape, in the user's units. Throws UserError for one that cannot be made. */
  virtual SurfaceDiscretization start_mesh() const = 0;
  /** What has to be applied in turn, since the start shape is too far from equilibrium under the whole load; without a
   * load before the first of them nothing need be solvable. None: the scene is solved at once. */
  virtual std::vector<LoadStage> load_stages() const { return {}; }
  /** Whether the place of the origin means something: a body or a field of force stands there. Otherwise the model
   * moves the centroid there. */
  virtual bool has_origin() const { return false; }
  virtual NodeNoise node_noise() const { return {}; }
  /** Name of the reported quantity whose error Accuracy/Target bounds. */
  virtual std::string headline_quantity() const { return "total_energy"; }
  /** The meshes that a run to an accuracy goes through: from a coarse one, but none finer than the scene's own. */
  virtual LevelRange level_range() const;
  /** What makes one of them: parameters of the scene, as Section/Name, and their values. */
  virtual std::vector<std::pair<std::string, double>> level_settings(const LevelMesh &mesh) const;
  /** How the scene moves in time; null: it does not, an equilibrium is looked for. */
  virtual const TimeParameters *motion() const { return nullptr; }
  /** Nodal positions, in the user's units, at which elastic skins are free of stress; none: the start shape. */
  virtual std::optional<NodalVectors> reference_positions() const { return std::nullopt; }
  /** Name of the line along which the solved mesh is split; empty: none. */
  virtual std::string split_line() const { return ""; }
  /** Unit conormals of the start shape at the quadrature points of rims, by name, where clamps need them. */
  virtual std::map<std::string, std::vector<Vector3<double>>>
  rim_conormals(const SurfaceDiscretization & /*start*/) const
  {
    return {};
  }
  /** Edge loops of the surface and what holds them. */
  virtual std::vector<SceneEdge> edges() const = 0;
  /** What holds nodes, or keeps them on bodies. */
  virtual NodalConditions conditions(const SurfaceDiscretization &surface, const SceneTargets &targets) const;
  /** Inequalities that the listed effects bring. */
  virtual std::vector<std::unique_ptr<ActiveSet>> active_sets(const SurfaceDiscretization & /*surface*/,
                                                              const SceneTargets & /*targets*/) const
  {
    return {};
  }
  /** Terms that couple parts that meet, in internal units, and the tolerance of their multipliers. */
  virtual std::vector<std::shared_ptr<PairTerm>> pair_terms(const SurfaceDiscretization & /*surface*/,
                                                            const SceneTargets & /*targets*/) const
  {
    return {};
  }
  virtual double multiplier_tolerance() const { return 1e-8; }
  virtual SurfaceMeasures measures(const Scales & /*scales*/) const { return {}; }
  /** Empty: there are none. */
  virtual Surroundings surroundings() const { return {}; }

  /** What effects take from the undeformed mesh, at its quadrature points; internal units. */
  virtual void add_references(const SurfaceDiscretization & /*start*/, SceneTargets & /*targets*/) const {}
  /** What effects take from the scene and from each other; what only a mesh knows is left out. */
  SceneTargets targets(const Scales &scales) const;
  /** Energies and constraints in internal units. */
  PotentialSet potentials(const Scales &scales, const SceneTargets &targets) const;
  /** Derivatives with respect to all parameters in which the listed effects allow continuation. */
  std::vector<ParameterDerivative> derivatives(const Scales &scales, const SceneTargets &targets) const;
  PotentialSet potentials(const Scales &scales) const { return potentials(scales, targets(scales)); }

protected:
  SurfaceScene()                           = default;
  SurfaceScene(SurfaceScene &&)            = default;
  SurfaceScene &operator=(SurfaceScene &&) = default;

  /** The application's own sections, which come after "Mesh". */
  virtual void add_own_sections(std::vector<ParameterSection> &all) = 0;
  /** The application's own sections that come after "Continuation". */
  virtual void add_further_sections(std::vector<ParameterSection> & /*all*/) {}
  virtual double own_length() const = 0;
  /** An energy typical of the scene beside those of the effects, in the user's units. */
  virtual double own_energy(double /*length*/) const { return 0.; }
  /** Targets that the application's own sections set. */
  virtual void set_targets(const Scales &scales, SceneTargets &targets) const = 0;
  /** Whether the parameter shapes mesh or scale, so that it cannot change during a run. */
  virtual bool is_fixed(const std::string &parameter) const;

private:
  void check_accuracy() const;
};

/** Binds parameters as a further section. */
template <typename Parameters>
void add_section(std::vector<ParameterSection> &all, const std::string &name, Parameters &parameters)
{
  all.emplace_back(name);
  parameters.bind(all.back());
}

/** Fills the lists of a scene; effects with their parameters at the defaults. Throws UserError for an unknown effect.
 */
void list_effects(SurfaceScene &scene, const EffectLibrary &library, const std::vector<std::string> &effects,
                  const std::vector<std::string> &analyses);
} // namespace pellicle

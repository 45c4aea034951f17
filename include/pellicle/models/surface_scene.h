// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/constants.h>
#include <pellicle/base/parameters.h>
#include <pellicle/discretization/start_shapes.h>
#include <pellicle/models/stability.h>
#include <pellicle/potentials/potential_library.h>
#include <pellicle/solvers/continuation.h>
#include <pellicle/solvers/load_stepping.h>
#include <pellicle/solvers/newton.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pellicle
{
/** Name of the line around the region of the effect "lipid domain". */
constexpr const char *domain_boundary = "domain boundary";

/** Section "Mesh". */
struct MeshParameters
{
  int degree           = 3;
  int refinements      = 2;
  std::string symmetry = "none";
  std::string file;

  void bind(ParameterSection &section);
};

/** Section "Vesicle": start shape and targets of the constraints, in the user's units. */
struct VesicleParameters
{
  double area             = 4. * pi;
  double reduced_volume   = 0.9;
  std::string start_shape = "prolate";
  std::vector<double> semi_axes{1., 1., 1.2};
  double torus_ratio              = 1.4142135623730951;
  double cap_angle                = 90.;
  double tube_ratio               = 1.;
  std::string rim                 = "free";
  std::string reference_shape     = "start shape";
  double reference_area           = 4. * pi;
  double reference_reduced_volume = 0.95;
  double node_noise               = 0.;
  int random_seed                 = 1;

  void bind(ParameterSection &section);
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

/** Section "Phase diagram", for the analysis of that name. */
struct PhaseDiagramParameters
{
  std::vector<double> reduced_volumes{0.52, 0.54, 0.56, 0.58, 0.6,  0.62, 0.64, 0.66,
                                      0.68, 0.7,  0.75, 0.8,  0.85, 0.9,  0.95};
  std::string branches = "prolate, oblate, stomatocyte";
  int fold_points      = 20;

  void bind(ParameterSection &section);
  /** Throws UserError. */
  void check() const;
  /** The start shapes in `branches`. */
  std::vector<std::string> branch_names() const;
};

/** Section "Output". */
struct OutputParameters
{
  bool solution = true;
  bool picture  = true;

  void bind(ParameterSection &section);
};

/** All parameters of a scene with one surface: the plain structs that a library user fills and that a scene file is
 * read into. */
struct SurfaceScene
{
  MeshParameters mesh;
  VesicleParameters vesicle;
  LoadParameters load;
  NewtonParameters newton;
  StabilityParameters stability;
  BranchParameters branch;
  PhaseDiagramParameters phase_diagram;
  OutputParameters output;
  std::vector<std::unique_ptr<Effect>> effects;
  std::vector<std::string> analyses;

  /** Sections bound to the members; they must not outlive this object. */
  std::vector<ParameterSection> sections();

  /** Cross-checks between parameters. Throws UserError. */
  void check() const;

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
  Scales scales() const;        ///< length sqrt(A/4 pi), energy typical of the effects
  double target_volume() const; ///< v (4 pi/3) (A/4 pi)^(3/2), the user's units

  StartShape start_shape() const;
  /** The reference shape of elastic skins, on the same mesh; none if it is the start shape. */
  std::optional<StartShape> reference_shape() const;
  /** Whether the moment jumps across the line around a domain, so that the mesh must be split there. */
  bool splits_domain() const;
  /** Edge loops of the surface and what holds them. */
  std::vector<SceneEdge> edges() const;
  /** What effects take from the scene and from each other; what only a mesh knows is left out. */
  SceneTargets targets(const Scales &scales) const;
  /** Energies and constraints in internal units. */
  PotentialSet potentials(const Scales &scales, const SceneTargets &targets) const;
  /** Derivatives with respect to all parameters in which the listed effects allow continuation. */
  std::vector<ParameterDerivative> derivatives(const Scales &scales, const SceneTargets &targets) const;
  PotentialSet potentials(const Scales &scales) const { return potentials(scales, targets(scales)); }
};

/** A scene with the named effects of a library, parameters at their defaults. Throws UserError for an unknown effect.
 */
SurfaceScene make_surface_scene(const EffectLibrary &library, const std::vector<std::string> &effects,
                                const std::vector<std::string> &analyses);

/** Names of the analyses that can be listed. */
const std::vector<std::string> &analysis_names();
} // namespace pellicle

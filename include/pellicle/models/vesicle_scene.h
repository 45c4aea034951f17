// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/constants.h>
#include <pellicle/discretization/start_shapes.h>
#include <pellicle/models/surface_scene.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pellicle
{
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

/** A vesicle, or an open membrane. */
class VesicleScene : public SurfaceScene
{
public:
  VesicleParameters vesicle;
  PhaseDiagramParameters phase_diagram;

  void check() const override;
  double target_volume() const; ///< v (4 pi/3) (A/4 pi)^(3/2), the user's units
  StartShape start_shape() const;
  /** The reference shape of elastic skins, on the same mesh; none if it is the start shape. */
  std::optional<StartShape> reference_shape() const;
  /** Whether a field jumps across the line around a domain, here the moment, so that the mesh must be split there. */
  virtual bool splits_domain() const;

  SurfaceDiscretization start_mesh() const override;
  NodeNoise node_noise() const override { return {vesicle.node_noise, vesicle.random_seed}; }
  std::optional<NodalVectors> reference_positions() const override;
  std::string split_line() const override;
  std::map<std::string, std::vector<Vector3<double>>> rim_conormals(const SurfaceDiscretization &start) const override;
  std::vector<SceneEdge> edges() const override;
  SurfaceMeasures measures(const Scales &scales) const override;
  std::string headline_quantity() const override;
  LevelRange level_range() const override;

protected:
  void add_own_sections(std::vector<ParameterSection> &all) override;
  void add_further_sections(std::vector<ParameterSection> &all) override;
  double own_length() const override;
  void set_targets(const Scales &scales, SceneTargets &targets) const override;
  bool is_fixed(const std::string &parameter) const override;

private:
  /** What a part between planes of symmetry cannot be. Throws UserError. */
  void check_part() const;
};

/** A scene with the named effects of a library, parameters at their defaults. Throws UserError for an unknown effect.
 */
VesicleScene make_vesicle_scene(const EffectLibrary &library, const std::vector<std::string> &effects,
                                const std::vector<std::string> &analyses);
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/models/surface_scene.h>

#include <memory>
#include <string>
#include <vector>

namespace pellicle
{
/** Section "Droplet" of a drop on a soft substrate, in the user's units. */
struct RestingDropParameters
{
  double volume      = 2.;
  double body_force  = 0.;
  double inclination = 0.; ///< degrees

  void bind(ParameterSection &section);
};

/** Section "Contact line". */
struct ContactLineParameters
{
  double radius      = 1.; ///< of the undeformed line
  std::string motion = "pinned";
  double cell_size   = 0.02; ///< at the line

  void bind(ParameterSection &section);
};

/** Section "Tensions". */
struct TensionParameters
{
  double liquid_gas   = 0.08;
  double solid_liquid = 0.06;
  double solid_gas    = 0.06;
  double scale        = 1.; ///< factor on all of them

  void bind(ParameterSection &section);
};

/** Section "Substrate" of drops on soft solids. */
struct SoftSubstrateParameters
{
  std::string shape   = "cylinder";
  double half_width   = 2.; ///< or the cylinder's radius
  double thickness    = 1.;
  double young        = 1.;
  double poisson      = 0.3;
  std::string lateral = "free";
  std::string bottom  = "clamped";
  int azimuthal_cells = 16; ///< around the whole line
  std::string part    = "half";

  void bind(ParameterSection &section);
};

/**
 * A drop on a soft solid: the undeformed substrate lies below z = 0, the drop's axis is the z axis. Gravity acts on the
 * liquid along (sin a, 0, -cos a) with the inclination a, as on rigid substrates. Theory: Sauer 2014, Sections 2.3 and
 * 5, with a contact line that may also move over the material.
 */
class RidgeScene : public SurfaceScene
{
public:
  RestingDropParameters droplet;
  ContactLineParameters line;
  TensionParameters tensions;
  SoftSubstrateParameters substrate;

  /** A meridian, for most scenes are axisymmetric. */
  RidgeScene() { mesh.symmetry = "axial"; }

  void check() const override;
  SurfaceDiscretization start_mesh() const override;
  bool has_origin() const override { return true; }
  /** Tensions, then gravity, then the inclination, as in Sauer 2014. */
  std::vector<LoadStage> load_stages() const override;
  std::vector<SceneEdge> edges() const override;
  NodalConditions conditions(const SurfaceDiscretization &surface, const SceneTargets &targets) const override;
  /** Of a free line with thresholds. */
  std::vector<std::unique_ptr<ActiveSet>> active_sets(const SurfaceDiscretization &surface,
                                                      const SceneTargets &targets) const override;
  SurfaceMeasures measures(const Scales &scales) const override;
  std::string headline_quantity() const override { return "ridge_radius"; }
  LevelRange level_range() const override;
  std::vector<std::pair<std::string, double>> level_settings(const LevelMesh &mesh) const override;
  void add_references(const SurfaceDiscretization &start, SceneTargets &targets) const override;

protected:
  void add_own_sections(std::vector<ParameterSection> &all) override;
  double own_length() const override { return line.radius; }
  double own_energy(double length) const override;
  void set_targets(const Scales &scales, SceneTargets &targets) const override;
  bool is_fixed(const std::string &parameter) const override;

private:
  bool is_axial() const { return mesh.symmetry == "axial"; }
  /** What only an effect reads may differ from 0 only where that effect is listed. Throws UserError. */
  void check_not_idle(const std::string &parameter, double value, const std::string &effect) const;
  bool line_is_free() const { return line.motion == "free"; }
  /** Whether a free line has a threshold. */
  bool line_sticks() const;
  std::vector<RigidMotion> free_motions() const;
};

/** A scene with the named effects of a library, parameters at their defaults. Throws UserError for an unknown effect.
 */
RidgeScene make_ridge_scene(const EffectLibrary &library, const std::vector<std::string> &effects,
                            const std::vector<std::string> &analyses);
} // namespace pellicle

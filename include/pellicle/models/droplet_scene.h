// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/constants.h>
#include <pellicle/models/substrate.h>
#include <pellicle/models/surface_scene.h>

#include <memory>
#include <string>
#include <vector>

namespace pellicle
{
/** Section "Droplet", in the user's units. */
struct DropletParameters
{
  double volume        = 2. * pi / 3.;
  double contact_angle = 90.; ///< degrees
  std::string angle_field;    ///< theta(x, y) in degrees; empty: contact_angle everywhere
  double surface_tension  = 1.;
  double bond_number      = 0.;
  double inclination      = 0.; ///< degrees
  std::string base        = "eliminated";
  double reference_volume = 0.; ///< 0: volume

  void bind(ParameterSection &section);
};

/**
 * A drop on a rigid substrate. The frame is that of the substrate: it passes through the origin with normal e_z there,
 * and gravity turns instead, rho b = rho g (sin a, 0, -cos a) with the inclination a.
 */
class DropletScene : public SurfaceScene
{
public:
  DropletParameters droplet;
  SubstrateParameters substrate;

  /** R_eq = (3V/4 pi)^(1/3), the user's units. */
  double equivalent_radius() const;
  void check() const override;
  SurfaceDiscretization start_mesh() const override;
  bool has_origin() const override { return true; }
  std::vector<SceneEdge> edges() const override;
  NodalConditions conditions(const SurfaceDiscretization &surface, const SceneTargets &targets) const override;
  std::optional<NodalVectors> reference_positions() const override;
  /** Of line pinning and contact. */
  std::vector<std::unique_ptr<ActiveSet>> active_sets(const SurfaceDiscretization &surface,
                                                      const SceneTargets &targets) const override;
  SurfaceMeasures measures(const Scales &scales) const override;
  Surroundings surroundings() const override;

protected:
  void add_own_sections(std::vector<ParameterSection> &all) override;
  double own_length() const override { return equivalent_radius(); }
  double own_energy(double length) const override;
  void set_targets(const Scales &scales, SceneTargets &targets) const override;
  bool is_fixed(const std::string &parameter) const override;

private:
  bool has_two_plates() const;
  bool is_cap_only() const { return droplet.base == "eliminated"; }
  bool has_line() const;
  void check_line_pinning() const;
  /** What a part between planes of symmetry cannot be. Throws UserError. */
  void check_part() const;
  /** Whether gravity is normal to the substrate at the origin. */
  bool is_level() const;
  /** Whether the drop's weight has a part along the substrate at the origin. */
  bool is_pulled_along() const;
  /** Unit vector in the substrate's frame. */
  Vector3<double> direction_of_gravity() const;
  std::vector<RigidMotion> free_motions() const;
};

/** A scene with the named effects of a library, parameters at their defaults. Throws UserError for an unknown effect.
 */
DropletScene make_droplet_scene(const EffectLibrary &library, const std::vector<std::string> &effects,
                                const std::vector<std::string> &analyses);
} // namespace pellicle

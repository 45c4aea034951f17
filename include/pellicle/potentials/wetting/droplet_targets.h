// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/kinematics/gap.h>
#include <pellicle/potentials/wetting/substrate_chart.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pellicle
{
/** Name of the line where a drop's liquid-gas surface meets the substrate; of the one on an upper plate. */
constexpr const char *contact_line       = "contact line";
constexpr const char *upper_contact_line = "upper contact line";
/** Regions of a drop whose wetted base is a membrane of its own. */
constexpr const char *liquid_gas_region = "liquid gas";
constexpr const char *base_region       = "base";

/** A wetted base that has no surface of its own: it enters by integrals along its line. */
struct WettedBase
{
  std::string line; ///< name of the edge loop
  SubstrateChart chart;
};

/** Contact angles in radians between which a contact line sticks; pi and 0: it does so at any angle. */
struct PinningAngles
{
  double advancing = 0.;
  double receding  = 0.;
};

/** What the effects of a drop take from its scene, internal units. */
struct DropletTargets
{
  double surface_tension = 1.; ///< gamma of the liquid-gas surface
  double contact_angle   = 0.; ///< theta in radians
  /** theta(x, y) in degrees; null: the same everywhere. */
  std::shared_ptr<const FunctionOfPlace> contact_angle_field;
  Vector3<double> body_force;            ///< rho b at Bond number and inclination of the scene
  Vector3<double> force_per_bond_number; ///< on a soft substrate: per unit of the scene's body force
  double unit_of_place = 1.;             ///< the scene's length in the user's units
  std::vector<WettedBase> bases;
  bool has_base_membrane = false; ///< the wetted base is a region of the surface
  /** Regions of the surface that bound the liquid; empty: all of it does. */
  std::vector<std::string> bounded_by;
  std::vector<std::shared_ptr<const RigidBody>> bodies;
  std::vector<SubstrateChart> walls;    ///< their surfaces, one each
  std::optional<PinningAngles> pinning; ///< of scenes whose contact line sticks
  /** Of the base with the given line; the plane z = 0 if that base is a membrane. */
  SubstrateChart chart_of(const std::string &line) const
  {
    for (const WettedBase &base : bases)
      if (base.line == line)
        return base.chart;
    return PlaneChart{};
  }
};
} // namespace pellicle

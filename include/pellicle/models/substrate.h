// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/parameters.h>
#include <pellicle/kinematics/gap.h>
#include <pellicle/potentials/wetting/substrate_chart.h>

#include <limits>
#include <memory>
#include <optional>
#include <string>

namespace pellicle
{
/** Section "Substrate" of drops on rigid bodies, in the user's units. */
struct SubstrateParameters
{
  std::string shape     = "plane";
  double radius         = 1.;
  std::string side      = "outside";
  std::string height    = "0";
  double plate_distance = std::numeric_limits<double>::infinity();

  void bind(ParameterSection &section);
};

/** A rigid substrate in internal units: as a body on which nodes stay, and as a chart over which base integrals run. */
struct Substrate
{
  std::shared_ptr<const RigidBody> body;
  SubstrateChart chart;
};

/** The plate z = `Plate distance` above the drop, if there is one. */
std::optional<Substrate> make_upper_plate(const SubstrateParameters &parameters, double unit);

/** `unit`: length in the user's units. Throws UserError for a height that is no function of x and y. */
Substrate make_substrate(const SubstrateParameters &parameters, double unit);
} // namespace pellicle

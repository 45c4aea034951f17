// SPDX-License-Identifier: LGPL-2.1-or-later
// Drops on the plane z = 0 by the full system (the liquid is a body with a pressure of its own) and by the reduced one
// (a constraint of volume and integrals over the surface), on the same cap.
#pragma once

#include "body_runs.h"

#include <pellicle/base/constants.h>
#include <pellicle/discretization/filled_cap.h>
#include <pellicle/discretization/point_walk.h>
#include <pellicle/potentials/constraints/enclosed_volume.h>
#include <pellicle/potentials/energies/gravity.h>
#include <pellicle/potentials/energies/surface_tension.h>
#include <pellicle/potentials/solids/body_force.h>
#include <pellicle/potentials/solids/compressible_liquid.h>
#include <pellicle/potentials/solids/incompressible_liquid.h>
#include <pellicle/potentials/solids/shear_drag.h>
#include <pellicle/potentials/wetting/base_integral.h>

#include <cmath>

namespace pellicle::test
{
inline const Where in_liquid{Where::Part::bulk, "liquid"};

/** Area of a spherical cap of contact angle theta and volume V. */
inline double cap_area(const double theta, const double volume)
{
  const double h = 1. - std::cos(theta), R = std::cbrt(volume / (pi / 3. * h * h * (3. - h)));
  return 2. * pi * R * R * h;
}

/** gamma = 1: liquid-gas surface and wetted base. */
inline PotentialSet surfaces_of_drop(const double theta)
{
  PotentialSet set;
  set.energies.push_back(std::make_shared<DensityPotential<SurfaceTension>>("liquid surface", SurfaceTension{1.}));
  set.energies.push_back(make_wetting("wetting", PlaneChart{}, {-1., {std::cos(theta), nullptr}}, "rim"));
  return set;
}

/** Nodes of the cap move along its normals at the given positions, those of the line along the plane. */
inline NodalConditions graph_of_cap(const SurfaceDiscretization &drop, const NodalVectors &positions)
{
  NodalConditions conditions;
  auto &only                 = conditions["position"].only;
  const NodalVectors normals = nodal_normals(drop, positions);
  only.resize(drop.n_nodes);
  std::vector<std::size_t> on_cap(drop.cell_nodes);
  for (const std::size_t I : on_cap)
  {
    AdmissibleDirections along;
    along.count      = 1;
    along.columns    = {};
    along.columns[0] = {{normals[3 * I], normals[3 * I + 1], normals[3 * I + 2]}};
    only[I]          = along;
  }
  return conditions;
}
} // namespace pellicle::test

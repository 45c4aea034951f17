// SPDX-License-Identifier: LGPL-2.1-or-later
// Drops for the tests, and the spherical cap as their closed form.
#pragma once

#include "equilibrium_runs.h"

#include <pellicle/models/droplet_scene.h>

namespace pellicle::test
{
constexpr double degree = pi / 180.;
/** Volume of the references; with it rho g = 1 is this Bond number. */
constexpr double reference_volume = 2. * pi / 3.;
constexpr double unit_bond_number = 0.6299605249474366;

struct DropMesh
{
  const char *symmetry;
  int degree, refinements;
};

inline DropletScene drop(const double angle, const DropMesh &mesh, const std::vector<std::string> &more_effects = {})
{
  std::vector<std::string> effects{"liquid surface", "volume constraint", "wetting"};
  effects.insert(effects.end(), more_effects.begin(), more_effects.end());
  DropletScene scene          = make_droplet_scene(droplet_effects(), effects, {"stability"});
  scene.stability.eigenvalues = 0;
  scene.droplet.volume        = reference_volume;
  scene.droplet.contact_angle = angle;
  scene.mesh.symmetry         = mesh.symmetry;
  scene.mesh.degree           = mesh.degree;
  scene.mesh.refinements      = mesh.refinements;
  return scene;
}

inline DropletScene heavy_drop(const double angle, const DropMesh &mesh)
{
  DropletScene scene        = drop(angle, mesh, {"gravity"});
  scene.droplet.bond_number = unit_bond_number;
  return scene;
}

/** A drop without weight on a plane: contact radius for the angle in degrees. */
inline double radius_of_cap(const double angle, const double volume = reference_volume)
{
  const double c = std::cos(angle * degree);
  return std::cbrt(3. * volume / (pi * (1. - c) * (1. - c) * (2. + c))) * std::sin(angle * degree);
}

/** The angle at which angle(radius) agrees with a cap's radius, by bisection. */
inline double angle_of_cap(const std::function<double(double radius)> &angle, double low, double high)
{
  for (int i = 0; i < 60; ++i)
  {
    const double middle                                  = 0.5 * (low + high);
    (angle(radius_of_cap(middle)) > middle ? low : high) = middle;
  }
  return 0.5 * (low + high);
}
} // namespace pellicle::test

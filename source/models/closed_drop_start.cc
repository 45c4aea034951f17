// SPDX-License-Identifier: LGPL-2.1-or-later
// Start shapes of drops and balloons whose whole surface is there: closed surfaces that touch bodies.
#include <pellicle/discretization/builders.h>
#include <pellicle/discretization/joined.h>
#include <pellicle/discretization/start_shapes.h>
#include <pellicle/models/droplet_start.h>

#include <algorithm>
#include <cmath>

namespace pellicle
{
namespace
{
/** Radius of the flat base of a drop that does not wet: its weight over the pressure of a sphere. */
double base_of_weight(const DropletScene &scene, const double radius)
{
  const double per_radius = std::abs(scene.droplet.bond_number) / (radius * radius);
  const double weight = per_radius * 4. * pi / 3. * std::pow(radius, 3), pressure = 2. / radius + per_radius * radius;
  return std::min(0.9 * radius, std::sqrt(weight / (pi * pressure)));
}
} // namespace

SurfaceDiscretization sphere_of_volume(const DropletScene &scene, const double volume)
{
  StartShape sphere;
  sphere.name        = "ellipsoid";
  sphere.area        = 4. * pi * std::pow(3. * volume / (4. * pi), 2. / 3.);
  sphere.degree      = static_cast<unsigned int>(scene.mesh.degree);
  sphere.refinements = static_cast<unsigned int>(scene.mesh.refinements);
  sphere.axial       = scene.mesh.symmetry == "axial";
  return make_start_shape(sphere);
}

SurfaceDiscretization resting_sphere(const DropletScene &scene)
{
  SurfaceDiscretization surface = sphere_of_volume(scene, scene.droplet.volume);
  const double R                = std::cbrt(3. * scene.droplet.volume / (4. * pi));
  const double base = scene.has_effect("liquid surface") && scene.has_effect("gravity") ? base_of_weight(scene, R) : 0.;
  const double centre = std::sqrt(R * R - base * base), upper = scene.substrate.plate_distance;
  for (std::size_t I = 0; I < surface.n_nodes; ++I)
  {
    double &z = surface.positions[3 * I + 2];
    z         = std::clamp(z + centre, 0., upper);
  }
  return surface;
}

SurfaceDiscretization cap_with_base(const DropletScene &scene)
{
  const SurfaceDiscretization upper = droplet_cap(scene);
  const bool axial                  = scene.mesh.symmetry == "axial";
  const std::size_t on_rim          = upper.edges.front().cell_nodes.front();
  const double rim                  = std::hypot(upper.positions[3 * on_rim], upper.positions[3 * on_rim + 1]);
  const SurfaceDiscretization lower =
      disc(pi * rim * rim, upper.degree, static_cast<unsigned int>(scene.mesh.refinements), axial);
  return joined(upper, lower, liquid_gas_region, base_region);
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
// Start shapes of drops and balloons whose whole surface is there: closed surfaces that touch bodies.
#include <pellicle/base/exact_text.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/builders.h>
#include <pellicle/discretization/closed_at_rim.h>
#include <pellicle/discretization/start_shapes.h>
#include <pellicle/models/droplet_start.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pellicle
{
namespace
{
constexpr double shallowest = 0.8; // distance of plates over the diameter of an elastic start sphere

/** Radius of the flat base of a drop that does not wet: its weight over the pressure of a sphere. */
double base_of_weight(const DropletScene &scene, const double radius)
{
  const double per_radius = std::abs(scene.droplet.bond_number) / (radius * radius);
  const double weight = per_radius * 4. * pi / 3. * std::pow(radius, 3), pressure = 2. / radius + per_radius * radius;
  return std::min(0.9 * radius, std::sqrt(weight / (pi * pressure)));
}

/** Outline (r, z) of a flattened drop: flat above and below with radius a, half circles between the plates 0 and h. */
struct Pancake
{
  double a = 0., h = 1.;

  /** From V = pi h (a^2 + pi a h/4 + h^2/6). */
  static Pancake of_volume(const double volume, const double h)
  {
    const double p = pi * h / 8., q = h * h / 6. - volume / (pi * h);
    return {-p + std::sqrt(p * p - q), h};
  }
  /** At a fraction t of the outline's length, from the top. */
  std::array<double, 2> at(const double t) const
  {
    const double side = 0.5 * pi * h, s = t * (2. * a + side);
    if (s <= a)
      return {{s, h}};
    if (s >= a + side)
      return {{std::max(0., 2. * a + side - s), 0.}};
    const double angle = (s - a) / (0.5 * h);
    return {{a + 0.5 * h * std::sin(angle), 0.5 * h * (1. + std::cos(angle))}};
  }
};
/** Places in the base's own coordinates: of the whole it is the second patch, run through from its end. Only meridians
 * know places of both. */
std::vector<CellPlace> cut_in_base(const std::vector<CellPlace> &cut)
{
  std::vector<CellPlace> own;
  for (const CellPlace &place : cut)
    if (place.patch == 1)
      own.push_back({0, 1. - place.u0 - place.size, 0., place.size});
  return own;
}
} // namespace

SurfaceDiscretization sphere_of_volume(const DropletScene &scene, const double volume)
{
  StartShape sphere;
  sphere.name        = "ellipsoid";
  sphere.area        = 4. * pi * std::pow(3. * volume / (4. * pi), 2. / 3.);
  sphere.degree      = static_cast<unsigned int>(scene.mesh.degree);
  sphere.refinements = static_cast<unsigned int>(scene.mesh.refinements);
  sphere.cut         = scene.mesh.cut;
  sphere.axial       = scene.mesh.symmetry == "axial";
  return make_start_shape(sphere);
}

SurfaceDiscretization resting_sphere(const DropletScene &scene)
{
  SurfaceDiscretization surface = sphere_of_volume(scene, scene.droplet.volume);
  const double R                = scene.equivalent_radius();
  if (scene.substrate.plate_distance < 2. * R && scene.has_effect("liquid surface"))
  {
    const Pancake outline = Pancake::of_volume(scene.droplet.volume, scene.substrate.plate_distance);
    for (std::size_t I = 0; I < surface.n_nodes; ++I)
    {
      double *const x      = surface.positions.data() + 3 * I;
      const double rho     = std::hypot(x[0], x[1]);
      const auto [r, z]    = outline.at(std::atan2(rho, x[2]) / pi);
      const double stretch = rho > 0. ? r / rho : 0.;
      x[0] *= stretch;
      x[1] *= stretch;
      x[2] = z;
    }
    surface.mesh_reference = surface.positions;
    return surface;
  }
  if (scene.substrate.plate_distance < shallowest * 2. * R)
    throw UserError(
        "Substrate/Plate distance = " + exact_text(scene.substrate.plate_distance) +
        ": the sphere that the run starts from, of diameter " + exact_text(2. * R) +
        ", is too deep in the plates. Start where they barely touch it and close them in steps: section Load "
        "with Parameter = Substrate/Plate distance and From = " +
        exact_text(2. * R) + ".");
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
      disc(pi * rim * rim, upper.degree, {scene.mesh.refinement().uniform, cut_in_base(scene.mesh.cut)}, axial);
  return closed_at_rim(upper, lower, liquid_gas_region, base_region);
}
} // namespace pellicle

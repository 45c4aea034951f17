// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exact_text.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/base/expression_of_place.h>
#include <pellicle/discretization/builders.h>
#include <pellicle/kinematics/find_kink.h>
#include <pellicle/models/droplet_start.h>

#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pellicle
{
namespace
{
constexpr double degree   = pi / 180.;
constexpr double steepest = 175. * degree; // polar angle of the rim of a start cap
// Where the drop overhangs, cells grow away from the line by crowding times the cotangent per radian: halves the digits
// that are lost between 90 and 150 degrees.
constexpr double crowding = 0.2;
// Of the way to the cap that gravity makes, and how much more cells then crowd at the line of an overhanging drop,
// which is most curved there: times the cosine, per radian by which the start is too flat. Of 15 pairs that with the
// smallest errors at rho g = 1 (axial, Q3, 8 cells, 90, 120 and 150 degrees). A share of 0.2 is too little for 165
// degrees to converge.
constexpr double share_of_gravity      = 0.7;
constexpr double crowding_from_gravity = 3.5;
constexpr double flattest              = 2. * degree; // below it the start is a disc
constexpr double largest_covered_angle = 0.98 * pi;   // of a sphere by the base

/** Volume of a spherical cap over the radius cubed, polar angle a of the rim; negative for a < 0. */
double cap_volume(const double a)
{
  const double h = 1. - std::cos(a);
  return std::copysign(pi / 3. * h * h * (3. - h), a);
}

/** Volume over a flat base of unit radius below a cap whose rim has polar angle a. */
double volume_over_disc(const double a)
{
  return std::abs(a) < 1e-4 ? pi / 4. * a : cap_volume(a) / std::pow(std::abs(std::sin(a)), 3);
}

/** Gravity spreads or draws up a drop: polar angle of the rim of the cap on a plane with the least energy among the
 * spherical caps of its volume (Ritz's method with one unknown). At rho g = 1 within 1% of the contact radius up to 120
 * degrees, 6% at 150.
 */
double settled_angle(const DropletParameters &droplet)
{
  const double theta = droplet.contact_angle * degree;
  const double bond  = droplet.bond_number * std::cos(droplet.inclination * degree);
  if (bond == 0.)
    return theta;
  const double volume = 4. * pi / 3.; // R_eq = 1, gamma = 1
  const auto energy   = [&](const double a)
  {
    const double radius = std::cbrt(volume / cap_volume(a)), base = radius * std::sin(a);
    const double height = radius * (1. - std::cos(a));
    const double centre = height * (4. * radius - height) / (4. * (3. * radius - height)); // of mass, above the plane
    return 2. * pi * radius * height - std::cos(theta) * pi * base * base + bond * volume * centre;
  };
  return boost::math::tools::brent_find_minima(energy, 0.1 * std::min(theta, steepest), steepest, 20).first;
}

StartCap on_plane(const double volume, const double angle)
{
  const double a      = std::min(angle, steepest);
  const double radius = std::cbrt(volume / cap_volume(a));
  return {a, 2. * pi * radius * radius * (1. - std::cos(a)), 0., 0.};
}

/** The base covers the polar angle b of the sphere, s = 1: outside, -1: inside; the cap's rim has polar angle
 * theta + s b. */
StartCap on_sphere(const double volume, const double angle, const double R, const double s)
{
  const auto rim_angle = [&](const double b) { return std::min(angle + s * b, steepest); };
  const auto volume_at = [&](const double b)
  { return std::pow(R * std::sin(b), 3) * volume_over_disc(rim_angle(b)) - s * R * R * R * cap_volume(b); };
  // Outside, the cap opens with the base until it wraps around the sphere.
  const double most = s > 0. ? std::max(steepest - angle, 0.5 * pi) : largest_covered_angle;
  if (volume > volume_at(most))
    throw UserError("Droplet/Volume = " + exact_text(volume) +
                    " does not fit: " + (s > 0. ? "the drop would wrap around" : "the drop would fill") +
                    " the sphere of Substrate/Radius = " + exact_text(R) + ". Less than " +
                    exact_text(volume_at(most)) + " fits at this contact angle.");
  std::uintmax_t iterations = 100;
  const auto bracket = boost::math::tools::toms748_solve([&](const double b) { return volume_at(b) - volume; }, 0.,
                                                         most, -volume, volume_at(most) - volume,
                                                         boost::math::tools::eps_tolerance<double>(48), iterations);
  const double b = 0.5 * (bracket.first + bracket.second), a = rim_angle(b), rim = R * std::sin(b);
  const double rim_height = -s * R * (1. - std::cos(b));
  if (std::abs(a) < flattest)
    return {0., pi * rim * rim, rim_height, 0.};
  const double radius = rim / std::sin(a);
  return {a, 2. * pi * radius * radius * (1. - std::cos(a)), rim_height, 0.};
}

/** Names the place if the substrate is not smooth along the rim. */
void check_smooth_along(const EdgeLoop &rim, const SurfaceDiscretization &mesh, const ExpressionOfPlace &height)
{
  const std::size_t n_nodes = rim.tables.n_nodes;
  std::vector<std::pair<double, double>> places;
  const auto add = [&](const std::size_t node)
  { places.emplace_back(mesh.positions[3 * node], mesh.positions[3 * node + 1]); };
  if (n_nodes == 1) // a meridian: the circle of its last node
  {
    const double r      = mesh.positions[3 * rim.cell_nodes.front()];
    constexpr int sides = 64;
    for (int i = 0; i < sides; ++i)
      places.emplace_back(r * std::cos(2. * pi * i / sides), r * std::sin(2. * pi * i / sides));
  }
  else
    for (std::size_t c = 0; c < rim.n_cells; ++c)
      for (std::size_t i = 0; i + 1 < n_nodes; ++i)
        add(rim.cell_nodes[c * n_nodes + i]);
  const auto polygon = [&](const double s)
  {
    const double t          = s * static_cast<double>(places.size());
    const std::size_t first = std::min(static_cast<std::size_t>(t), places.size() - 1);
    const auto &a = places[first], &b = places[(first + 1) % places.size()];
    const double u = t - static_cast<double>(first);
    return std::pair<double, double>(a.first + u * (b.first - a.first), a.second + u * (b.second - a.second));
  };
  if (const std::optional<Kink> kink = find_kink(height, polygon))
    throw UserError("Substrate/Height = " + height.text() +
                    " is not twice differentiable at x = " + exact_text(kink->x) + ", y = " + exact_text(kink->y) +
                    ", on the contact line of the start shape. Newton's method needs a smooth height there: round the "
                    "kink off, for example abs(x) as sqrt(x^2 + 0.01^2).");
}
} // namespace

StartCap start_cap(const DropletParameters &droplet, const SubstrateParameters &substrate)
{
  const auto cap_with = [&](const double angle)
  {
    return substrate.shape == "sphere"
               ? on_sphere(droplet.volume, angle, substrate.radius, substrate.side == "outside" ? 1. : -1.)
               : on_plane(droplet.volume, angle);
  };
  const double theta   = droplet.contact_angle * degree,
               settled = theta + share_of_gravity * (settled_angle(droplet) - theta);
  StartCap shape       = cap_with(settled);
  // The steepness at the line is that of the contact angle, which a flattened cap does not have.
  const double steepness = cap_with(theta).rim_angle;
  if (steepness > 0.5 * pi)
    shape.growth =
        -crowding / std::tan(steepness) - crowding_from_gravity * std::cos(steepness) * std::max(0., theta - settled);
  return shape;
}

SurfaceDiscretization droplet_cap(const DropletScene &scene)
{
  const StartCap shape = start_cap(scene.droplet, scene.substrate);
  const auto k         = static_cast<unsigned int>(scene.mesh.degree);
  const Refinement r   = scene.mesh.refinement();
  const bool axial     = scene.mesh.symmetry == "axial";
  const double angle   = std::abs(shape.rim_angle);
  SurfaceDiscretization surface =
      angle > 0. ? cap(angle, shape.area, k, r, axial, shape.growth) : disc(shape.area, k, r, axial);
  EdgeLoop &rim             = surface.edges.front();
  rim.name                  = contact_line;
  const Substrate substrate = make_substrate(scene.substrate, 1.);
  const auto *field         = std::get_if<HeightChart>(&substrate.chart);
  if (field != nullptr)
    check_smooth_along(rim, surface, dynamic_cast<const ExpressionOfPlace &>(*field->height));
  for (std::size_t I = 0; I < surface.n_nodes; ++I)
  {
    double *const x = surface.positions.data() + 3 * I;
    x[2]            = std::copysign(x[2], shape.rim_angle); // a mirrored cap has its normal on the gas's side, too
    x[2] += shape.rim_height + (field != nullptr ? field->height->at(x[0], x[1]).value : 0.);
  }
  for (const std::size_t node : rim.cell_nodes)
  {
    double *const x            = surface.positions.data() + 3 * node;
    const Vector3<double> foot = substrate.body->gap({x[0], x[1], x[2]}).foot;
    for (unsigned int c = 0; c < 3; ++c)
      x[c] = foot[c];
  }
  surface.mesh_reference = surface.positions;
  return surface;
}
} // namespace pellicle

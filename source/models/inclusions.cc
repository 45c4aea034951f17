// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/edge_frames.h>
#include <pellicle/base/exact_text.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/builders.h>
#include <pellicle/models/inclusions.h>

#include <algorithm>
#include <cmath>

namespace pellicle
{
namespace
{
using Direction = Vector3<double>;

const std::string on_ring = "inclusion", on_disc = "two inclusions", on_sphere = "inclusion on vesicle";

/** Cells at the inclusion over the shortest length of the problem, on the coarsest mesh. */
constexpr double first_cell = 0.4;

const Direction e_z(0., 0., 1.);

double sphere_radius(const double area)
{
  return std::sqrt(area / (4. * pi));
}

/** Of a sphere of the given area. */
double area_outside_cap(const double area, const double polar_angle)
{
  return area * 0.5 * (1. + std::cos(polar_angle));
}

/** A rigid disc in a plane, or around the lowest point of a sphere, and its surroundings. */
struct RigidDisc
{
  double tilt, radius;
  Direction centre;
  double sphere = 0.; ///< radius of the sphere, whose centre `centre` then is; 0: a plane

  Direction normal(const Direction &x) const { return sphere > 0. ? (1. / sphere) * (x - centre) : e_z; }
  double distance(const Direction &x) const
  {
    if (sphere == 0.)
      return norm(x - centre) - radius;
    const Direction n = normal(x);
    return sphere * (std::atan2(std::hypot(n[0], n[1]), -n[2]) - std::asin(radius / sphere));
  }
  /** Unit tangent away from the disc. */
  Direction away(const Direction &x) const
  {
    const Direction n = normal(x);
    return unit_or(sphere > 0. ? e_z - n[2] * n : x - centre, Direction());
  }
  /** Tilt at a point, as an angle along away(). */
  double tilt_at(const Direction &x, const double decay_length) const
  {
    const double s = std::max(0., distance(x));
    return tilt * std::sqrt(radius / (radius + s)) * std::exp(-s / decay_length);
  }
};

/** In the order of their rims. */
std::vector<RigidDisc> rigid_discs(const std::string &shape, const InclusionParameters &p, const double area)
{
  if (shape == on_sphere)
  {
    const double R = sphere_radius(area);
    return {{p.edge_tilt, R * std::sin(p.polar_angle), Direction(0., 0., R * std::cos(p.polar_angle)), R}};
  }
  if (shape == on_ring)
    return {{p.edge_tilt, p.radius, Direction()}};
  const Direction half(0.5 * p.distance, 0., 0.);
  return {{p.edge_tilt, p.radius, half}, {p.second == "alike" ? p.edge_tilt : -p.edge_tilt, p.radius, -1. * half}};
}

/** The first of cells that grow to the given width, on the mesh as refined; not larger than equal ones. */
double smallest_cell(const double shortest, const double width, const unsigned int coarse_cells,
                     const unsigned int refinements)
{
  return std::min(first_cell * shortest, width / coarse_cells) / (1u << refinements);
}

SurfaceDiscretization ring_mesh(const InclusionParameters &p, const double shortest, StartShape ring)
{
  ring.name          = "annulus";
  ring.inner_radius  = p.radius;
  ring.outer_radius  = p.outer_radius;
  const double width = p.outer_radius - p.radius;
  // As many as double in size from one to the next, and no fewer than 8.
  const double doubling = std::ceil(std::log2(1. + width / (first_cell * shortest)));
  ring.radial_cells     = std::max(8u, static_cast<unsigned int>(doubling));
  ring.smallest_cell    = smallest_cell(shortest, width, ring.radial_cells, ring.refinements);
  return make_start_shape(ring);
}

/** Growth of the cells of a cap for which the first of n of them has the given size, both as angles. */
double growth_of_cap(const double angle, const double first, const double n)
{
  const auto size = [&](const double growth) { return std::log1p(growth * angle) / (growth * n); };
  double low = 1e-3, high = 1e6;
  if (first >= size(low))
    return 0.;
  for (int i = 0; i < 60; ++i)
    (size(std::sqrt(low * high)) > first ? low : high) = std::sqrt(low * high);
  return low;
}

SurfaceDiscretization sphere_mesh(const InclusionParameters &p, const double shortest, const StartShape &base)
{
  const double angle = pi - p.polar_angle, n_cells = 4u << base.refinements;
  const double first = smallest_cell(shortest, angle * sphere_radius(base.area), 4, base.refinements);
  return cap(angle, area_outside_cap(base.area, p.polar_angle), base.degree, {base.refinements + 1, base.cut},
             base.axial, growth_of_cap(angle, first / sphere_radius(base.area), n_cells));
}

/** A unit vector turned by the angle |turn| towards `turn`, which is at right angles to it. */
Direction turned_towards(const Direction &O, const Direction &turn)
{
  const double angle = norm(turn);
  return angle > 0. ? std::cos(angle) * O + (std::sin(angle) / angle) * turn : O;
}
} // namespace

void InclusionParameters::bind(ParameterSection &section)
{
  section.number("Radius", radius, Range::positive(), dimensions::length,
                 "Radius a of the inclusions in flat membranes.");
  section.number("Outer radius", outer_radius, Range::positive(), dimensions::length,
                 "Radius b of the flat membrane; at its rim the directors are along its normal.");
  section.number("Edge tilt", edge_tilt, Range::between(-1.5, 1.5), dimensions::none,
                 "Angle in radians by which the directors at the inclusion are tilted from the normal, away from the "
                 "inclusion.");
  section.number("Distance", distance, Range::positive(), dimensions::length,
                 "Distance of the centres of two inclusions.");
  section.choice("Second", second, {"alike", "opposite"},
                 "Edge tilt of the second of two inclusions: that of the first, or minus that.");
  section.number("Polar angle", polar_angle, Range::between(0.001, 1.5), dimensions::none,
                 "Angle in radians from the middle of an inclusion on a vesicle to its rim, seen from the sphere's "
                 "centre.");
}

void InclusionParameters::check(const std::string &shape, const std::string &symmetry) const
{
  if (shape == on_ring && !(outer_radius > radius))
    throw UserError("Inclusion/Outer radius = " + exact_text(outer_radius) +
                    ": it must be larger than Inclusion/Radius = " + exact_text(radius) + ".");
  if (shape == on_disc && symmetry != "none")
    throw UserError("Surface/Shape = two inclusions is not axisymmetric: set Mesh/Symmetry to none.");
  if (has_inclusions(shape) && symmetry == "axial mirror")
    throw UserError("Surface/Shape = " + shape + " has no mirror plane: set Mesh/Symmetry to axial or none.");
}

const std::vector<std::string> &inclusion_shape_names()
{
  static const std::vector<std::string> names{on_ring, on_disc, on_sphere};
  return names;
}

bool has_inclusions(const std::string &shape)
{
  const std::vector<std::string> &names = inclusion_shape_names();
  return std::find(names.begin(), names.end(), shape) != names.end();
}

bool InclusionMembrane::is_flat() const
{
  return shape != on_sphere;
}

std::vector<std::string> InclusionMembrane::rims() const
{
  if (shape == on_ring)
    return {"inclusion", "outer rim"};
  if (shape == on_disc)
    return {"first inclusion", "second inclusion", "outer rim"};
  return {"inclusion"};
}

double InclusionMembrane::area(const double sphere_area) const
{
  if (!is_flat())
    return area_outside_cap(sphere_area, discs.polar_angle);
  const double n_discs = shape == on_ring ? 1. : 2.;
  return pi * (discs.outer_radius * discs.outer_radius - n_discs * discs.radius * discs.radius);
}

SurfaceDiscretization InclusionMembrane::mesh(const StartShape &base) const
{
  const double radius   = shape == on_sphere ? sphere_radius(base.area) * std::sin(discs.polar_angle) : discs.radius;
  const double shortest = std::min(decay_length, radius);
  SurfaceDiscretization result;
  if (shape == on_ring)
    result = ring_mesh(discs, shortest, base);
  else if (shape == on_sphere)
    result = sphere_mesh(discs, shortest, base);
  else
    result = disc_with_two_holes(
        {discs.radius, discs.distance, discs.outer_radius, first_cell * shortest / (1u << base.refinements)},
        base.degree, base.refinement());
  const std::vector<std::string> names = rims(); // builders have names of their own
  for (std::size_t i = 0; i < names.size(); ++i)
    result.edges[i].name = names[i];
  return result;
}

void InclusionMembrane::tilt(const SurfaceDiscretization &surface, const StartShape &base,
                             NodalVectors &directors) const
{
  const std::vector<RigidDisc> all = rigid_discs(shape, discs, base.area);
  for (std::size_t I = 0; I < surface.n_nodes; ++I)
  {
    const Direction x = vector_at(surface.positions, I), O = vector_at(directors, I);
    Direction turn;
    for (const RigidDisc &disc : all)
      turn += disc.tilt_at(x, decay_length) * disc.away(x);
    set_vector_at(directors, I, turned_towards(O, turn - dot(turn, O) * O));
  }
  for (std::size_t i = 0; i < surface.edges.size(); ++i)
    for (const std::size_t I : surface.edges[i].cell_nodes)
    {
      const Direction x = vector_at(surface.positions, I);
      set_vector_at(directors, I,
                    i < all.size() ? turned_towards(all[i].normal(x), all[i].tilt * all[i].away(x)) : e_z);
    }
}
} // namespace pellicle

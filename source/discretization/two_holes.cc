// SPDX-License-Identifier: LGPL-2.1-or-later
// A flat disc with two circular holes: either half, x > 0 and x < 0, is a ring of cells on straight rays from its hole.
#include "graded_line.h"
#include "turned.h"

#include <pellicle/base/constants.h>
#include <pellicle/base/exact_text.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/builders.h>
#include <pellicle/discretization/edge_loops.h>
#include <pellicle/discretization/refined_quads.h>

#include <algorithm>
#include <cmath>

namespace pellicle
{
namespace
{
constexpr unsigned int n_radial = 6, n_arc = 8, n_straight = 8; ///< cells of one half, coarsest mesh
constexpr unsigned int n_around = n_arc + n_straight;

/** The half x > 0: rays from the centre of its hole end on the disc's rim or on the line x = 0. Around the hole,
 * `a` in [0, n_around] counts cells counterclockwise from the first one whose rays end on the rim. */
class HalfDisc
{
public:
  HalfDisc(const DiscWithTwoHoles &disc, const double n_cells)
      : disc(disc)
      , n_cells(n_cells)
      , centre(0.5 * disc.distance)
      , corner(std::atan2(disc.outer_radius, -centre) / pi)
  {
  }

  Vector3<double> at(const unsigned int patch_around, const double v, const double across) const
  {
    const bool ends_on_rim    = patch_around < n_arc;
    const double azimuth      = ends_on_rim ? corner * (2. * (patch_around + v) / n_arc - 1.)
                                            : corner + (2. - 2. * corner) * (patch_around - n_arc + v) / n_straight;
    const Vector3<double> ray = turned(1., azimuth, 0.);
    const double along        = centre * ray[0];
    const double end          = ends_on_rim
                                    ? -along + std::sqrt(along * along + disc.outer_radius * disc.outer_radius - centre * centre)
                                    : -centre / ray[0];
    const Vector3<double> x   = Vector3<double>(centre, 0., 0.) + radius(end, across) * ray;
    return across == n_radial && !ends_on_rim ? Vector3<double>(0., x[1], 0.) : x;
  }

private:
  /** Sizes of cells change smoothly with the length of the ray, and are nowhere larger than equal ones. */
  double radius(const double end, const double across) const
  {
    if (across == n_radial)
      return end;
    const double length = end - disc.hole_radius;
    const double first  = disc.smallest > 0. ? 1. / (1. / disc.smallest + n_cells / length) : 0.;
    return disc.hole_radius + GradedLine(length, n_cells, first, 0.).at(n_cells * across / n_radial);
  }

  DiscWithTwoHoles disc;
  double n_cells, centre;
  double corner; ///< azimuth over pi at which the rim meets the line x = 0, seen from the hole
};

constexpr unsigned int first_half = (n_radial + 1) * n_around;
constexpr unsigned int n_vertices = first_half + n_radial * n_around + n_arc - 1;

/** Vertices: those of the half x > 0 from its hole outwards, then those of the other half, which is the first one
 * turned by pi. On the line x = 0 both have the same ones. */
unsigned int vertex(const unsigned int half, const unsigned int across, const unsigned int around)
{
  const unsigned int a = around % n_around;
  if (half == 0)
    return across * n_around + a;
  if (across < n_radial)
    return first_half + across * n_around + a;
  const bool on_line = a >= n_arc || a == 0;
  return on_line ? n_radial * n_around + (n_around + n_arc - a) % n_around : first_half + n_radial * n_around + a - 1;
}

void check(const DiscWithTwoHoles &disc)
{
  if (!(disc.hole_radius > 0. && disc.distance > 2. * disc.hole_radius &&
        disc.outer_radius > 0.5 * disc.distance + disc.hole_radius))
    throw UserError("Two holes of radius " + exact_text(disc.hole_radius) + " at the distance " +
                    exact_text(disc.distance) + " in a disc of radius " + exact_text(disc.outer_radius) +
                    ": the distance of their centres must be larger than " + exact_text(2. * disc.hole_radius) +
                    ", and the disc larger than " + exact_text(0.5 * disc.distance + disc.hole_radius) + ".");
}
} // namespace

SurfaceDiscretization disc_with_two_holes(const DiscWithTwoHoles &disc, const unsigned int degree,
                                          const Refinement &refinement)
{
  check(disc);
  const HalfDisc half(disc, std::ldexp(n_radial, static_cast<int>(refinement.uniform)));
  std::vector<QuadVertices> quads;
  for (unsigned int h = 0; h < 2; ++h)
    for (unsigned int i = 0; i < n_radial; ++i)
      for (unsigned int a = 0; a < n_around; ++a)
        quads.push_back({{vertex(h, i, a), vertex(h, i + 1, a), vertex(h, i, a + 1), vertex(h, i + 1, a + 1)}});
  const auto point = [&](const unsigned int patch, const double u, const double v)
  {
    const unsigned int in_half = patch % (n_radial * n_around);
    const Vector3<double> x    = half.at(in_half % n_around, v, in_half / n_around + u);
    return in_half == patch ? x : Vector3<double>(-x[0], -x[1], 0.);
  };
  SurfaceDiscretization result = place_nodes(
      refine_quads(corner_points(quads, n_vertices, point), quads, refinement, degree), quads, degree, point);
  // In this order, whichever is found first.
  const std::array<std::string, 3> names{{"right hole", "left hole", "ring"}};
  const double between = 0.5 * (0.5 * disc.distance + disc.hole_radius + disc.outer_radius);
  const auto name      = [&](const Vector3<double> &x) -> std::string {
    return norm(x) > between ? names[2] : x[0] > 0. ? names[0] : names[1];
  };
  result.edges     = find_rims(result, name);
  const auto place = [&](const EdgeLoop &rim) { return std::find(names.begin(), names.end(), rim.name); };
  std::sort(result.edges.begin(), result.edges.end(),
            [&](const EdgeLoop &a, const EdgeLoop &b) { return place(a) < place(b); });
  result.mesh_reference = result.positions;
  return result;
}
} // namespace pellicle

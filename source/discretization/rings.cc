// SPDX-License-Identifier: LGPL-2.1-or-later
// Open surfaces with two rims: a tube and a flat ring.
#include "graded_line.h"
#include "meridian_line.h"
#include "turned.h"

#include <pellicle/base/constants.h>
#include <pellicle/base/exact_text.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/builders.h>
#include <pellicle/discretization/edge_loops.h>
#include <pellicle/discretization/refined_quads.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pellicle
{
namespace
{
constexpr double greatest_growth = 3.; ///< of cells from one to the next

bool is_positive(const double x)
{
  return x > 0. && x < std::numeric_limits<double>::infinity();
}

/** Band of n_across times n_around quadrilaterals; the first coordinate runs from the first rim to the second, the
 * second counterclockwise. */
SurfaceDiscretization band(const unsigned int n_across, const unsigned int n_around, const unsigned int degree,
                           const Refinement &refinement, const std::array<std::string, 2> &names,
                           const std::function<Vector3<double>(double across, double azimuth_over_pi)> &shape)
{
  std::vector<QuadVertices> quads;
  const auto number = [&](const unsigned int i, const unsigned int a) { return i * n_around + a % n_around; };
  for (unsigned int i = 0; i < n_across; ++i)
    for (unsigned int a = 0; a < n_around; ++a)
      quads.push_back({{number(i, a), number(i + 1, a), number(i, a + 1), number(i + 1, a + 1)}});
  const auto point = [&](const unsigned int patch, const double u, const double v)
  { return shape(patch / n_around + u, 2. * (patch % n_around + v) / n_around); };
  SurfaceDiscretization result =
      place_nodes(refine_quads(corner_points(quads, (n_across + 1) * n_around, point), quads, refinement, degree),
                  quads, degree, point);
  const Vector3<double> first = shape(0., 0.), second = shape(n_across, 0.);
  const auto distance = [](const Vector3<double> &x, const Vector3<double> &rim)
  { return std::abs(std::hypot(x[0], x[1]) - std::hypot(rim[0], rim[1])) + std::abs(x[2] - rim[2]); };
  result.edges = find_rims(result, [&](const Vector3<double> &x)
                           { return distance(x, first) < distance(x, second) ? names[0] : names[1]; });
  if (result.edges[0].name != names[0])
    std::swap(result.edges[0], result.edges[1]);
  result.mesh_reference = result.positions;
  return result;
}

/** The same for a meridian, along the first coordinate. */
SurfaceDiscretization line(const std::size_t n_across, const unsigned int degree, const std::vector<CellPlace> &cut,
                           const std::array<std::string, 2> &names,
                           const std::function<Vector3<double>(double across, double azimuth_over_pi)> &shape)
{
  SurfaceDiscretization result =
      meridian_line(degree, n_across, cut, false, [&](const double t) { return shape(t, 0.); });
  free_along_axis(result);
  result.edges          = {circle_loop(result, names[0], 0, false, true),
                           circle_loop(result, names[1], result.n_cells - 1, true, true)};
  result.mesh_reference = result.positions;
  return result;
}

void check_annulus(const AnnulusShape &ring)
{
  if (!(is_positive(ring.inner_radius) && is_positive(ring.outer_radius) && ring.inner_radius < ring.outer_radius))
    throw UserError("Inner radius = " + exact_text(ring.inner_radius) + ", outer radius = " +
                    exact_text(ring.outer_radius) + ": an annulus needs 0 < inner radius < outer radius.");
  if (ring.n_radial < 4 || ring.n_around < 8)
    throw UserError("The coarsest mesh of an annulus has at least 4 cells across and 8 around, not " +
                    std::to_string(ring.n_radial) + " and " + std::to_string(ring.n_around) + ".");
}

GradedLine radial_line(const AnnulusShape &ring, const double n_cells)
{
  const double width = ring.outer_radius - ring.inner_radius, equal = width / n_cells;
  for (const auto &[name, size] : {std::pair<std::string, double>{"Smallest cell", ring.smallest},
                                   std::pair<std::string, double>{"Smallest outer cell", ring.smallest_outer}})
    if (!(size >= 0. && size <= equal * (1. + 1e-12)))
      throw UserError(name + " = " + exact_text(size) + ": it must lie between 0 (no grading) and " +
                      exact_text(equal) + ", the size of " + exact_text(n_cells) +
                      " equal cells between the two rims. Take a smaller size or fewer refinements.");
  const GradedLine radii(width, n_cells, ring.smallest, ring.smallest_outer);
  if (radii.growth() > greatest_growth)
    throw UserError("Smallest cell = " + exact_text(ring.smallest) +
                    ", smallest outer cell = " + exact_text(ring.smallest_outer) + ": with " + exact_text(n_cells) +
                    " cells between the rims, each would have to be " + exact_text(radii.growth()) +
                    " times as large as the one before it, at most " + exact_text(greatest_growth) +
                    " is possible. Refine, or ask for larger cells at the rim.");
  return radii;
}
} // namespace

SurfaceDiscretization tube(const double ratio, const double area, const unsigned int degree,
                           const Refinement &refinement, const bool axial)
{
  if (!(ratio > 1e-3 && ratio < 1e3))
    throw UserError("Tube ratio = " + exact_text(ratio) +
                    ": length/radius of the tube must be a number between 0.001 and 1000.");
  const double radius = std::sqrt(area / (2. * pi * ratio)), length = ratio * radius;
  const auto shape = [&](const double n_across)
  {
    return [=](const double across, const double azimuth_over_pi)
    { return turned(radius, azimuth_over_pi, length * (0.5 - across / n_across)); };
  };
  const std::array<std::string, 2> names{{"upper rim", "lower rim"}};
  if (axial)
  {
    const std::size_t n_across = std::size_t(2) << refinement.uniform;
    return line(n_across, degree, refinement.cut, names, shape(n_across));
  }
  // About square: the circumference is 2 pi/ratio times the length.
  const double around         = 2. * pi / ratio;
  const unsigned int n_around = static_cast<unsigned int>(std::max(4., std::round(around)));
  const unsigned int n_across = static_cast<unsigned int>(std::max(1., std::round(n_around / around)));
  return band(n_across, n_around, degree, refinement, names, shape(n_across));
}

SurfaceDiscretization annulus(const AnnulusShape &ring, const unsigned int degree, const Refinement &refinement,
                              const bool axial)
{
  check_annulus(ring);
  const double cells_per_patch = std::ldexp(1., static_cast<int>(refinement.uniform));
  const GradedLine radii       = radial_line(ring, ring.n_radial * cells_per_patch);
  const double n_across        = axial ? ring.n_radial * cells_per_patch : ring.n_radial;
  const auto shape             = [&](const double across, const double azimuth_over_pi)
  {
    const double radius = across < n_across
                              ? ring.inner_radius + radii.at(ring.n_radial * cells_per_patch * (across / n_across))
                              : ring.outer_radius;
    return turned(radius, azimuth_over_pi, 0.);
  };
  const std::array<std::string, 2> names{{"tip", "ring"}};
  return axial ? line(static_cast<std::size_t>(n_across), degree, refinement.cut, names, shape)
               : band(ring.n_radial, ring.n_around, degree, refinement, names, shape);
}
} // namespace pellicle

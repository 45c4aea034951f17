// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ridge_parts.h"
#include "ridge_lines.h"
#include "ridge_plan.h"
#include "turned.h"

#include <algorithm>
#include <cmath>

namespace pellicle
{
namespace
{
constexpr double core_radius = .28; ///< mean, over the ring's
constexpr double round_part  = .3;  ///< of the way from the ring to the sides of a block: rings are circles
constexpr double same_place  = 1e-9;

/** Value of a piecewise linear function of t, whole numbers being its corners. */
double along(const std::vector<double> &corners, const double t)
{
  const std::size_t i = std::min(corners.size() - 2, static_cast<std::size_t>(t));
  const double f      = t - static_cast<double>(i);
  return (1. - f) * corners[i] + f * corners[i + 1];
}

/** Distance from the axis within the contact line: the rings' lines are circles but for the innermost, the core's. */
double radius_within(const std::vector<double> &radii, const double ring, const double azimuth_over_pi)
{
  const double core = std::max(0., 1. - ring) * radii.front();
  return along(radii, ring) + core * (RidgePlan::core_outline(azimuth_over_pi) - 1.);
}

/** Distance from the axis to the sides of the square of half width 1. */
double to_square(const double azimuth_over_pi)
{
  const Vector3<double> direction = turned(1., azimuth_over_pi, 0.);
  return 1. / std::max(std::abs(direction[0]), std::abs(direction[1]));
}
} // namespace

SurfacePart ridge_top(const RidgeShape &shape, const RidgePlanShape &plan)
{
  const double a                   = shape.ring_radius;
  std::vector<double> radii        = downwards(a, graded_ends((1. - core_radius) * a, shape.cell_size, shape));
  const std::size_t n_within       = radii.size() - 1;
  const std::vector<double> beyond = graded_ends(shape.half_width - a, shape.cell_size, shape);
  for (auto end = beyond.begin() + 1; end != beyond.end(); ++end)
    radii.push_back(a + *end);
  radii.back() = shape.half_width;

  // Beyond the last circle, lines go over to the square.
  const double last_circle =
      a + *std::lower_bound(beyond.begin(), beyond.end() - 2, round_part * (shape.half_width - a));
  const bool square  = plan.outline == RidgePlanShape::Outline::block;
  const auto outline = [&](const double ring, const double azimuth_over_pi)
  {
    const double circle = radius_within(radii, ring, azimuth_over_pi);
    const double excess = square ? shape.half_width * (to_square(azimuth_over_pi) - 1.) : 0.;
    return circle + std::max(0., circle - last_circle) / (shape.half_width - last_circle) * excess;
  };
  const RidgePlan rings(plan.n_around, static_cast<unsigned int>(radii.size() - 1), plan.half);
  SurfacePart top{rings.place(outline, shape.degree), {}};
  for (const int ring : rings.ring_of_cell())
    top.within.push_back(ring < static_cast<int>(n_within));
  return top;
}

SurfaceDiscretization ridge_cap(const RidgeShape &shape, const RidgePlanShape &plan)
{
  constexpr double relative_size = 4.;
  const CapOutline cap(shape);
  const double stretch = cap.arc() / shape.ring_radius, largest = shape.coarsest * std::min(1., 1. / cap.angle());
  const double size = std::min(relative_size * shape.cell_size / (shape.ring_radius * stretch), largest);
  const std::vector<double> radii =
      downwards(1., graded_ends(1. - core_radius, size, shape.growth, shape.coarsest, largest));
  const RidgePlan rings(plan.n_around, static_cast<unsigned int>(radii.size() - 1), plan.half);
  SurfaceDiscretization result = rings.place([&](const double ring, const double azimuth_over_pi)
                                             { return radius_within(radii, ring, azimuth_over_pi); },
                                             shape.degree);
  for (std::size_t I = 0; I < result.n_nodes; ++I)
  {
    double *const x         = result.positions.data() + 3 * I;
    const double rho        = std::hypot(x[0], x[1]);
    const auto [r, z]       = cap.at(std::abs(rho - 1.) < same_place ? 1. : rho);
    const double lengthened = rho > 0. ? r / rho : 0.;
    x[0] *= lengthened;
    x[1] *= lengthened;
    x[2] = z;
  }
  return result;
}
} // namespace pellicle

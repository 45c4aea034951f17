// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ridge_fan.h"
#include "ridge_lines.h"

#include <pellicle/discretization/refined_quads.h>

#include <algorithm>
#include <cmath>

namespace pellicle
{
namespace
{
constexpr double decay     = .6;  ///< of what cells have above the smallest, from one to the next
constexpr double thickest  = .3;  ///< of all cells of a column, over the thickness
constexpr double edge      = .25; ///< cell at the outer edge at least, over the ring's radius, however fine the mesh
constexpr double spread    = 1.;  ///< greatest distance over which lines fan out, over the ring's radius
constexpr std::size_t some = 4;   ///< fewer cells are equal

/** Ends of n cells on [0, length] that become smaller, from `first` on where n equal ones would be smaller. */
std::vector<double> coarse_at_the_top(const std::size_t n, const double length, const double first)
{
  const double sum = (1. - std::pow(decay, n)) / (1. - decay), count = static_cast<double>(n);
  const double largest  = n < some ? length / count : std::max(length / count, std::min(first, thickest * length));
  const double smallest = n == 1 ? largest : (length - largest * sum) / (count - sum);
  std::vector<double> ends{0.};
  for (std::size_t i = 0; i + 1 < n; ++i)
    ends.push_back(ends.back() + smallest + (largest - smallest) * std::pow(decay, i));
  ends.push_back(length);
  return ends;
}

double node_between(const std::vector<double> &ends, const std::size_t cell, const double unit)
{
  return ends[cell] + .5 * (1. + unit) * (ends[cell + 1] - ends[cell]);
}
} // namespace

RidgeFan::RidgeFan(const RidgeShape &shape, const double inwards_)
    : ring_radius(shape.ring_radius)
    , inwards(inwards_)
    , outwards(std::min(shape.half_width - shape.ring_radius, spread * shape.ring_radius))
    , below_line(downwards(0., graded_ends(shape.thickness, shape.cell_size, shape)))
{
  const std::size_t n = below_line.size() - 1;
  const std::vector<double> far =
      downwards(0., coarse_at_the_top(n, shape.thickness, std::max(shape.coarsest, edge) * shape.ring_radius));
  const std::vector<double> unit = line_nodes(shape.degree);
  for (std::size_t cell = 0; cell < n; ++cell)
    for (unsigned int i = 0; i < shape.degree; ++i)
      levels.push_back({node_between(below_line, cell, unit[i]), node_between(far, cell, unit[i])});
  levels.push_back({0., 0.});
}

double RidgeFan::height(const std::size_t level, const double r) const
{
  const auto [below, far] = levels[level];
  const double way        = std::min(1., r < ring_radius ? (ring_radius - r) / inwards : (r - ring_radius) / outwards);
  return below == far ? below : (1. - way) * below + way * far;
}
} // namespace pellicle

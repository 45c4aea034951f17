// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ridge_lines.h"

#include <pellicle/base/constants.h>
#include <pellicle/base/exact_text.h>
#include <pellicle/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace pellicle
{
namespace
{
constexpr double finest = 1e-6; ///< over the ring's radius

void check_positive(const std::string &name, const double value)
{
  if (!(value > 0. && value < std::numeric_limits<double>::infinity()))
    throw UserError(name + " = " + exact_text(value) + ": it must be a positive number.");
}

void check_range(const std::string &name, const double value, const double lowest, const double highest)
{
  if (!(value >= lowest && value <= highest))
    throw UserError(name + " = " + exact_text(value) + ": it must lie between " + exact_text(lowest) + " and " +
                    exact_text(highest) + ".");
}

/** Ends of n cells, each `growth` times the one before it as far as the bounds on sizes allow. */
std::vector<double> row(const std::size_t n, const double size, const double growth, const double coarsest,
                        const double largest)
{
  std::vector<double> ends{0.};
  double step = size;
  for (std::size_t i = 0; i < n; ++i)
  {
    ends.push_back(ends.back() + step);
    step = std::min(growth * step, std::max(largest, coarsest * ends.back()));
  }
  return ends;
}
} // namespace

void check_ridge(const RidgeShape &shape)
{
  check_positive("Radius of the contact line", shape.ring_radius);
  check_positive("Volume of the drop", shape.cap_volume);
  check_positive("Half width of the substrate", shape.half_width);
  check_positive("Thickness of the substrate", shape.thickness);
  if (!(shape.half_width > shape.ring_radius))
    throw UserError("The ring of radius " + exact_text(shape.ring_radius) +
                    (shape.half_width == shape.ring_radius ? " touches" : " reaches beyond") +
                    " the lateral faces of a substrate of half width " + exact_text(shape.half_width) +
                    ": no solid is left beside the contact line there. Take a wider substrate (twice the ring's "
                    "radius is a good start) or a smaller ring.");
  check_range("Growth of cells", shape.growth, 1.01, 3.);
  check_range("Coarsest cell", shape.coarsest, .01, .5);
  const double room    = std::min(shape.half_width - shape.ring_radius, shape.thickness);
  const double largest = std::min(shape.coarsest * shape.ring_radius, .5 * room), smallest = finest * shape.ring_radius;
  if (!(shape.cell_size >= smallest && shape.cell_size <= largest))
    throw UserError("Cell size = " + exact_text(shape.cell_size) + " at the contact line: with a ring of radius " +
                    exact_text(shape.ring_radius) + ", " + exact_text(shape.half_width - shape.ring_radius) +
                    " from the lateral faces, on a substrate " + exact_text(shape.thickness) +
                    " thick it must lie between " + exact_text(smallest) + " and " + exact_text(largest) + ".");
  // Of a sphere 6e3 times as large as the ring, rounding errors are still far smaller than the ring.
  const double largest_volume = 1e12 * std::pow(shape.ring_radius, 3);
  if (!(shape.cap_volume <= largest_volume))
    throw UserError("Volume of the drop = " + exact_text(shape.cap_volume) + ": on a contact line of radius " +
                    exact_text(shape.ring_radius) + " it must be at most " + exact_text(largest_volume) +
                    ", or the line is a point. Take a smaller drop or a larger line.");
}

std::vector<double> graded_ends(const double length, const double size, const double growth, const double coarsest,
                                const double largest)
{
  std::size_t n = 1;
  while (row(n, size, growth, coarsest, largest).back() < length * (1. - 1e-12))
    ++n;
  // As many cells that grow a little less, and fill the length.
  double low = 1., high = growth;
  for (unsigned int i = 0; i < 60; ++i)
  {
    const double middle                                                    = .5 * (low + high);
    (row(n, size, middle, coarsest, largest).back() < length ? low : high) = middle;
  }
  std::vector<double> ends = row(n, size, high, coarsest, largest);
  const double factor      = length / ends.back(); // 1 up to round-off, unless equal cells are too large already
  for (double &end : ends)
    end *= factor;
  ends.back() = length;
  return ends;
}

std::vector<double> graded_ends(const double length, const double size, const RidgeShape &shape)
{
  return graded_ends(length, size, shape.growth, shape.coarsest, shape.coarsest * shape.ring_radius);
}

std::vector<double> downwards(const double from, const std::vector<double> &ends)
{
  std::vector<double> result;
  for (auto end = ends.rbegin(); end != ends.rend(); ++end)
    result.push_back(from - *end);
  return result;
}

// The cap's height h obeys h^3 + 3 a^2 h = 6 V/pi, hence h = 2 a sinh(arsinh(3 V/(pi a^3))/3), and the angle is
// 2 arctan(h/a).
double cap_angle(const double volume, const double ring_radius)
{
  return 2. * std::atan(2. * std::sinh(std::asinh(3. * volume / (pi * std::pow(ring_radius, 3))) / 3.));
}

CapOutline::CapOutline(const RidgeShape &shape)
    : ring_radius(shape.ring_radius)
    , rim_angle(cap_angle(shape.cap_volume, shape.ring_radius))
    , radius(shape.ring_radius / std::sin(rim_angle))
{
}

std::array<double, 2> CapOutline::at(const double rho) const
{
  if (rho == 1.)
    return {{ring_radius, 0.}};
  const double polar = rim_angle * rho;
  // cos(polar) - cos(rim), without cancellation.
  const double height = 2. * std::sin(.5 * (rim_angle + polar)) * std::sin(.5 * (rim_angle - polar));
  return {{radius * std::sin(polar), radius * height}};
}
} // namespace pellicle

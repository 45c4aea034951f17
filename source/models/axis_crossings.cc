// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/models/axis_crossings.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace pellicle
{
namespace
{
/** Axis-parallel box around a cell's samples, seen along z. */
struct Shadow
{
  std::array<double, 2> low{{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()}};
  std::array<double, 2> high{{-low[0], -low[1]}};

  Shadow(const CellGeometry &geometry, const std::size_t cell)
  {
    for (unsigned int i = 0; i < geometry.n_samples(); ++i)
      for (unsigned int c = 0; c < 2; ++c)
      {
        low[c]  = std::min(low[c], geometry.sample(cell, i)[c]);
        high[c] = std::max(high[c], geometry.sample(cell, i)[c]);
      }
  }

  double size() const { return std::max(high[0] - low[0], high[1] - low[1]); }

  /** The cell itself sticks out of its samples' box by less than a quarter of the box. */
  bool may_contain(const double x, const double y) const
  {
    const double margin = 0.25 * size();
    return x >= low[0] - margin && x <= high[0] + margin && y >= low[1] - margin && y <= high[1] + margin;
  }
};

struct Found
{
  AxisCrossing crossing;
  double cell_size = 0.;
};

/** Newton's method for x(xi) = x_axis, y(xi) = y_axis. Nothing if it strays or ends outside the cell. */
std::optional<AxisCrossing> search(const CellGeometry &geometry, CellSite site, const double x_axis,
                                   const double y_axis)
{
  constexpr double converged = 1e-12, outside = 1e-9; // in units of the cell
  for (unsigned int iteration = 0; iteration < 40; ++iteration)
  {
    const CellPoint p = geometry.at(site);
    const double det  = p.first[0][0] * p.first[1][1] - p.first[0][1] * p.first[1][0]; // = J n_z
    const double f0 = x_axis - p.x[0], f1 = y_axis - p.x[1];
    double step[2] = {(p.first[1][1] * f0 - p.first[1][0] * f1) / det, (p.first[0][0] * f1 - p.first[0][1] * f0) / det};
    const double length = std::max(std::abs(step[0]), std::abs(step[1]));
    if (!std::isfinite(length))
      return {};
    const double factor = length > 0.25 ? 0.25 / length : 1.;
    for (unsigned int a = 0; a < 2; ++a)
      site.xi[a] += factor * step[a];
    if (length < converged)
    {
      for (const double xi : site.xi)
        if (xi < -outside || xi > 1. + outside)
          return {};
      return AxisCrossing{geometry.at(site).x[2], det > 0. ? 1 : -1};
    }
    for (const double xi : site.xi)
      if (xi < -0.5 || xi > 1.5)
        return {};
  }
  return {};
}

/** Samples that are no farther from the axis than their neighbours on the grid: one near every crossing. */
std::vector<unsigned int> starting_samples(const CellGeometry &geometry, const std::size_t cell, const double x_axis,
                                           const double y_axis)
{
  const unsigned int n = geometry.n_samples_a_direction();
  const auto distance  = [&](const unsigned int i, const unsigned int j)
  {
    const Vector3<double> &x = geometry.sample(cell, j * n + i);
    return std::hypot(x[0] - x_axis, x[1] - y_axis);
  };
  std::vector<unsigned int> result;
  for (unsigned int j = 0; j < n; ++j)
    for (unsigned int i = 0; i < n; ++i)
    {
      const double here = distance(i, j);
      bool least        = true;
      for (unsigned int b = (j > 0 ? j - 1 : 0); b <= std::min(j + 1, n - 1); ++b)
        for (unsigned int a = (i > 0 ? i - 1 : 0); a <= std::min(i + 1, n - 1); ++a)
          least = least && here <= distance(a, b);
      if (least)
        result.push_back(j * n + i);
    }
  return result;
}
} // namespace

std::vector<AxisCrossing> axis_crossings(const CellGeometry &geometry, const double x_axis, const double y_axis)
{
  PELLICLE_ASSERT(geometry.n_parameters() == 2, "a meridian meets the axis at its ends");
  std::vector<Found> all;
  for (std::size_t cell = 0; cell < geometry.n_cells(); ++cell)
  {
    const Shadow shadow(geometry, cell);
    if (!shadow.may_contain(x_axis, y_axis))
      continue;
    for (const unsigned int sample : starting_samples(geometry, cell, x_axis, y_axis))
      if (const auto crossing = search(geometry, {cell, geometry.sample_coordinates(sample)}, x_axis, y_axis))
        all.push_back({*crossing, shadow.size()});
  }
  std::sort(all.begin(), all.end(), [](const Found &a, const Found &b) { return a.crossing.z < b.crossing.z; });

  std::vector<AxisCrossing> result;
  for (const Found &found : all)
  {
    const auto again = [&](const AxisCrossing &earlier)
    { return earlier.direction == found.crossing.direction && found.crossing.z - earlier.z < 1e-6 * found.cell_size; };
    if (std::none_of(result.begin(), result.end(), again))
      result.push_back(found.crossing);
  }
  return result;
}

double length_inside(const std::vector<AxisCrossing> &crossings)
{
  double length = 0.;
  int balance   = 0;
  for (const AxisCrossing &crossing : crossings)
  {
    length += crossing.direction * crossing.z;
    balance += crossing.direction;
  }
  return balance == 0 ? length : std::numeric_limits<double>::quiet_NaN();
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/models/meridian_curve.h>
#include <pellicle/models/neck.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cstdint>

namespace pellicle
{
std::optional<double> neck_radius(const SurfaceDiscretization &discretization, const NodalVectors &positions)
{
  if (discretization.kind != SurfaceDiscretization::Kind::meridian)
    return std::nullopt;
  const MeridianCurve curve(discretization, positions);
  std::optional<double> smallest;
  const auto consider = [&](const double r)
  {
    if (!smallest || r < *smallest)
      smallest = r;
  };
  double slope_before = 1.; // at the end of the cell before; on the axis r grows
  for (std::size_t cell = 0; cell < discretization.n_cells; ++cell)
  {
    const double first = curve.begin_of(cell).slope_of_r, last = curve.end_of(cell).slope_of_r;
    if (slope_before < 0. && first >= 0.)
      consider(curve.begin_of(cell).r); // on the node between two cells
    if (first < 0. && last > 0.)
    {
      std::uintmax_t iterations = 100;
      const auto bracket =
          boost::math::tools::toms748_solve([&](const double xi) { return curve.at(cell, xi).slope_of_r; }, 0., 1.,
                                            first, last, boost::math::tools::eps_tolerance<double>(40), iterations);
      consider(curve.at(cell, 0.5 * (bracket.first + bracket.second)).r);
    }
    slope_before = last;
  }
  return smallest;
}
} // namespace pellicle

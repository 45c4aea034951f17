// SPDX-License-Identifier: LGPL-2.1-or-later
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
  const auto slots = [&](const std::size_t cell, const double xi)
  {
    const ShapeTables table = make_tables_at(discretization.kind, discretization.degree, {{{xi, 0.}}});
    std::array<double, 18> inputs{};
    evaluate_field(table, &discretization.cell_nodes[cell * discretization.n_local()], positions, 2, inputs.data());
    return inputs;
  };
  const auto radius = [&](const std::size_t cell, const double xi) { return slots(cell, xi)[0]; };
  const auto slope  = [&](const std::size_t cell, const double xi) { return slots(cell, xi)[3]; };

  std::optional<double> smallest;
  const auto consider = [&](const double r)
  {
    if (!smallest || r < *smallest)
      smallest = r;
  };
  double slope_before = 1.; // at the end of the cell before; on the axis r grows
  for (std::size_t cell = 0; cell < discretization.n_cells; ++cell)
  {
    const double first = slope(cell, 0.), last = slope(cell, 1.);
    if (slope_before < 0. && first >= 0.)
      consider(radius(cell, 0.)); // on the node between two cells
    if (first < 0. && last > 0.)
    {
      std::uintmax_t iterations = 100;
      const auto bracket =
          boost::math::tools::toms748_solve([&](const double xi) { return slope(cell, xi); }, 0., 1., first, last,
                                            boost::math::tools::eps_tolerance<double>(40), iterations);
      consider(radius(cell, 0.5 * (bracket.first + bracket.second)));
    }
    slope_before = last;
  }
  return smallest;
}
} // namespace pellicle

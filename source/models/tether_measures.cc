// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/models/meridian_curve.h>
#include <pellicle/models/tether_measures.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <cstdint>
#include <optional>

namespace pellicle
{
namespace
{
/** Radius where the meridian last crosses a height on its way from the tip to the ring. */
std::optional<double> radius_at(const SurfaceDiscretization &meridian, const NodalVectors &positions, const double z)
{
  const MeridianCurve curve(meridian, positions);
  for (std::size_t cell = meridian.n_cells; cell-- > 0;)
  {
    const auto above    = [&](const double xi) { return curve.at(cell, xi).z - z; };
    const double before = curve.begin_of(cell).z - z, after = curve.end_of(cell).z - z;
    if (before == 0.)
      return curve.begin_of(cell).r;
    if (before * after > 0.)
      continue;
    std::uintmax_t iterations = 100;
    const auto bracket        = boost::math::tools::toms748_solve(above, 0., 1., before, after,
                                                                  boost::math::tools::eps_tolerance<double>(50), iterations);
    return curve.at(cell, 0.5 * (bracket.first + bracket.second)).r;
  }
  return std::nullopt;
}
} // namespace

std::vector<std::pair<std::string, double>> tether_measures(const SurfaceDiscretization &discretization,
                                                            const NodalVectors &positions)
{
  const auto node_of = [&](const std::string &name) -> std::optional<std::size_t>
  {
    for (const EdgeLoop &loop : discretization.edges)
      if (loop.name == name)
        return loop.cell_nodes.front();
    return std::nullopt;
  };
  const std::optional<std::size_t> tip = node_of("tip"), ring = node_of("ring");
  if (!tip || !ring)
    return {};
  const double top = positions[3 * *tip + 2], bottom = positions[3 * *ring + 2];
  std::vector<std::pair<std::string, double>> measures{{"length", top - bottom}};
  if (discretization.kind == SurfaceDiscretization::Kind::meridian && top != bottom)
    if (const std::optional<double> radius = radius_at(discretization, positions, 0.5 * (top + bottom)))
      measures.emplace_back("mid_height_radius", *radius);
  return measures;
}
} // namespace pellicle

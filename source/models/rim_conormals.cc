// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/constants.h>
#include <pellicle/discretization/point_walk.h>
#include <pellicle/models/rim_conormals.h>

#include <cmath>

namespace pellicle
{
namespace
{
/** Elevation of a rim's conormal above the horizontal plane. */
double elevation(const EdgeLoop &loop, const StartShape &shape)
{
  if (loop.name == "tip")
    return pi; // inwards
  if (loop.name == "upper rim")
    return 0.5 * pi;
  if (loop.name == "lower rim")
    return -0.5 * pi;
  return shape.name == "cap" ? -shape.cap_angle : 0.;
}
} // namespace

std::vector<Vector3<double>> start_conormals(const SurfaceDiscretization &discretization, const EdgeLoop &loop,
                                             const StartShape &shape)
{
  const double b = elevation(loop, shape);
  std::vector<Vector3<double>> result;
  const auto add = [&](const WalkPoint &point)
  {
    const double x = point[0][0], y = point[0][1], r = std::hypot(x, y);
    result.emplace_back(std::cos(b) * x / r, std::cos(b) * y / r, std::sin(b));
  };
  for_all_points(loop.tables, loop.cell_nodes, discretization.positions, 1, add);
  return result;
}
} // namespace pellicle

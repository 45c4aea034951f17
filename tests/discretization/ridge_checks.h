// SPDX-License-Identifier: LGPL-2.1-or-later
// Measures of the discretization of a drop on a soft substrate.
#pragma once

#include <pellicle/discretization/point_walk.h>
#include <pellicle/discretization/ridge_mesh.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace pellicle::test
{
constexpr unsigned int cap_region = 0, wetted_region = 1, dry_region = 2;

inline Vector3<double> place(const SurfaceDiscretization &ridge, const std::size_t node)
{
  const double *const x = &ridge.positions[3 * node];
  return {x[0], x[1], x[2]};
}

inline double distance_from_axis(const SurfaceDiscretization &ridge, const std::size_t node)
{
  return std::hypot(ridge.positions[3 * node], ridge.positions[3 * node + 1]);
}

/** Area, integral of the normal's third component, and integral of x.n/3 over the cells of a region. */
struct RegionMeasures
{
  double area = 0., projected = 0., volume = 0.;
};

inline RegionMeasures region_measures(const SurfaceDiscretization &ridge, const unsigned int region)
{
  RegionMeasures sum;
  for_all_cells(ridge.tables, ridge.cell_nodes, ridge.positions, 3,
                [&](const WalkCell &cell)
                {
                  if (ridge.cell_region[cell.number] != region)
                    return;
                  for (unsigned int q = 0; q < ridge.tables.n_points; ++q)
                  {
                    const WalkPoint x            = cell[q];
                    const Vector3<double> normal = x.weight * cross(x[1], x[2]);
                    sum.area += norm(normal);
                    sum.projected += normal[2];
                    sum.volume += dot(x[0], normal) / 3.;
                  }
                });
  return sum;
}

/** Volume of a body at the given positions, and the smallest Jacobian at a quadrature point over the mean one of its
 * cell. */
struct BodyMeasures
{
  double volume = 0., worst_jacobian = std::numeric_limits<double>::infinity();
};

inline BodyMeasures body_measures(const BulkPart &body, const NodalVectors &positions)
{
  BodyMeasures sum;
  for_all_cells(body.tables, body.cell_nodes, positions, 4,
                [&](const WalkCell &cell)
                {
                  double smallest = std::numeric_limits<double>::infinity(), volume = 0., weights = 0.;
                  for (unsigned int q = 0; q < body.tables.n_points; ++q)
                  {
                    const WalkPoint x     = cell[q];
                    const double jacobian = dot(x[1], cross(x[2], x[3]));
                    smallest              = std::min(smallest, jacobian);
                    volume += x.weight * jacobian;
                    weights += x.weight;
                  }
                  sum.volume += volume;
                  sum.worst_jacobian = std::min(sum.worst_jacobian, smallest * weights / std::abs(volume));
                });
  return sum;
}

/** Nodes of the cells of a region. */
inline std::set<std::size_t> region_nodes(const SurfaceDiscretization &ridge, const std::vector<unsigned int> &regions)
{
  std::set<std::size_t> nodes;
  for (std::size_t cell = 0; cell < ridge.n_cells; ++cell)
    if (std::find(regions.begin(), regions.end(), ridge.cell_region[cell]) != regions.end())
      nodes.insert(ridge.cell_nodes.begin() + static_cast<std::ptrdiff_t>(cell * ridge.n_local()),
                   ridge.cell_nodes.begin() + static_cast<std::ptrdiff_t>((cell + 1) * ridge.n_local()));
  return nodes;
}

/** Area of the spherical cap of volume V on a circle of radius a: pi (a^2 + h^2). */
inline double cap_area(const RidgeShape &shape)
{
  const double height = shape.ring_radius * std::tan(.5 * cap_angle(shape.cap_volume, shape.ring_radius));
  return 3.14159265358979323846 * (shape.ring_radius * shape.ring_radius + height * height);
}
} // namespace pellicle::test

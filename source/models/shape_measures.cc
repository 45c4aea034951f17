// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/constants.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/point_walk.h>
#include <pellicle/discretization/surface_quality.h>
#include <pellicle/kinematics/surface_point.h>
#include <pellicle/models/axis_crossings.h>
#include <pellicle/models/largest_value.h>
#include <pellicle/models/shape_measures.h>

#include <cmath>

namespace pellicle
{
namespace
{
struct Integrals
{
  double area      = 0.;
  double curvature = 0.; ///< of K
  Vector3<double> position;
};

Integrals integrate(const SurfaceDiscretization &discretization, const NodalVectors &positions)
{
  Integrals sum;
  for_all_points(discretization.tables, discretization.cell_nodes, positions, 6,
                 [&](const WalkPoint &x)
                 {
                   const SurfacePoint<double> point(x[1], x[2], x[3], x[4], x[5]);
                   const double dA = x.weight * point.jacobian;
                   sum.area += dA;
                   sum.curvature += dA * point.gauss_curvature;
                   sum.position += dA * x[0];
                 });
  return sum;
}

/** Revolution cancels the radial part of a meridian's centroid, the mirror plane the rest. */
Vector3<double> centroid_of_body(const SurfaceDiscretization &discretization, const Integrals &sum)
{
  const Vector3<double> mean = sum.position / sum.area;
  if (discretization.kind == SurfaceDiscretization::Kind::surface)
    return mean;
  return {0., 0., discretization.mirror ? 0. : mean[2]};
}

double length_on_axis(const SurfaceDiscretization &discretization, const NodalVectors &positions,
                      const CellGeometry &geometry, const Vector3<double> &centroid)
{
  if (discretization.kind == SurfaceDiscretization::Kind::surface)
    return length_inside(axis_crossings(geometry, centroid[0], centroid[1]));
  // A meridian meets the axis at its ends only. On a cup, whose mouth is up, the inner wall's pole is the first.
  const double first = positions[2], last = positions[3 * (discretization.n_nodes - 1) + 2];
  return discretization.mirror ? 2. * first : first - last;
}
} // namespace

ShapeMeasures measure_shape(const SurfaceDiscretization &discretization, const NodalVectors &positions)
{
  PELLICLE_ASSERT(positions.size() == 3 * discretization.n_nodes, "three coordinates for every node");
  const SurfaceQuality quality = surface_quality(discretization, positions);
  const Integrals sum          = integrate(discretization, positions);

  ShapeMeasures result;
  result.area             = sum.area;
  result.volume           = quality.volume;
  result.reduced_volume   = 3. * result.volume / (4. * pi * std::pow(result.area / (4. * pi), 1.5));
  result.min_cell_quality = quality.min_cell_quality;
  result.cell_area_ratio  = quality.cell_area_ratio;
  result.gauss_bonnet     = sum.curvature / (2. * pi);
  result.centroid         = centroid_of_body(discretization, sum);

  const CellGeometry geometry(discretization, positions);
  const auto farthest = [&](const Vector3<double> &direction) {
    return largest_value(geometry, {direction, Vector3<double>(), result.centroid});
  };
  const double up = farthest({0., 0., 1.});
  result.height   = up + (discretization.mirror ? up : farthest({0., 0., -1.}));
  result.equatorial_radius =
      std::sqrt(2. * largest_value(geometry, {Vector3<double>(), {1., 1., 0.}, result.centroid}));
  result.axis_thickness = length_on_axis(discretization, positions, geometry, result.centroid);
  return result;
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/constants.h>
#include <pellicle/models/free_motions.h>

#include <cmath>

namespace pellicle
{
namespace
{
constexpr double tolerance = 1e-10; // of slopes

RigidMotion shift_along(const double x, const double y, const double z)
{
  return {{{x, y, z}}, {}};
}

/** Rotation about the axis through (0, 0, height). */
RigidMotion turn_about(const Vector3<double> &axis, const double height)
{
  return {{{-axis[1] * height, axis[0] * height, 0.}}, {{axis[0], axis[1], axis[2]}}};
}
} // namespace

std::vector<RigidMotion> free_motions_over(const FunctionOfPlace &H, const double reach, const Vector3<double> &force)
{
  struct Slope
  {
    double x, y, dx, dy;
  };
  std::vector<Slope> slopes;
  Vector3<double> mean;
  for (const double r : {0.13, 0.37, 0.71, 1., 1.3, 1.9})
    for (int i = 0; i < 7; ++i)
    {
      const double x = r * reach * std::cos(2. * pi * i / 7. + r), y = r * reach * std::sin(2. * pi * i / 7. + r);
      const PlaceSample here = H.at(x, y);
      slopes.push_back({x, y, here.dx, here.dy});
      mean += Vector3<double>(here.dx, here.dy, 0.);
    }
  const double n = static_cast<double>(slopes.size());
  mean           = (1. / n) * mean;

  // The shift (t, mean . t) is free if neither the slope along t varies nor the force works on it: t is in the null
  // space of this matrix.
  const double strength          = norm(force);
  const Vector3<double> downhill = strength > 0. ? (1. / strength) * force : force;
  const double work_x = downhill[0] + downhill[2] * mean[0], work_y = downhill[1] + downhill[2] * mean[1];
  double xx = work_x * work_x, xy = work_x * work_y, yy = work_y * work_y, turning = 0.;
  for (const Slope &s : slopes)
  {
    const double dx = s.dx - mean[0], dy = s.dy - mean[1];
    xx += dx * dx / n;
    xy += dx * dy / n;
    yy += dy * dy / n;
    turning += std::pow((s.x * s.dy - s.y * s.dx) / reach, 2) / n;
  }
  const double half_trace = 0.5 * (xx + yy), distance = std::hypot(0.5 * (xx - yy), xy);
  const bool is_plane = half_trace + distance < tolerance * tolerance;

  std::vector<RigidMotion> motions;
  const Vector3<double> normal(-mean[0], -mean[1], 1.);
  if (is_plane)
  {
    motions.push_back(shift_along(1., 0., mean[0]));
    motions.push_back(shift_along(0., 1., mean[1]));
    motions.push_back(turn_about((1. / norm(normal)) * normal, H.at(0., 0.).value));
  }
  else if (half_trace - distance < tolerance * tolerance)
  {
    const double angle = 0.5 * std::atan2(2. * xy, xx - yy) + 0.5 * pi; // of the eigenvector of the smaller eigenvalue
    const double x = std::cos(angle), y = std::sin(angle);
    motions.push_back(shift_along(x, y, mean[0] * x + mean[1] * y));
  }
  if (!is_plane && turning < tolerance * tolerance && std::abs(work_x) + std::abs(work_y) < tolerance)
    motions.push_back(turn_about({0., 0., 1.}, 0.));
  return motions;
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
// Closed surfaces for the tests of this room, and rigid motions of them.
#pragma once

#include <pellicle/base/constants.h>
#include <pellicle/discretization/builders.h>
#include <pellicle/discretization/refined_quads.h>

#include <array>
#include <cmath>

namespace pellicle::test_shapes
{
inline Vector3<double> node(const NodalVectors &positions, const std::size_t I)
{
  return {positions[3 * I], positions[3 * I + 1], positions[3 * I + 2]};
}

template <typename Map>
NodalVectors moved(const NodalVectors &positions, const Map &map)
{
  NodalVectors result;
  for (std::size_t I = 0; I < positions.size() / 3; ++I)
    for (const double x : map(node(positions, I)).components)
      result.push_back(x);
  return result;
}

/** By an angle about z, then by a vector. */
inline NodalVectors turned_and_shifted(const NodalVectors &positions, const double angle, const Vector3<double> &shift)
{
  const double c = std::cos(angle), s = std::sin(angle);
  return moved(positions, [&](const Vector3<double> &x)
               { return Vector3<double>(c * x[0] - s * x[1], s * x[0] + c * x[1], x[2]) + shift; });
}

/** A quarter turn about x: y becomes z. */
inline NodalVectors tipped_over(const NodalVectors &positions)
{
  return moved(positions, [](const Vector3<double> &x) { return Vector3<double>(x[0], -x[2], x[1]); });
}

inline SmoothShape sphere(const double R)
{
  return ellipsoid({{R, R, R}});
}
} // namespace pellicle::test_shapes

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/constants.h>
#include <pellicle/models/surface_sample.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace pellicle::testing
{
using Point = std::array<double, 3>;

/** A meridian (r, z)(p), p from 0 (north pole) to pi. */
using Meridian = std::function<std::array<double, 2>(double)>;

/** H_out, the mean curvature that is positive on a sphere, of the surface of revolution of a meridian, by central
 * differences. */
inline double mean_curvature_outward(const Meridian &meridian, const double p)
{
  const double h = 1e-3, q = std::min(std::max(p, 2 * h), pi - 2 * h);
  const auto before = meridian(q - h), here = meridian(q), after = meridian(q + h);
  const double r1 = (after[0] - before[0]) / (2 * h), z1 = (after[1] - before[1]) / (2 * h);
  const double r2 = (after[0] - 2 * here[0] + before[0]) / (h * h), z2 = (after[1] - 2 * here[1] + before[1]) / (h * h);
  const double s          = std::hypot(r1, z1);
  const double meridional = -(r1 * z2 - z1 * r2) / (s * s * s), azimuthal = -z1 / (here[0] * s);
  return (meridional + azimuthal) / 2.;
}

/**
 * The surface of revolution of a meridian on the six faces of a cube with n x n cells of the given degree each (the
 * cube is laid on the sphere with equal angles), and its mean curvature as the field `mean_curvature_outward`.
 */
inline SurfaceSample revolved_sample(const Meridian &meridian, const unsigned int degree, const unsigned int n)
{
  SurfaceSample sample;
  sample.degree  = degree;
  sample.n_cells = 6 * n * n;
  SampledField curvature{"mean_curvature_outward", 1, {}};
  // Columns of each face: the two parameter directions and the outward one, right-handed.
  for (unsigned int face = 0; face < 6; ++face)
    for (unsigned int cell = 0; cell < n * n; ++cell)
      for (unsigned int j = 0; j <= degree; ++j)
        for (unsigned int i = 0; i <= degree; ++i)
        {
          const double u       = std::tan(pi / 2 * ((cell % n + double(i) / degree) / n - 0.5));
          const double v       = std::tan(pi / 2 * ((cell / n + double(j) / degree) / n - 0.5));
          const double s       = face < 3 ? 1. : -1.;
          const unsigned int a = face % 3;
          Point x{};
          x[a]           = s;
          x[(a + 1) % 3] = s > 0 ? u : v;
          x[(a + 2) % 3] = s > 0 ? v : u;
          const double p = std::atan2(std::hypot(x[0], x[1]), x[2]), phi = std::atan2(x[1], x[0]);
          const auto [r, z] = meridian(p);
          sample.points.insert(sample.points.end(), {r * std::cos(phi), r * std::sin(phi), z});
          curvature.values.push_back(mean_curvature_outward(meridian, p));
        }
  sample.fields = {curvature};
  return sample;
}

inline SurfaceSample sphere_sample(const double radius, const unsigned int degree, const unsigned int n)
{
  return revolved_sample(
      [radius](const double p) {
        return std::array<double, 2>{radius * std::sin(p), radius * std::cos(p)};
      },
      degree, n);
}

/** The shape of a red blood cell at rest, radius 1. */
inline SurfaceSample biconcave_sample(const unsigned int degree, const unsigned int n)
{
  return revolved_sample(
      [](const double p)
      {
        const double s2 = std::sin(p) * std::sin(p);
        return std::array<double, 2>{std::sin(p), (0.1242 + 0.8012 * s2 - 0.4492 * s2 * s2) * std::cos(p)};
      },
      degree, n);
}
} // namespace pellicle::testing

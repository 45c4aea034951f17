// SPDX-License-Identifier: LGPL-2.1-or-later
// Smoothing of start shapes: what is rough goes, shapes of the size of the surface stay.
#include <pellicle/assembly/faired_positions.h>
#include <pellicle/base/constants.h>
#include <pellicle/discretization/builders.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{
using namespace pellicle;

const SurfaceDiscretization sphere = on_cube_sphere(ellipsoid({{1., 1., 1.}}), 3, 2);

/** Root mean square over the nodes. */
double size_of(const NodalVectors &a, const NodalVectors &b)
{
  double sum = 0.;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / (static_cast<double>(a.size()) / 3.));
}

/** The coordinates are spherical harmonics of l = 1: (M + tau D) x = M x scales the sphere by 1/(1 + 2 tau/R^2), tau =
 * 4 pi R^2/n, twice. */
TEST(FairedPositions, SphereShrinksAsDiffusionHasIt)
{
  const double factor       = 1. / (1. + 8. * pi / static_cast<double>(sphere.n_nodes));
  const NodalVectors faired = faired_positions(sphere, sphere.positions, sphere.positions);
  NodalVectors expected     = sphere.positions;
  for (double &x : expected)
    x *= factor * factor;
  EXPECT_LT(size_of(faired, expected), 1e-3);
}

TEST(FairedPositions, NoiseIsGone)
{
  NodalVectors noisy = sphere.positions;
  std::mt19937 random(1);
  for (double &x : noisy)
    x += 0.02 * (2. * static_cast<double>(random()) / static_cast<double>(std::mt19937::max()) - 1.);
  const NodalVectors smooth = faired_positions(sphere, sphere.positions, sphere.positions);
  EXPECT_LT(size_of(faired_positions(sphere, sphere.positions, noisy), smooth), 0.2 * size_of(noisy, sphere.positions));
}
} // namespace

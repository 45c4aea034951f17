// SPDX-License-Identifier: LGPL-2.1-or-later
#include "turned.h"

#include <pellicle/base/constants.h>
#include <pellicle/base/exact_text.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/builders.h>
#include <pellicle/discretization/refined_quads.h>

#include <boost/math/special_functions/cos_pi.hpp>
#include <boost/math/special_functions/sin_pi.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pellicle
{
namespace
{
/** Angles in units of pi: `major` about the z axis, `minor` about the tube's centre line, from its outside upwards. */
Vector3<double> torus_point(const double R, const double r, const double major, const double minor)
{
  return turned(R + r * boost::math::cos_pi(minor), major, r * boost::math::sin_pi(minor));
}
} // namespace

SurfaceDiscretization torus(const double ratio, const double area, const unsigned int degree,
                            const Refinement &refinement)
{
  if (!(ratio > 1. && ratio < std::numeric_limits<double>::infinity()))
    throw UserError("Torus ratio = " + exact_text(ratio) +
                    ": R/r must be a number > 1, or the torus would touch itself (1.41421 is Clifford's).");
  const double r = std::sqrt(area / (4. * pi * pi * ratio)), R = ratio * r;

  // The centre line is `ratio` times as long as the tube's circumference. Three cells are the fewest of a periodic
  // direction.
  const double wanted        = std::round(4. * ratio);
  const unsigned int n_minor = 4, n_major = static_cast<unsigned int>(std::clamp(wanted, 3., 4000.));

  std::vector<Vector3<double>> vertices;
  std::vector<QuadVertices> quads;
  const auto number = [&](const unsigned int i, const unsigned int j) { return (j % n_minor) * n_major + i % n_major; };
  for (unsigned int j = 0; j < n_minor; ++j)
    for (unsigned int i = 0; i < n_major; ++i)
    {
      vertices.push_back(torus_point(R, r, 2. * i / n_major, 2. * j / n_minor));
      quads.push_back({{number(i, j), number(i + 1, j), number(i, j + 1), number(i + 1, j + 1)}});
    }

  const RefinedQuads mesh = refine_quads(vertices, quads, refinement, degree);
  return place_nodes(
      mesh, quads, degree,
      [&](const unsigned int patch, const double u, const double v)
      { return torus_point(R, r, 2. * (patch % n_major + u) / n_major, 2. * (patch / n_major + v) / n_minor); });
}
} // namespace pellicle

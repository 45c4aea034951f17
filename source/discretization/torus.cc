// SPDX-License-Identifier: LGPL-2.1-or-later
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
  using boost::math::cos_pi;
  using boost::math::sin_pi;
  const double rho = R + r * cos_pi(minor);
  return {rho * cos_pi(major), rho * sin_pi(major), r * sin_pi(minor)};
}
} // namespace

SurfaceDiscretization torus(const double ratio, const double area, const unsigned int degree,
                            const unsigned int refinements)
{
  if (!(ratio > 1. && ratio < std::numeric_limits<double>::infinity()))
    throw UserError("Torus ratio = " + exact_text(ratio) +
                    ": R/r must be a number > 1, or the torus would touch itself (1.41421 is Clifford's).");
  const double pi = 3.141592653589793;
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

  const RefinedQuads mesh = refine_quads(vertices, quads, refinements, degree);
  const auto point        = [&](const PatchPoint &site)
  {
    // A patch may have been turned: find its angles from the vertices that are now its origin and its two neighbours.
    const QuadVertices &q = mesh.patches[site.patch];
    const unsigned int i = site.patch % n_major, j = site.patch / n_major; // its place in the grid
    const auto local = [&](const unsigned int v) { // grid coordinates of a vertex in this patch, 0 or 1 each
      return std::array<double, 2>{{v % n_major == i ? 0. : 1., v / n_major == j ? 0. : 1.}};
    };
    const auto o = local(q[0]), a = local(q[1]), b = local(q[2]);
    const double u = 0.5 * (1. + site.xi), v = 0.5 * (1. + site.eta);
    const double x = o[0] + u * (a[0] - o[0]) + v * (b[0] - o[0]), y = o[1] + u * (a[1] - o[1]) + v * (b[1] - o[1]);
    return torus_point(R, r, 2. * (i + x) / n_major, 2. * (j + y) / n_minor);
  };
  return place_nodes(mesh, degree, point);
}
} // namespace pellicle

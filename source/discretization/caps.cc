// SPDX-License-Identifier: LGPL-2.1-or-later
// A spherical cap and its limit, the flat disc.
#include "meridian_line.h"

#include <pellicle/base/constants.h>
#include <pellicle/base/exact_text.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/balanced_disc.h>
#include <pellicle/discretization/builders.h>
#include <pellicle/discretization/edge_loops.h>

#include <cmath>

namespace pellicle
{
namespace
{
/** Outline of a cap by the polar angle, as a fraction rho of the rim's: (r, z) with the rim in z = 0. */
class CapOutline
{
public:
  /** `angle` 0: a disc. */
  CapOutline(const double angle, const double area, const double growth)
      : rim_angle(angle)
      , radius(angle > 0. ? std::sqrt(area / (4. * pi)) / std::sin(0.5 * angle) : std::sqrt(area / pi))
      , growth(growth)
  {
  }

  std::array<double, 2> at(const double rho) const
  {
    if (rim_angle == 0.)
      return {{radius * rho, 0.}};
    const double polar = polar_angle(rho);
    // cos(polar) - cos(rim), without cancellation.
    const double height = 2. * std::sin(0.5 * (rim_angle + polar)) * std::sin(0.5 * (rim_angle - polar));
    return {{radius * std::sin(polar), radius * height}};
  }

private:
  // d(polar)/d(rho) proportional to 1 + growth (rim - polar).
  double polar_angle(const double rho) const
  {
    if (growth == 0.)
      return rim_angle * rho;
    return rim_angle - std::expm1(std::log1p(growth * rim_angle) * (1. - rho)) / growth;
  }

  double rim_angle, radius, growth;
};

SurfaceDiscretization cap_meridian(const CapOutline &outline, const unsigned int degree, const Refinement &refinement)
{
  const std::size_t n_cells    = std::size_t(2) << refinement.uniform;
  SurfaceDiscretization result = meridian_line(degree, n_cells, refinement.cut, false,
                                               [&](const double t)
                                               {
                                                 const auto [r, z] = outline.at(t / n_cells);
                                                 return Vector3<double>(r, 0., z);
                                               });
  put_on_axis(result, 0);
  free_along_axis(result);
  result.edges = {circle_loop(result, "rim", result.n_cells - 1, true, true)};
  return result;
}

SurfaceDiscretization cap_surface(const double angle, const CapOutline &outline, const unsigned int degree,
                                  const Refinement &refinement)
{
  const BalancedDisc disc(angle);
  const std::vector<QuadVertices> quads = BalancedDisc::quads();
  const auto point                      = [&](const unsigned int patch, const double u, const double v)
  {
    const DiscPoint p = disc.at(patch, u, v);
    const auto [r, z] = outline.at(p.radius);
    return Vector3<double>(r * p.cosine, r * p.sine, z);
  };
  SurfaceDiscretization result =
      place_nodes(refine_quads(corner_points(quads, BalancedDisc::n_vertices, point), quads, refinement, degree), quads,
                  degree, point);
  result.edges = find_rims(result, [](const Vector3<double> &) { return "rim"; });
  return result;
}

SurfaceDiscretization make_cap(const double angle, const double area, const unsigned int degree,
                               const Refinement &refinement, const bool axial, const double growth)
{
  const CapOutline outline(angle, area, growth);
  SurfaceDiscretization result =
      axial ? cap_meridian(outline, degree, refinement) : cap_surface(angle, outline, degree, refinement);
  result.mesh_reference = result.positions;
  return result;
}
} // namespace

SurfaceDiscretization cap(const double angle, const double area, const unsigned int degree,
                          const Refinement &refinement, const bool axial, const double growth)
{
  if (!(angle > 0. && angle < pi))
    throw UserError("Cap angle = " + exact_text(angle) +
                    ": the polar angle of a cap's rim must lie strictly between 0 and pi (radians; pi/2 is a "
                    "hemisphere). Take the start shape 'disc' for a flat one.");
  return make_cap(angle, area, degree, refinement, axial, growth);
}

SurfaceDiscretization disc(const double area, const unsigned int degree, const Refinement &refinement, const bool axial)
{
  return make_cap(0., area, degree, refinement, axial, 0.);
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
// Start shape of a drop between two plates: circular arcs that meet both at the contact angle.
#include <pellicle/base/exact_text.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/builders.h>
#include <pellicle/models/droplet_start.h>

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pellicle
{
namespace
{
constexpr double steepest = 85. * pi / 180.; // of an arc at the plates
constexpr double flattest = 1e-3;
constexpr double thinnest = 0.05; // smallest radius over that of the cylinder

/** (r, z)(t), 0 <= t <= 1, from the lower plate to the upper one at z = h; rim radius a, rim angle theta. */
struct Arc
{
  double a, h, bend; ///< bend = theta - 90 degrees

  std::array<double, 2> at(const double t) const
  {
    if (std::abs(bend) < flattest)
      return {{a, h * t}};
    const double psi = (2. * t - 1.) * bend, radius = 0.5 * h / std::sin(bend);
    return {{a + radius * (std::cos(psi) - std::cos(bend)), 0.5 * h + radius * std::sin(psi)}};
  }

  double volume() const
  {
    const auto disc = [&](const double t)
    {
      const double dz = std::abs(bend) < flattest ? h : h / std::sin(bend) * bend * std::cos((2. * t - 1.) * bend);
      const double r  = at(t)[0];
      return pi * r * r * dz;
    };
    return boost::math::quadrature::gauss<double, 30>::integrate(disc, 0., 1.);
  }

  double smallest_radius() const { return std::min(a, at(0.5)[0]); }
};

Arc arc_of_volume(const double volume, const double h, const double angle)
{
  const double cylinder = std::sqrt(volume / (pi * h));
  const double bend     = std::clamp(angle - 0.5 * pi, -steepest, steepest);
  const auto excess     = [&](const double a) { return Arc{a, h, bend}.volume() - volume; };
  double lower = 0., upper = cylinder;
  while (excess(upper) < 0.)
    upper *= 2.;
  if (excess(lower) >= 0.)
    return {cylinder, h, 0.};
  std::uintmax_t iterations = 100;
  const auto bracket        = boost::math::tools::toms748_solve(excess, lower, upper,
                                                                boost::math::tools::eps_tolerance<double>(40), iterations);
  const Arc arc{0.5 * (bracket.first + bracket.second), h, bend};
  return arc.smallest_radius() > thinnest * cylinder ? arc : Arc{cylinder, h, 0.};
}
} // namespace

SurfaceDiscretization droplet_bridge(const DropletScene &scene)
{
  const double h = scene.substrate.plate_distance, volume = scene.droplet.volume;
  const Arc arc         = arc_of_volume(volume, h, scene.droplet.contact_angle * pi / 180.);
  const double cylinder = std::sqrt(volume / (pi * h));
  SurfaceDiscretization surface =
      tube(h / cylinder, 2. * pi * cylinder * h, static_cast<unsigned int>(scene.mesh.degree), scene.mesh.refinement(),
           scene.mesh.symmetry == "axial");
  for (std::size_t I = 0; I < surface.n_nodes; ++I)
  {
    double *const x    = surface.positions.data() + 3 * I;
    const auto [r, z]  = arc.at(std::clamp(x[2] / h + 0.5, 0., 1.));
    const double scale = r / std::hypot(x[0], x[1]);
    x[0] *= scale;
    x[1] *= scale;
    x[2] = z;
  }
  for (EdgeLoop &rim : surface.edges)
  {
    const bool upper = rim.name == "upper rim";
    rim.name         = upper ? upper_contact_line : contact_line;
    for (const std::size_t node : rim.cell_nodes)
      surface.positions[3 * node + 2] = upper ? h : 0.;
  }
  surface.mesh_reference = surface.positions;
  return surface;
}
} // namespace pellicle

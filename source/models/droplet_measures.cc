// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/constants.h>
#include <pellicle/discretization/point_walk.h>
#include <pellicle/models/contact_line_measures.h>
#include <pellicle/models/droplet_measures.h>
#include <pellicle/models/largest_value.h>
#include <pellicle/models/region_measures.h>
#include <pellicle/potentials/wetting/base_integral.h>

#include <algorithm>
#include <cmath>

namespace pellicle
{
namespace
{
/** z component of the pressure on the base, which pushes against `area`. */
struct PressureForceIntegrand
{
  LiquidPressure pressure;

  double operator()(const PlaceOnSubstrate<double> &S) const { return pressure(S.place) * S.area[2]; }
};

const EdgeLoop &line_named(const SurfaceDiscretization &surface, const std::string &name)
{
  const auto found =
      std::find_if(surface.edges.begin(), surface.edges.end(), [&](const EdgeLoop &loop) { return loop.name == name; });
  PELLICLE_ASSERT(found != surface.edges.end(), "a drop without its line");
  return *found;
}

template <typename Integrand>
double over_base(const SurfaceDiscretization &surface, const WettedBase &base, const NodalVectors &positions,
                 const Integrand &integrand)
{
  const EdgeLoop &line = line_named(surface, base.line);
  return std::visit(
      [&](const auto &chart)
      {
        const BaseIntegral<std::decay_t<decltype(chart)>, Integrand> integral{chart, integrand};
        double sum = 0.;
        for_all_points(line.tables, line.cell_nodes, positions, 2,
                       [&](const WalkPoint &x) { sum += x.weight * integral.along_line(x[0], x[1]); });
        return sum;
      },
      base.chart);
}

/** z components of the forces with which the surface presses on each body. */
std::vector<double> contact_forces(const SurfaceModel &model)
{
  const SurfaceProblem &problem = model.equilibrium();
  const auto &bodies            = model.scene_targets().drop().bodies;
  const NodalVectors forces     = problem.nodal_forces().total;
  std::vector<double> sums(bodies.size(), 0.);
  for (std::size_t I = 0; I < model.mesh().n_nodes; ++I)
    for (std::size_t b = 0; b < bodies.size(); ++b)
      if (problem.body_of(I) == bodies[b])
        sums[b] -= forces[3 * I + 2];
  return sums;
}
} // namespace

std::vector<NamedQuantity> measure_droplet(const SurfaceModel &model)
{
  const SurfaceDiscretization &surface = model.mesh();
  const NodalVectors positions         = model.positions();
  const DropletTargets &drop           = model.scene_targets().drop();

  LiquidPressure pressure;
  for (const NamedQuantity &force : model.forces())
    if (force.name == "pressure")
      pressure.at_origin = force.value;
  if (model.has_energy("gravity"))
    pressure.force = drop.body_force;

  std::vector<NamedQuantity> list;
  const auto report = [&](const std::string &name, const double value, const Dimension dimension) {
    list.push_back({name, value, dimension});
  };
  constexpr Dimension force_dimension{1, -1};
  report("apex_height",
         largest_value(CellGeometry(surface, positions), {{0., 0., 1.}, Vector3<double>(), Vector3<double>()}),
         dimensions::length);
  const std::vector<RegionMeasures> regions = measure_regions(surface, positions, pressure);
  double volume                             = 0.;
  for (const RegionMeasures &region : regions)
    volume += region.volume;
  for (const WettedBase &base : drop.bases)
    volume += over_base(surface, base, positions, BaseVolumeIntegrand{});
  if (!surface.is_closed())
    report("volume", volume, dimensions::volume);
  report("liquid_weight", norm(pressure.force) * volume, force_dimension);

  report("liquid_gas_area", regions[0].area, dimensions::area);
  double wetted = 0., wetted_below = 0., push = 0.;
  if (!drop.bases.empty())
  {
    wetted = wetted_below = over_base(surface, drop.bases[0], positions, AreaIntegrand{});
    for (std::size_t b = 1; b < drop.bases.size(); ++b)
      wetted += over_base(surface, drop.bases[b], positions, AreaIntegrand{});
    push = over_base(surface, drop.bases[0], positions, PressureForceIntegrand{pressure});
  }
  else if (drop.has_base_membrane)
  {
    wetted = wetted_below = regions[1].area;
    push                  = -regions[1].push;
  }
  else
  {
    const std::vector<double> forces = contact_forces(model);
    push                             = -forces[0];
    wetted_below                     = push / pressure.at_origin;
    wetted                           = wetted_below;
    if (forces.size() > 1)
    {
      report("plate_force", forces[1], force_dimension);
      wetted += forces[1] / pressure.at_origin;
    }
  }
  report("contact_radius", std::sqrt(std::max(0., wetted_below) / pi), dimensions::length);
  report("solid_liquid_area", wetted, dimensions::area);
  report("base_pressure_force", push, force_dimension);
  if (surface.edges.empty())
    return list;

  const ContactLineMeasures line = measure_contact_line(model, line_named(surface, contact_line));
  report("contact_angle_degrees", line.mean, dimensions::none);
  if (surface.kind == SurfaceDiscretization::Kind::surface)
  {
    report("contact_angle_degrees_min", line.smallest, dimensions::none);
    report("contact_angle_degrees_max", line.largest, dimensions::none);
  }
  if (drop.bodies.size() > 1)
    report("plate_force", push - line.normal_pull, force_dimension);
  return list;
}
} // namespace pellicle

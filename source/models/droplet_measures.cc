// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/constants.h>
#include <pellicle/discretization/point_walk.h>
#include <pellicle/models/cell_geometry.h>
#include <pellicle/models/droplet_measures.h>
#include <pellicle/models/largest_value.h>
#include <pellicle/models/line_forces.h>
#include <pellicle/models/shape_measures.h>
#include <pellicle/models/surface_model.h>
#include <pellicle/potentials/wetting/base_integral.h>

#include <algorithm>
#include <cmath>

namespace pellicle
{
namespace
{
/** z component of the pressure p = P + f . x on the base, which pushes against `area`. */
struct PressureForceIntegrand
{
  double pressure = 0.;
  Vector3<double> force;

  double operator()(const PlaceOnSubstrate<double> &S) const { return (pressure + dot(force, S.place)) * S.area[2]; }
};

template <typename Integrand>
double over_base(const SubstrateChart &chart, const EdgeLoop &line, const NodalVectors &positions,
                 const Integrand &integrand)
{
  return std::visit(
      [&](const auto &substrate)
      {
        const BaseIntegral<std::decay_t<decltype(substrate)>, Integrand> base{substrate, integrand};
        double sum = 0.;
        for_all_points(line.tables, line.cell_nodes, positions, 2,
                       [&](const WalkPoint &x) { sum += line.tables.weights[x.q] * base.along_line(x[0], x[1]); });
        return sum;
      },
      chart);
}

struct Angles
{
  double mean = 0., smallest = 0., largest = 0.; ///< degrees
};

/** From gamma cos(theta) = tangential pull across the line, per length. */
Angles contact_angles(const SurfaceModel &model, const EdgeLoop &line, const double tension)
{
  Angles angles{0., 180., 0.};
  double length = 0.;
  for (const auto &[node, at] : line_forces(model.equilibrium(), line, model.scene_targets().drop().substrate))
  {
    const double theta = std::acos(std::clamp(at.pull / (tension * at.length), -1., 1.)) * 180. / pi;
    angles.mean += theta * at.length;
    length += at.length;
    angles.smallest = std::min(angles.smallest, theta);
    angles.largest  = std::max(angles.largest, theta);
  }
  angles.mean /= length;
  return angles;
}
} // namespace

std::vector<NamedQuantity> measure_droplet(const SurfaceModel &model)
{
  const SurfaceDiscretization &surface = model.mesh();
  const NodalVectors positions         = model.positions();
  const DropletTargets &drop           = model.scene_targets().drop();
  const EdgeLoop &line                 = surface.edges.front();
  const CellGeometry geometry(surface, positions);
  const ShapeMeasures shape = measure_shape(surface, positions);

  double pressure = 0.;
  for (const NamedQuantity &force : model.forces())
    if (force.name == "pressure")
      pressure = force.value;
  const bool has_weight       = model.has_energy("gravity");
  const Vector3<double> force = has_weight ? drop.body_force : Vector3<double>();

  const double wetted = over_base(drop.substrate, line, positions, AreaIntegrand{});
  const double volume = shape.volume + over_base(drop.substrate, line, positions, BaseVolumeIntegrand{});
  std::vector<NamedQuantity> list;
  const auto report = [&](const std::string &name, const double value, const Dimension dimension) {
    list.push_back({name, value, dimension});
  };
  report("volume", volume, dimensions::volume);
  report("contact_radius", std::sqrt(std::max(0., wetted) / pi), dimensions::length);
  const Angles angles = contact_angles(model, line, drop.surface_tension);
  report("contact_angle_degrees", angles.mean, dimensions::none);
  if (surface.kind == SurfaceDiscretization::Kind::surface)
  {
    report("contact_angle_degrees_min", angles.smallest, dimensions::none);
    report("contact_angle_degrees_max", angles.largest, dimensions::none);
  }
  report("apex_height", largest_value(geometry, {{0., 0., 1.}, Vector3<double>(), Vector3<double>()}),
         dimensions::length);
  report("liquid_gas_area", shape.area, dimensions::area);
  report("solid_liquid_area", wetted, dimensions::area);
  report("base_pressure_force", over_base(drop.substrate, line, positions, PressureForceIntegrand{pressure, force}),
         {1, -1});
  report("liquid_weight", norm(force) * volume, {1, -1});
  return list;
}
} // namespace pellicle

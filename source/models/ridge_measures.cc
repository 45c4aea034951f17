// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/edge_frames.h>
#include <pellicle/base/constants.h>
#include <pellicle/discretization/point_walk.h>
#include <pellicle/models/eshelby_forces.h>
#include <pellicle/models/largest_value.h>
#include <pellicle/models/region_measures.h>
#include <pellicle/models/ridge_measures.h>
#include <pellicle/models/sheet_tangents.h>
#include <pellicle/potentials/material_position.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace pellicle
{
namespace
{
constexpr double degree = pi / 180.;
constexpr Dimension force_dimension{1, -1};

/** Mean over the line, smallest and largest of what its nodes have. */
struct AlongLine
{
  double sum = 0., length = 0.;
  double smallest = std::numeric_limits<double>::infinity(), largest = -std::numeric_limits<double>::infinity();

  void add(const double value, const double weight)
  {
    sum += weight * value;
    length += weight;
    smallest = std::min(smallest, value);
    largest  = std::max(largest, value);
  }
  double mean() const { return sum / length; }
};

/** Lengths of the nodes of a line: integral of N_I ds. */
std::map<std::size_t, double> nodal_lengths(const EdgeLoop &line, const NodalVectors &positions)
{
  std::map<std::size_t, double> lengths;
  for_all_points(line.tables, line.cell_nodes, positions, 2,
                 [&](const WalkPoint &x)
                 {
                   for (unsigned int I = 0; I < line.tables.n_nodes; ++I)
                     lengths[x.nodes[I]] +=
                         x.weight * norm(x[1]) * line.tables.tables[0][std::size_t(x.q) * line.tables.n_nodes + I];
                 });
  return lengths;
}

/** Polar angle of a tangent in the plane across the line, from the horizontal direction away from the drop towards z;
 * in [0, 2 pi). */
double polar_angle(const Vector3<double> &tangent, const Vector3<double> &outwards)
{
  const double angle = std::atan2(tangent[2], dot(tangent, outwards));
  return angle < 0. ? angle + 2. * pi : angle;
}

/** Angle through the liquid between a cap's tangent and the horizontal, from its polar angle: above pi where the cap
 * leaves the line downwards and away from the drop. */
double apparent_angle(const double polar)
{
  return pi - (polar > 1.5 * pi ? polar - 2. * pi : polar);
}

double wrapped(const double angle)
{
  return angle < 0. ? angle + 2. * pi : angle;
}

/** Sum of the forces with which the held faces of the substrate are held. */
Vector3<double> reaction(const SurfaceModel &model)
{
  const SurfaceDiscretization &mesh = model.mesh();
  const NodalVectors forces         = model.equilibrium().nodal_forces().total;
  std::set<std::size_t> held;
  for (const char *face : {"bottom", "side"})
  {
    const auto &nodes = mesh.bulks.front().faces.at(face);
    held.insert(nodes.begin(), nodes.end());
  }
  Vector3<double> sum;
  for (const std::size_t node : held)
    sum += vector_at(forces, node);
  // On a meridian the forces across the axis, and on half a model those across its plane, balance.
  if (mesh.kind == SurfaceDiscretization::Kind::meridian)
    return {0., 0., sum[2]};
  const EdgeLoop &line = mesh.edges.front();
  const bool is_half   = line.cell_nodes.front() != line.cell_nodes.back();
  return {sum[0], is_half ? 0. : sum[1], sum[2]};
}
} // namespace

std::vector<NamedQuantity> measure_ridge(const SurfaceModel &model)
{
  const SurfaceDiscretization &surface = model.mesh();
  const SurfaceProblem &problem        = model.equilibrium();
  const NodalVectors positions         = model.positions();
  const DropletTargets &drop           = model.scene_targets().drop();
  const EdgeLoop &line                 = surface.edges.front();

  std::vector<NamedQuantity> list;
  const auto report = [&](const std::string &name, const double value, const Dimension dimension) {
    list.push_back({name, value, dimension});
  };
  const std::vector<RegionMeasures> regions = measure_regions(surface, positions);
  const double volume                       = regions[0].volume + regions[1].volume; // cap and wetted top
  report("volume", volume, dimensions::volume);
  const double apex =
      largest_value(CellGeometry(surface, positions), {{0., 0., 1.}, Vector3<double>(), Vector3<double>()});
  report("liquid_gas_area", regions[0].area, dimensions::area);
  report("solid_liquid_area", regions[1].area, dimensions::area);
  report("solid_gas_area", regions[2].area, dimensions::area);
  report("liquid_weight", model.has_energy("gravity") ? norm(drop.body_force) * volume : 0., force_dimension);

  const auto &fields = problem.layout();
  const NodalVectors &material =
      fields.has(material_position) ? problem.state().fields[fields.index(material_position)] : surface.positions;
  PotentialSet solid;
  for (const auto &energy : problem.potentials().energies)
    if (energy->name() == "solid")
      solid.energies.push_back(energy);
  const NodalVectors of_solid = problem.nodal_forces(solid);

  const auto lengths = nodal_lengths(line, positions);
  std::array<std::map<std::size_t, Vector3<double>>, 3> tangents;
  for (unsigned int region = 0; region < 3; ++region)
    tangents[region] = sheet_tangents(surface, positions, line, region);
  const auto along_line = nodal_line_tangents(surface, positions);
  AlongLine height, radius, material_radius, apparent, liquid, gas, imbalance;
  for (const auto &[node, length] : lengths)
  {
    const Vector3<double> x = vector_at(positions, node), X = vector_at(material, node), &t = along_line.at(node);
    const Vector3<double> across   = cross(t, {0., 0., 1.}); // the line runs with the drop on its left
    const Vector3<double> outwards = (1. / norm(across)) * across;
    std::array<double, 3> angle{};
    for (unsigned int region = 0; region < 3; ++region)
      angle[region] = polar_angle(tangents[region].at(node), outwards);
    height.add(x[2], length);
    radius.add(std::hypot(x[0], x[1]), length);
    material_radius.add(std::hypot(X[0], X[1]), length);
    apparent.add(apparent_angle(angle[0]) / degree, length);
    liquid.add(wrapped(angle[1] - angle[0]) / degree, length);
    gas.add(wrapped(angle[0] - angle[2]) / degree, length);
    // Along the line a solid's forces are stresses of its own; what is left must balance the three tensions.
    Vector3<double> force = vector_at(of_solid, node);
    force -= dot(force, t) * t;
    imbalance.add(norm(force) / (length * drop.surface_tension), length);
  }
  const auto report_along = [&](const std::string &name, const AlongLine &values, const Dimension dimension)
  {
    report(name, values.mean(), dimension);
    if (surface.kind == SurfaceDiscretization::Kind::meridian)
      return;
    report(name + "_min", values.smallest, dimension);
    report(name + "_max", values.largest, dimension);
  };
  report("apex_height", apex - height.mean(), dimensions::length);
  report("apex_elevation", apex, dimensions::length);
  report_along("ridge_height", height, dimensions::length);
  report_along("ridge_radius", radius, dimensions::length);
  report_along("contact_line_material_radius", material_radius, dimensions::length);
  report_along("apparent_contact_angle_degrees", apparent, dimensions::none);
  report("neumann_angle_liquid_degrees", liquid.mean(), dimensions::none);
  report("neumann_angle_gas_degrees", gas.mean(), dimensions::none);
  report("neumann_angle_solid_degrees", 360. - liquid.mean() - gas.mean(), dimensions::none);
  report("line_force_imbalance", imbalance.mean(), dimensions::none);
  if (fields.has(material_position))
  {
    AlongLine eshelby;
    for (const auto &[node, force] : eshelby_forces(problem, line, line_shift(surface)))
      eshelby.add(force.per_length(), force.length);
    report_along("line_eshelby_force", eshelby, dimensions::tension);
  }
  const Vector3<double> held = reaction(model);
  report("substrate_reaction_x", held[0], force_dimension);
  report("substrate_reaction_y", held[1], force_dimension);
  report("substrate_reaction_z", held[2], force_dimension);
  return list;
}
} // namespace pellicle

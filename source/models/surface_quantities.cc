// SPDX-License-Identifier: LGPL-2.1-or-later
// What users read of a surface model: quantities and sampled fields, scaled back to their units.
#include <pellicle/assembly/edge_frames.h>
#include <pellicle/base/constants.h>
#include <pellicle/discretization/sheets.h>
#include <pellicle/models/make_sample.h>
#include <pellicle/models/nodal_curvature.h>
#include <pellicle/models/sample_body.h>
#include <pellicle/models/shape_measures.h>
#include <pellicle/models/surface_model.h>
#include <pellicle/potentials/director/director_fields.h>
#include <pellicle/potentials/shell/cosserat_shell.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pellicle
{
namespace
{
/** "surface tension" -> "surface_tension_energy". */
std::string energy_quantity(const std::string &potential)
{
  if (potential == "helfrich bending")
    return "bending_energy";
  if (potential == "gaussian curvature")
    return "gaussian_energy";
  if (potential == "line pinning")
    return "pinning_dissipation";
  std::string name = potential + "_energy";
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

/** The field of the undeformed places of a body's nodes, where they are unknown. */
constexpr const char *material_position = "material position";

Dimension dimension_of(const Field &field)
{
  if (field.name == material_position)
    return dimensions::length;
  return field.space == FieldSpace::unit_vectors || field.name == shell_director ? dimensions::none
                                                                                 : dimensions::line_tension;
}

/** Whether the mesh is a part of a shell between mirror planes: its weights count the images, too. */
bool is_part_of_shell(const SurfaceDiscretization &discretization)
{
  const std::vector<double> &weights = discretization.tables.weights;
  return discretization.kind == SurfaceDiscretization::Kind::surface &&
         std::accumulate(weights.begin(), weights.end(), 0.) > 1.5; // the unit cell has area 1
}

/** Adds to the quantity of that name, or appends it. */
template <typename Quantity>
void add_to(std::vector<Quantity> &list, const Quantity &quantity)
{
  const auto same = std::find_if(list.begin(), list.end(), [&](const Quantity &q) { return q.name == quantity.name; });
  if (same != list.end())
    same->value += quantity.value;
  else
    list.push_back(quantity);
}
} // namespace

// Potentials of one name are one energy (bending on several regions). Constraints of curvature take their share of the
// bending energy by the moment's shift, and some constraints of finite stiffness are energies themselves.
std::vector<NamedQuantity> SurfaceModel::energies() const
{
  const PotentialSet &set  = problem->potentials();
  const TermValues &values = problem->values();
  std::vector<NamedQuantity> list;
  for (std::size_t k = 0; k < set.energies.size(); ++k)
    add_to(list, {energy_quantity(set.energies[k]->name()), values.energies[k], dimensions::energy});
  if (problem->pairs())
    for (std::size_t k = 0; k < values.pairs.size(); ++k)
      add_to(list, {energy_quantity(problem->pairs()->terms()[k]->name()), values.pairs[k], dimensions::energy});
  const double shift = energy_of_self_terms(values, problem->state().multipliers);
  if (shift != 0.)
    add_to(list, {"bending_energy", shift, dimensions::energy});
  for (const NamedQuantity &constant : set.constants)
    add_to(list, constant);
  for (std::size_t k = 0; k < set.constraints.size(); ++k)
    if (const Constraint &constraint = set.constraints[k]; !constraint.energy.empty())
    {
      const double difference = values.constraints[k] - constraint.target;
      add_to(list, {constraint.energy, 0.5 * constraint.stiffness * difference * difference, dimensions::energy});
    }
  return list;
}

bool SurfaceModel::has_energy(const std::string &name) const
{
  const auto &listed = problem->potentials().energies;
  return std::any_of(listed.begin(), listed.end(), [&](const auto &energy) { return energy->name() == name; });
}

double SurfaceModel::potential_energy() const
{
  const PotentialSet &set  = problem->potentials();
  const TermValues &values = problem->values();
  double sum               = problem->energy();
  for (std::size_t k = 0; k < set.constraints.size(); ++k)
    if (const Constraint &constraint = set.constraints[k]; std::isfinite(constraint.stiffness))
      sum += 0.5 * constraint.stiffness * std::pow(values.constraints[k] - constraint.target, 2);
  return sum;
}

// Of L = E + sum lambda (g - g0) only what depends on the parameter explicitly counts, for L is stationary otherwise.
std::optional<double> SurfaceModel::energy_slope(const SurfaceScene &scene, const std::string &parameter) const
{
  std::optional<double> slope;
  const std::vector<Constraint> &constraints = problem->potentials().constraints;
  for (const ParameterDerivative &derivative : scene.derivatives(unit, targets))
  {
    if (derivative.parameter != parameter)
      continue;
    slope = slope.value_or(0.);
    if (derivative.energy)
    {
      PotentialSet alone;
      alone.energies.push_back(derivative.energy);
      *slope += problem->value_of(alone);
    }
    for (std::size_t k = 0; k < constraints.size(); ++k)
      if (constraints[k].quantity == derivative.quantity)
      {
        const double of_measure = derivative.measure ? problem->value_of({{derivative.measure}, {}, {}, {}}) : 0.;
        *slope += problem->state().multipliers[k] * (of_measure - derivative.target);
      }
  }
  return slope;
}

// Tension and pressure: prescribed, or multiplier of a constraint, or (with a finite stiffness) the sum of both.
std::vector<NamedQuantity> SurfaceModel::forces() const
{
  const PotentialSet &set         = problem->potentials();
  std::vector<NamedQuantity> list = set.prescribed;
  for (std::size_t k = 0; k < set.constraints.size(); ++k)
  {
    const Constraint &constraint = set.constraints[k];
    add_to(list, {constraint.multiplier,
                  constraint.multiplier_sign * problem->state().multipliers[k],
                  {1 - constraint.dimension.energy, -constraint.dimension.length}});
  }
  return list;
}

std::vector<std::pair<std::string, double>> SurfaceModel::quantities() const
{
  std::vector<std::pair<std::string, double>> list;
  const auto report = [&](const std::string &name, const double value, const Dimension dimension)
  { list.emplace_back(name, value * unit.of(dimension)); };
  // Sheets that meet at a junction are no single shape; of parts of shells the images are not made.
  const bool is_one_shape   = planes.any() || (!discretization.has_junctions() && !is_part_of_shell(discretization));
  const ShapeMeasures shape = is_one_shape ? measure_whole() : ShapeMeasures();
  const bool is_closed      = is_one_shape && discretization.is_closed();
  if (is_one_shape)
    report("area", shape.area, dimensions::area);
  if (is_closed)
  {
    report("volume", shape.volume, dimensions::volume);
    report("reduced_volume", shape.reduced_volume, dimensions::none);
  }
  double total = 0.;
  for (const NamedQuantity &energy : energies())
  {
    report(energy.name, energy.value, energy.dimension);
    if (energy.name == "bending_energy")
      report("bending_energy_over_8_pi_kappa", energy.value / (8. * pi * targets.bending[0].rigidity),
             dimensions::none);
    total += energy.value;
  }
  report("total_energy", total, dimensions::energy);
  if (current_motion)
  {
    report("dissipation", current_motion->dissipation(), dimensions::power);
    report("energy_balance_error", current_motion->balance().relative_error(), dimensions::none);
  }
  for (const NamedQuantity &force : forces())
    report(force.name, force.value, force.dimension);
  // Measures that nothing else reports: length of a tether, area of a domain.
  const PotentialSet &set = problem->potentials();
  for (std::size_t k = 0; k < set.constraints.size(); ++k)
    if (set.constraints[k].is_own_quantity)
      report(set.constraints[k].quantity, problem->values().constraints[k], set.constraints[k].dimension);
  if (own_measures)
    for (const NamedQuantity &quantity : own_measures(*this))
      report(quantity.name, quantity.value, quantity.dimension);
  if (!is_one_shape)
    return list;
  const NodalCurvature curvature = nodal_curvature(discretization, positions());
  report("integrated_mean_curvature",
         integrated_mean_curvature(discretization, positions(), curvature.curvature_vector), dimensions::length);
  report("gauss_bonnet", shape.gauss_bonnet, dimensions::none);
  report("height", shape.height, dimensions::length);
  report("equatorial_radius", shape.equatorial_radius, dimensions::length);
  if (is_closed)
    report("axis_thickness", shape.axis_thickness, dimensions::length);
  report("min_cell_quality", shape.min_cell_quality, dimensions::none);
  report("cell_area_ratio", shape.cell_area_ratio, dimensions::none);
  return list;
}

SurfaceSample SurfaceModel::sample() const
{
  const auto scaled_values = [](std::vector<double> values, const double factor)
  {
    for (double &value : values)
      value *= factor;
    return values;
  };
  const SurfaceState &state = problem->state();
  // Of sheets that meet at a junction, or end on a body, each has its own normals and curvatures there.
  const std::optional<Sheets> sheets   = discretization.bulks.empty() && !discretization.has_junctions()
                                             ? std::nullopt
                                             : std::optional(sheets_of(discretization));
  const SurfaceDiscretization &surface = sheets ? sheets->surface : discretization;
  const auto of_surface                = [&](const NodalVectors &values)
  { return sheets ? sheets->values(on_mesh(values), 3) : on_mesh(values); };
  const NodalCurvature curvature = nodal_curvature(surface, of_surface(state.fields[0]));

  std::vector<SampledNodalField> fields;
  fields.push_back(
      {"mean_curvature_outward", 1, scaled_values(curvature.mean_outward, unit.of(dimensions::curvature))});
  fields.push_back({"gauss_curvature", 1, scaled_values(curvature.gauss, unit.of(dimensions::gauss_curvature))});
  for (std::size_t f = 1; f < state.fields.size(); ++f)
    if (const Field &field = problem->layout().fields()[f];
        field.space != FieldSpace::bulk_scalars && field.space != FieldSpace::lower_degree_vectors)
      fields.push_back({field.name == shell_director ? std::string(director) : field.name, 3,
                        scaled_values(of_surface(state.fields[f]), unit.of(dimension_of(field)))});
  if (problem->layout().has(director))
    fields.push_back({"tilt", 3,
                      tangential_parts(of_surface(state.fields[problem->layout().index(director)]),
                                       nodal_normals(surface, of_surface(state.fields[0])))});
  if (problem->layout().has(shell_director))
  {
    NodalVectors displacements = state.fields[0];
    for (std::size_t i = 0; i < displacements.size(); ++i)
      displacements[i] -= discretization.positions[i];
    fields.push_back({"displacement", 3, scaled_values(of_surface(displacements), unit.length)});
  }

  if (last_stability)
    for (std::size_t k = 0; k < last_stability->modes.size(); ++k)
      fields.push_back({"mode_" + std::to_string(k + 1), 3, of_surface(last_stability->modes[k])});

  const auto at_centroid = [&](NodalVectors all)
  {
    for (std::size_t i = 0; i < all.size(); ++i)
      all[i] += centroid[i % 3];
    return all;
  };
  const NodalVectors positions = scaled_values(of_surface(state.fields[0]), unit.length);
  if (planes.any())
  {
    const UnfoldedSurface whole(surface, planes);
    for (SampledNodalField &field : fields)
      field.values = whole.values(field.values, field.n_components);
    return make_sample(whole.surface(), at_centroid(whole.values(positions, 3)), fields);
  }
  return make_sample(surface, at_centroid(positions), fields);
}

ShapeMeasures SurfaceModel::measure_whole() const
{
  if (!planes.any())
    return measure_shape(discretization, positions());
  const UnfoldedSurface whole(discretization, planes);
  return measure_shape(whole.surface(), whole.values(positions(), 3));
}

std::vector<NamedSample> SurfaceModel::body_samples() const
{
  const FieldLayout &layout     = problem->layout();
  const NodalVectors &reference = layout.has(material_position)
                                      ? problem->state().fields[layout.index(material_position)]
                                      : discretization.positions;
  std::vector<NamedSample> list;
  for (const BulkPart &body : discretization.bulks)
    list.push_back({body.name, sample_body(*problem, discretization, body, reference, unit)});
  return list;
}
} // namespace pellicle

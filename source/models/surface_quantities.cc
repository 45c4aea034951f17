// SPDX-License-Identifier: LGPL-2.1-or-later
// What users read of a surface model: quantities and sampled fields, scaled back to their units.
#include <pellicle/models/make_sample.h>
#include <pellicle/models/nodal_curvature.h>
#include <pellicle/models/shape_measures.h>
#include <pellicle/models/surface_model.h>

#include <algorithm>

namespace pellicle
{
std::vector<std::pair<std::string, double>> SurfaceModel::quantities() const
{
  const SurfaceState &state      = problem->state();
  const NodalVectors &positions  = state.fields[0];
  const ShapeMeasures shape      = measure_shape(discretization, positions);
  const NodalCurvature curvature = nodal_curvature(discretization, positions);

  std::vector<std::pair<std::string, double>> list;
  const auto report = [&](const std::string &name, const double value, const Dimension dimension)
  { list.emplace_back(name, value * unit.of(dimension)); };
  report("area", shape.area, dimensions::area);
  report("volume", shape.volume, dimensions::volume);
  report("reduced_volume", shape.reduced_volume, dimensions::none);
  const PotentialSet &set = problem->potentials();
  for (std::size_t k = 0; k < set.energies.size(); ++k)
    if (set.energies[k]->name() == "helfrich bending")
    {
      const double energy = problem->values().energies[k];
      report("bending_energy", energy, dimensions::energy);
      report("bending_energy_over_8_pi_kappa", energy / (8. * 3.141592653589793 * bending_rigidity), dimensions::none);
    }
  report("total_energy", problem->energy(), dimensions::energy);
  // Tension and pressure: prescribed, or multiplier of a constraint, or (with a finite stiffness) the sum of both.
  std::vector<PrescribedQuantity> forces = set.prescribed;
  for (std::size_t k = 0; k < set.constraints.size(); ++k)
  {
    const Constraint &constraint = set.constraints[k];
    const double multiplier      = constraint.multiplier_sign * state.multipliers[k];
    const auto same              = std::find_if(forces.begin(), forces.end(),
                                                [&](const PrescribedQuantity &f) { return f.name == constraint.multiplier; });
    if (same != forces.end())
      same->value += multiplier;
    else
      forces.push_back(
          {constraint.multiplier, multiplier, {1 - constraint.dimension.energy, -constraint.dimension.length}});
  }
  for (const PrescribedQuantity &force : forces)
    report(force.name, force.value, force.dimension);
  report("integrated_mean_curvature", integrated_mean_curvature(discretization, positions, curvature.curvature_vector),
         dimensions::length);
  report("gauss_bonnet", shape.gauss_bonnet, dimensions::none);
  report("height", shape.height, dimensions::length);
  report("equatorial_radius", shape.equatorial_radius, dimensions::length);
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
  const SurfaceState &state      = problem->state();
  const NodalCurvature curvature = nodal_curvature(discretization, state.fields[0]);

  std::vector<SampledNodalField> fields;
  fields.push_back(
      {"mean_curvature_outward", 1, scaled_values(curvature.mean_outward, unit.of(dimensions::curvature))});
  fields.push_back({"gauss_curvature", 1, scaled_values(curvature.gauss, unit.of(dimensions::gauss_curvature))});
  for (std::size_t f = 1; f < state.fields.size(); ++f)
    fields.push_back(
        {problem->layout().fields()[f].name, 3, scaled_values(state.fields[f], unit.of(dimensions::line_tension))});

  NodalVectors positions = scaled_values(state.fields[0], unit.length);
  for (std::size_t i = 0; i < positions.size(); ++i)
    positions[i] += centroid[i % 3];
  return make_sample(discretization, positions, fields);
}
} // namespace pellicle

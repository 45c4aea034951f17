// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/edge_frames.h>
#include <pellicle/discretization/point_walk.h>
#include <pellicle/models/eshelby_forces.h>
#include <pellicle/models/material_line_pinning.h>
#include <pellicle/models/surface_problem.h>
#include <pellicle/potentials/material_position.h>

#include <utility>

namespace pellicle
{
namespace
{
// Of forces over gamma_LG, and of shifts in internal length: below them is what Newton's method leaves.
constexpr double force_tolerance = 1e-7, slip_tolerance = 1e-10;
} // namespace

MaterialLinePinning::MaterialLinePinning(const SurfaceDiscretization &ridge, const SceneTargets &targets)
    : line(ridge.edges.front())
    , shift(line_shift(ridge))
    , slip(line)
{
  take(targets);
}

const std::string &MaterialLinePinning::name() const
{
  static const std::string text = line_friction_energy;
  return text;
}

void MaterialLinePinning::take(const SceneTargets &targets)
{
  const DropletTargets &drop = targets.drop();
  thresholds                 = targets.soft_substrate().thresholds;
  tolerance                  = force_tolerance * drop.surface_tension;
  is_pulled_along            = drop.body_force[0] != 0. || drop.body_force[1] != 0.;
}

void MaterialLinePinning::begin_step(const SurfaceProblem &problem)
{
  field = problem.layout().index(material_position);
  start = problem.state().fields[field];
  // A drop that advances everywhere would slide under the least force along the substrate.
  if (is_pulled_along)
    slip.forget_statuses();
  slip.begin_step(areas(start), start == last_equilibrium);
  set_friction();
}

bool MaterialLinePinning::is_stuck(const std::size_t node) const
{
  return shift.weight[node] > 0. && slip.of_node(shift.leader[node]) == SlipStatus::stuck;
}

void MaterialLinePinning::add_conditions(NodalConditions &conditions) const
{
  FieldConditions &material = conditions[material_position];
  for (std::size_t I = 0; I < shift.weight.size(); ++I)
    if (is_stuck(I))
      material.only[I] = held();
}

void MaterialLinePinning::place(FieldValues &fields) const
{
  for (std::size_t I = 0; I < shift.weight.size(); ++I)
    if (is_stuck(I))
      for (unsigned int c = 0; c < 3; ++c)
        fields[field][3 * I + c] = start[3 * I + c];
}

void MaterialLinePinning::add_potentials(PotentialSet &set) const
{
  set.energies.push_back(make_material_line_friction(name(), slip.friction(), line.name));
}

std::size_t MaterialLinePinning::update(const SurfaceProblem &problem)
{
  const NodalVectors &X = problem.state().fields[field];
  std::vector<LineSlip::Slip> wanted;
  std::vector<std::size_t> turned_back;
  for (const auto &[I, force] : eshelby_forces(problem, line, shift))
  {
    const SlipStatus status = slip.of_node(I);
    const double f          = force.per_length();
    const double moved      = dot(vector_at(X, I) - vector_at(start, I), vector_at(shift.direction, I));
    if (status == SlipStatus::stuck && f > thresholds.advancing + tolerance)
      wanted.push_back({f - thresholds.advancing, I, SlipStatus::advancing});
    else if (status == SlipStatus::stuck && f < -thresholds.receding - tolerance)
      wanted.push_back({-f - thresholds.receding, I, SlipStatus::receding});
    else if ((status == SlipStatus::advancing && moved < -slip_tolerance) ||
             (status == SlipStatus::receding && moved > slip_tolerance))
      turned_back.push_back(I);
  }
  const std::size_t changes = slip.update(turned_back, std::move(wanted), areas(X));
  set_friction();
  if (changes == 0)
    last_equilibrium = X;
  return changes;
}

std::string MaterialLinePinning::about_failure() const
{
  return is_pulled_along ? slip.about_sliding() : "";
}

void MaterialLinePinning::exchange(Archive &archive)
{
  slip.exchange(archive);
  archive | field | start | last_equilibrium;
}

void MaterialLinePinning::set_friction()
{
  slip.set_friction(thresholds.advancing, -thresholds.receding);
}

std::vector<double> MaterialLinePinning::areas(const NodalVectors &material) const
{
  std::vector<double> densities;
  for_all_points(line.tables, line.cell_nodes, material, 2,
                 [&](const WalkPoint &X) { densities.push_back(material_area_density(X[0], X[1])); });
  return densities;
}
} // namespace pellicle

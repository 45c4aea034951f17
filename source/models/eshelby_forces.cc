// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/edge_frames.h>
#include <pellicle/models/eshelby_forces.h>
#include <pellicle/models/surface_problem.h>
#include <pellicle/potentials/material_position.h>
#include <pellicle/potentials/wetting/line_friction.h>

namespace pellicle
{
namespace
{
PotentialSet without_friction(const PotentialSet &all)
{
  PotentialSet conservative = all;
  conservative.energies.clear();
  for (const auto &energy : all.energies)
    if (energy->name() != line_friction_energy)
      conservative.energies.push_back(energy);
  return conservative;
}

PotentialSet area_inside(const EdgeLoop &line)
{
  const auto unit   = std::make_shared<LineFrictionState>();
  unit->n_points    = line.tables.n_points;
  unit->coefficient = std::vector<double>(line.n_cells, 1.);
  unit->start       = std::vector<double>(line.n_cells * line.tables.n_points, 0.);
  PotentialSet set;
  set.energies.push_back(make_material_line_friction("material area", unit, line.name));
  return set;
}
} // namespace

std::map<std::size_t, EshelbyForce> eshelby_forces(const SurfaceProblem &problem, const EdgeLoop &line,
                                                   const LineShift &shift)
{
  const NodalVectors of_energy = problem.nodal_forces(without_friction(problem.potentials()), material_position);
  const NodalVectors of_area   = problem.nodal_forces(area_inside(line), material_position);
  std::map<std::size_t, EshelbyForce> forces;
  for (const std::size_t node : line.cell_nodes)
    forces[node];
  for (std::size_t I = 0; I < shift.weight.size(); ++I)
  {
    if (shift.weight[I] == 0.)
      continue;
    const Vector3<double> shape = shift.weight[I] * vector_at(shift.direction, I);
    EshelbyForce &force         = forces.at(shift.leader[I]);
    force.outwards -= dot(shape, vector_at(of_energy, I));
    force.length += dot(shape, vector_at(of_area, I));
  }
  return forces;
}
} // namespace pellicle

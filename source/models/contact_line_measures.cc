// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/edge_frames.h>
#include <pellicle/base/constants.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/models/contact_line_measures.h>
#include <pellicle/models/line_density.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace pellicle
{
namespace
{
/** The liquid's part of the lists: without what belongs to the substrate or the line. */
PotentialSet of_the_liquid(const PotentialSet &all)
{
  PotentialSet liquid = all;
  liquid.energies.clear();
  for (const auto &energy : all.energies)
    if (energy->name() == "liquid surface" || energy->name() == "gravity" || energy->name() == "pressure")
      liquid.energies.push_back(energy);
  return liquid;
}
} // namespace

ContactLineMeasures measure_contact_line(const SurfaceModel &model, const EdgeLoop &line)
{
  const SurfaceProblem &problem = model.equilibrium();
  const NodalVectors positions  = model.positions();
  const NodalVectors forces     = problem.nodal_forces(of_the_liquid(problem.potentials()));
  const double tension          = model.scene_targets().drop().surface_tension;
  const auto tangents           = nodal_line_tangents(model.mesh(), positions);
  std::map<std::size_t, double> pull;
  for (const std::size_t node : line.cell_nodes)
  {
    const std::shared_ptr<const RigidBody> body = problem.body_of(node);
    PELLICLE_ASSERT(body != nullptr, "a contact line is on a body");
    const Vector3<double> across = cross(tangents.at(node), body->gap(vector_at(positions, node)).normal);
    pull[node]                   = dot(vector_at(forces, node), (1. / norm(across)) * across);
  }
  ContactLineMeasures result{0., 180., 0., 0.};
  double length = 0.;
  for (const LineDensity &at : density_along_line(line, positions, pull))
  {
    const double angle = std::acos(std::clamp(at.value / tension, -1., 1.));
    result.mean += 180. / pi * angle * at.length;
    result.normal_pull += tension * std::sin(angle) * at.length;
    result.smallest = std::min(result.smallest, 180. / pi * angle);
    result.largest  = std::max(result.largest, 180. / pi * angle);
    length += at.length;
  }
  result.mean /= length;
  return result;
}
} // namespace pellicle

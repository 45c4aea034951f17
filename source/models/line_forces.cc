// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/edge_frames.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/models/line_forces.h>
#include <pellicle/models/surface_problem.h>
#include <pellicle/potentials/wetting/base_integral.h>

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

std::map<std::size_t, LineForce> line_forces(const SurfaceProblem &problem, const EdgeLoop &line,
                                             const SubstrateChart &substrate)
{
  const NodalVectors &positions = problem.state().fields[0];
  PotentialSet wetted;
  wetted.energies.push_back(make_wetting("wetted area", substrate, {1., {1., nullptr}}, line.name));
  const NodalVectors pulls   = problem.nodal_forces(of_the_liquid(problem.potentials()));
  const NodalVectors lengths = problem.nodal_forces(wetted);

  const std::map<std::size_t, Vector3<double>> tangents = nodal_line_tangents(problem.discretization(), positions);
  std::map<std::size_t, LineForce> forces;
  for (const std::size_t node : line.cell_nodes)
  {
    const std::shared_ptr<const RigidBody> body = problem.body_of(node);
    PELLICLE_ASSERT(body != nullptr, "the contact line is on a body");
    const Vector3<double> m = cross(tangents.at(node), body->gap(vector_at(positions, node)).normal);
    LineForce &force        = forces[node];
    force.across            = (1. / norm(m)) * m;
    force.pull              = dot(vector_at(pulls, node), force.across);
    force.length            = dot(vector_at(lengths, node), force.across);
  }
  return forces;
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/constants.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/line_shift.h>
#include <pellicle/potentials/wetting/droplet_targets.h>
#include <pellicle/potentials/wetting/ridge_targets.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>

namespace pellicle
{
namespace
{
constexpr double rigid_distance = .35, decay_distance = .6; ///< over the ring's radius
constexpr double least_rigid = .25;                         ///< over the room that there is
constexpr double used_room   = .95;                         ///< of the distance to the axis, the bottom
constexpr double same_plane  = 1e-9;                        ///< azimuths in radians

/** C2 function from 0 to 1 on [0, 1] whose slope is 0 at the ends and no larger than 4/3: constant but for the first
 * and last quarter, where it is 3 x^2 - 2 x^3. */
double gentle_step(const double t)
{
  constexpr double f = .25;
  const auto end     = [&](const double x) { return f * x * x * x * (1. - .5 * x); };
  if (t < f)
    return end(t / f) / (1. - f);
  if (t > 1. - f)
    return 1. - end((1. - t) / f) / (1. - f);
  return (t - .5 * f) / (1. - f);
}

/** Nodes of the line by azimuth. */
class MeridianPlanes
{
public:
  MeridianPlanes(const SurfaceDiscretization &ridge, const EdgeLoop &line)
      : positions(ridge.positions)
  {
    for (const std::size_t node : line.cell_nodes)
      if (!at(node))
        nodes.emplace(azimuth(node), node);
  }

  /** The node of the line on whose half plane a node is. */
  std::optional<std::size_t> at(const std::size_t node) const
  {
    const double phi = azimuth(node);
    const auto found = nodes.lower_bound(phi - same_plane);
    if (found == nodes.end() || found->first > phi + same_plane)
      return std::nullopt;
    return found->second;
  }

private:
  double azimuth(const std::size_t node) const
  {
    const double phi = std::atan2(positions[3 * node + 1], positions[3 * node]);
    return phi < -same_plane ? phi + 2. * pi : phi;
  }

  const NodalVectors &positions;
  std::map<double, std::size_t> nodes;
};

double distance_from_axis(const NodalVectors &positions, const std::size_t node)
{
  return std::hypot(positions[3 * node], positions[3 * node + 1]);
}

/** Distances from the line at which a shift ends. */
struct Reach
{
  double inwards = 0., outwards = 0., downwards = 0.;
};

Reach reach_of(const SurfaceDiscretization &ridge, const BulkPart &body, const MeridianPlanes &planes,
               const double ring_radius, const double top_height)
{
  // Cells with a node between the planes are those around the axis.
  double core             = 0.;
  const std::size_t local = body.tables.n_nodes - body.n_pressure_nodes;
  for (std::size_t cell = 0; cell < body.n_cells; ++cell)
  {
    const auto first  = body.cell_nodes.begin() + static_cast<std::ptrdiff_t>(cell * body.tables.n_nodes),
               last   = first + static_cast<std::ptrdiff_t>(local);
    const auto astray = [&](const std::size_t node)
    { return distance_from_axis(ridge.positions, node) > 0. && !planes.at(node); };
    if (std::any_of(first, last, astray))
      for (auto node = first; node != last; ++node)
        core = std::max(core, distance_from_axis(ridge.positions, *node));
  }
  // The skin ends at the outer edge, another singular corner: were its cells to move, their errors would pull the line.
  const std::vector<std::size_t> &top = body.faces.at("top"), &side = body.faces.at("side");
  const std::set<std::size_t> on_top(top.begin(), top.end()), on_side(side.begin(), side.end());
  double outside = std::numeric_limits<double>::infinity();
  for (std::size_t cell = 0; cell < body.n_cells; ++cell)
  {
    const auto first = body.cell_nodes.begin() + static_cast<std::ptrdiff_t>(cell * body.tables.n_nodes),
               last  = first + static_cast<std::ptrdiff_t>(local);
    if (std::any_of(first, last, [&](const std::size_t node) { return on_top.count(node) * on_side.count(node) > 0; }))
      for (auto node = first; node != last; ++node)
        outside = std::min(outside, distance_from_axis(ridge.positions, *node));
  }
  const double thickness = top_height - ridge.positions[3 * body.faces.at("bottom").front() + 2];
  return {std::min(used_room * ring_radius, ring_radius - core), outside - ring_radius, used_room * thickness};
}
} // namespace

double shift_cutoff(const double distance, const double reach, const double ring_radius)
{
  const double rigid =
      std::min(rigid_distance * ring_radius, std::max(reach - decay_distance * ring_radius, least_rigid * reach));
  if (distance <= rigid)
    return 1.;
  return distance < reach ? 1. - gentle_step((distance - rigid) / (reach - rigid)) : 0.;
}

LineShift line_shift(const SurfaceDiscretization &ridge)
{
  const auto line = std::find_if(ridge.edges.begin(), ridge.edges.end(),
                                 [](const EdgeLoop &edge) { return edge.name == contact_line; });
  const auto body = std::find_if(ridge.bulks.begin(), ridge.bulks.end(),
                                 [](const BulkPart &bulk) { return bulk.name == substrate_body; });
  PELLICLE_ASSERT(line != ridge.edges.end() && body != ridge.bulks.end(), "a ridge has a line and a substrate");
  const MeridianPlanes planes(ridge, *line);
  const double a = distance_from_axis(ridge.positions, line->cell_nodes.front());
  // The undeformed top is plane, the line on it.
  const double top_height = ridge.positions[3 * line->cell_nodes.front() + 2];
  const Reach reach       = reach_of(ridge, *body, planes, a, top_height);

  LineShift shift;
  shift.leader.resize(ridge.n_nodes);
  std::iota(shift.leader.begin(), shift.leader.end(), std::size_t(0));
  shift.direction.assign(3 * ridge.n_nodes, 0.);
  shift.weight.assign(ridge.n_nodes, 0.);
  for (std::size_t cell = 0; cell < body->n_cells; ++cell)
    for (std::size_t i = 0; i < body->tables.n_nodes - body->n_pressure_nodes; ++i)
    {
      const std::size_t node = body->cell_nodes[cell * body->tables.n_nodes + i];
      const double r         = distance_from_axis(ridge.positions, node);
      const double weight    = shift_cutoff(std::abs(r - a), r < a ? reach.inwards : reach.outwards, a) *
                            shift_cutoff(top_height - ridge.positions[3 * node + 2], reach.downwards, a);
      if (weight == 0.)
        continue;
      const std::optional<std::size_t> leader = planes.at(node);
      PELLICLE_ASSERT(leader.has_value(), "nodes that are shifted are on the meridian planes of the line's nodes");
      shift.leader[node] = *leader;
      shift.weight[node] = weight;
      for (unsigned int c = 0; c < 2; ++c)
        shift.direction[3 * node + c] = ridge.positions[3 * *leader + c] / a;
    }
  return shift;
}
} // namespace pellicle

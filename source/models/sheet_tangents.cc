// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/edge_frames.h>
#include <pellicle/discretization/point_walk.h>
#include <pellicle/discretization/refined_quads.h>
#include <pellicle/models/sheet_tangents.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

namespace pellicle
{
namespace
{
/** A side of the unit cell: its nodes, and the slot and sign of the derivative that points inwards there. */
struct InwardSide
{
  std::vector<unsigned int> nodes;
  unsigned int slot = 1;
  double sign       = 1.;
};

std::vector<InwardSide> sides_of(const SurfaceDiscretization &surface)
{
  const unsigned int k = surface.degree;
  if (surface.kind == SurfaceDiscretization::Kind::meridian)
    return {{{0}, 1, 1.}, {{k}, 1, -1.}};
  std::vector<InwardSide> sides{{{}, 2, 1.}, {{}, 1, -1.}, {{}, 2, -1.}, {{}, 1, 1.}};
  for (unsigned int i = 0; i <= k; ++i)
  {
    sides[0].nodes.push_back(i);
    sides[1].nodes.push_back(i * (k + 1) + k);
    sides[2].nodes.push_back(k * (k + 1) + i);
    sides[3].nodes.push_back(i * (k + 1));
  }
  return sides;
}
} // namespace

std::map<std::size_t, Vector3<double>> sheet_tangents(const SurfaceDiscretization &surface,
                                                      const NodalVectors &positions, const EdgeLoop &line,
                                                      const unsigned int region)
{
  const bool meridian             = surface.kind == SurfaceDiscretization::Kind::meridian;
  const std::vector<double> nodes = line_nodes(surface.degree);
  std::vector<std::array<double, 2>> sites;
  for (std::size_t i = 0; i < surface.n_local(); ++i)
    sites.push_back({{0.5 * (1. + nodes[i % nodes.size()]), meridian ? 0. : 0.5 * (1. + nodes[i / nodes.size()])}});
  const ShapeTables at_nodes = make_tables_at(surface.kind, surface.degree, sites);

  const std::set<std::size_t> on_line(line.cell_nodes.begin(), line.cell_nodes.end());
  const std::vector<InwardSide> sides                         = sides_of(surface);
  const std::map<std::size_t, Vector3<double>> along_the_line = nodal_line_tangents(surface, positions);
  std::map<std::size_t, Vector3<double>> tangents;
  const auto visit = [&](const WalkCell &cell)
  {
    if (surface.cell_region[cell.number] != region)
      return;
    for (const InwardSide &side : sides)
    {
      if (!std::all_of(side.nodes.begin(), side.nodes.end(),
                       [&](const unsigned int i) { return on_line.count(cell.nodes[i]) > 0; }))
        continue;
      for (const unsigned int i : side.nodes)
      {
        const Vector3<double> t = along_the_line.at(cell.nodes[i]);
        Vector3<double> inward  = side.sign * cell[i][side.slot];
        inward -= dot(inward, t) * t;
        tangents[cell.nodes[i]] += (1. / norm(inward)) * inward;
      }
    }
  };
  for_all_cells(at_nodes, surface.cell_nodes, positions, 3, visit);
  for (auto &[node, t] : tangents)
    t = (1. / norm(t)) * t;
  return tangents;
}
} // namespace pellicle

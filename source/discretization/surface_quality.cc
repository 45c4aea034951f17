// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exact_text.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/point_walk.h>
#include <pellicle/discretization/surface_quality.h>

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

namespace pellicle
{
SurfaceQuality surface_quality(const SurfaceDiscretization &surface, const NodalVectors &positions)
{
  SurfaceQuality result;
  double smallest = std::numeric_limits<double>::infinity(), largest = 0.;
  const auto add_cell = [&](const WalkCell &cell)
  {
    double cell_area = 0.;
    for (unsigned int q = 0; q < surface.tables.n_points; ++q)
    {
      const WalkPoint x        = cell[q];
      const Vector3<double> a1 = x[1], a2 = x[2], area_vector = cross(a1, a2);
      const double J = norm(area_vector);
      cell_area += x.weight * J;
      result.volume += x.weight * dot(x[0], area_vector) / 3.;
      result.min_cell_quality = std::min(result.min_cell_quality, J / (norm(a1) * norm(a2)));
      if (surface.kind == SurfaceDiscretization::Kind::surface)
        result.largest_aspect = std::max({result.largest_aspect, norm(a1) / norm(a2), norm(a2) / norm(a1)});
    }
    result.area += cell_area;
    smallest = std::min(smallest, cell_area);
    largest  = std::max(largest, cell_area);
  };
  for_all_cells(surface.tables, surface.cell_nodes, positions, 3, add_cell);
  result.cell_area_ratio = largest / smallest;
  return result;
}

void check_start_positions(const SurfaceDiscretization &surface, const std::string &remedy)
{
  const bool meridian   = surface.kind == SurfaceDiscretization::Kind::meridian;
  const auto check_cell = [&](const WalkCell &cell)
  {
    double total = 0., smallest = std::numeric_limits<double>::infinity();
    for (unsigned int q = 0; q < surface.tables.n_points; ++q)
    {
      const WalkPoint x = cell[q];
      const double J    = norm(cross(x[1], x[2]));
      total += J;
      // On a meridian J = r |x_,1| loses its sign where r does.
      smallest = std::min(smallest, meridian && !(x[0][0] > 0.) ? -J : J);
    }
    if (!(smallest > 1e-8 * total / surface.tables.n_points && total < std::numeric_limits<double>::infinity()))
    {
      const Vector3<double> x = cell[0][0];
      throw UserError("The start shape is degenerate in the cell at (" + exact_text(x[0]) + ", " + exact_text(x[1]) +
                      ", " + exact_text(x[2]) + "): its area element is not positive there. " + remedy);
    }
  };
  for_all_cells(surface.tables, surface.cell_nodes, surface.positions, 3, check_cell);
  if (!surface.is_closed())
    return; // it encloses none
  const double volume = surface_quality(surface, surface.positions).volume;
  if (!(volume > 0. && volume < std::numeric_limits<double>::infinity()))
    throw UserError("The start shape encloses the volume " + exact_text(volume) +
                    ", which must be positive: it is inside out or folded. " + remedy);
}

std::vector<double> squared_node_distances(const SurfaceDiscretization &surface)
{
  const bool meridian = surface.kind == SurfaceDiscretization::Kind::meridian;
  const double k      = surface.degree;
  std::vector<double> all;
  for_all_cells(surface.tables, surface.cell_nodes, surface.positions, 3,
                [&](const WalkCell &cell)
                {
                  double size = 0., weights = 0.; // weights have the factor of a revolution or a mirror plane
                  for (unsigned int q = 0; q < cell.tables.n_points; ++q)
                  {
                    size += meridian ? cell[q].weight * norm(cell[q][1]) : cell[q].area();
                    weights += cell[q].weight;
                  }
                  size /= weights;
                  all.insert(all.end(), cell.tables.n_points, (meridian ? size * size : size) / (k * k));
                });
  return all;
}

int euler_characteristic(const SurfaceDiscretization &surface)
{
  if (surface.kind == SurfaceDiscretization::Kind::meridian)
    return 2 - static_cast<int>(std::count_if(surface.edges.begin(), surface.edges.end(),
                                              [](const EdgeLoop &edge) { return edge.is_rim; }));
  const std::size_t k = surface.degree, n = surface.n_local();
  std::set<std::size_t> vertices;
  std::set<std::pair<std::size_t, std::size_t>> edges;
  for (std::size_t cell = 0; cell < surface.n_cells; ++cell)
  {
    const std::size_t *const nodes = &surface.cell_nodes[cell * n];
    const std::array<std::size_t, 4> around{{nodes[0], nodes[k], nodes[n - 1], nodes[n - 1 - k]}};
    for (unsigned int i = 0; i < 4; ++i)
    {
      vertices.insert(around[i]);
      edges.insert(std::minmax(around[i], around[(i + 1) % 4]));
    }
  }
  // An edge with a vertex that hangs on it was counted whole and as two halves.
  const auto on_edges = std::count_if(surface.hanging.begin(), surface.hanging.end(),
                                      [&](const HangingNode &hangs) { return vertices.count(hangs.node) > 0; });
  return static_cast<int>(vertices.size()) - static_cast<int>(edges.size()) + static_cast<int>(surface.n_cells) +
         static_cast<int>(on_edges);
}
} // namespace pellicle

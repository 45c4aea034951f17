// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exact_text.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/surface_quality.h>

#include <algorithm>
#include <limits>
#include <set>

namespace pellicle
{
namespace
{
/** Value, ,1 and ,2 of a field at every point of one cell after the other. */
class PositionWalk
{
public:
  PositionWalk(const SurfaceDiscretization &discretization, const NodalVectors &positions)
      : surface(discretization)
      , values(positions)
      , inputs(std::size_t(discretization.tables.n_points) * 18)
  {
  }

  void enter(const std::size_t cell)
  {
    evaluate_field(surface.tables, &surface.cell_nodes[cell * surface.n_local()], values, 3, inputs.data());
  }

  Vector3<double> slot(const unsigned int q, const unsigned int s) const
  {
    const double *const v = &inputs[(std::size_t(q) * 6 + s) * 3];
    return {v[0], v[1], v[2]};
  }

private:
  const SurfaceDiscretization &surface;
  const NodalVectors &values;
  std::vector<double> inputs;
};
} // namespace

SurfaceQuality surface_quality(const SurfaceDiscretization &surface, const NodalVectors &positions)
{
  PositionWalk walk(surface, positions);
  SurfaceQuality result;
  double smallest = std::numeric_limits<double>::infinity(), largest = 0.;
  for (std::size_t cell = 0; cell < surface.n_cells; ++cell)
  {
    walk.enter(cell);
    double cell_area = 0.;
    for (unsigned int q = 0; q < surface.tables.n_points; ++q)
    {
      const Vector3<double> a1 = walk.slot(q, 1), a2 = walk.slot(q, 2), area_vector = cross(a1, a2);
      const double J = norm(area_vector), weight = surface.tables.weights[q];
      cell_area += weight * J;
      result.volume += weight * dot(walk.slot(q, 0), area_vector) / 3.;
      result.min_cell_quality = std::min(result.min_cell_quality, J / (norm(a1) * norm(a2)));
      if (surface.kind == SurfaceDiscretization::Kind::surface)
        result.largest_aspect = std::max({result.largest_aspect, norm(a1) / norm(a2), norm(a2) / norm(a1)});
    }
    result.area += cell_area;
    smallest = std::min(smallest, cell_area);
    largest  = std::max(largest, cell_area);
  }
  result.cell_area_ratio = largest / smallest;
  return result;
}

void check_start_positions(const SurfaceDiscretization &surface, const std::string &remedy)
{
  const bool meridian = surface.kind == SurfaceDiscretization::Kind::meridian;
  PositionWalk walk(surface, surface.positions);
  for (std::size_t cell = 0; cell < surface.n_cells; ++cell)
  {
    walk.enter(cell);
    double total = 0., smallest = std::numeric_limits<double>::infinity();
    for (unsigned int q = 0; q < surface.tables.n_points; ++q)
    {
      const double J = norm(cross(walk.slot(q, 1), walk.slot(q, 2)));
      total += J;
      // On a meridian J = r |x_,1| loses its sign where r does.
      smallest = std::min(smallest, meridian && !(walk.slot(q, 0)[0] > 0.) ? -J : J);
    }
    if (!(smallest > 1e-8 * total / surface.tables.n_points && total < std::numeric_limits<double>::infinity()))
    {
      const Vector3<double> x = walk.slot(0, 0);
      throw UserError("The start shape is degenerate in the cell at (" + exact_text(x[0]) + ", " + exact_text(x[1]) +
                      ", " + exact_text(x[2]) + "): its area element is not positive there. " + remedy);
    }
  }
  if (!surface.is_closed())
    return; // it encloses none
  const double volume = surface_quality(surface, surface.positions).volume;
  if (!(volume > 0. && volume < std::numeric_limits<double>::infinity()))
    throw UserError("The start shape encloses the volume " + exact_text(volume) +
                    ", which must be positive: it is inside out or folded. " + remedy);
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
  return static_cast<int>(vertices.size()) - static_cast<int>(edges.size()) + static_cast<int>(surface.n_cells);
}
} // namespace pellicle

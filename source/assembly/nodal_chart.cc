// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/edge_frames.h>
#include <pellicle/assembly/nodal_chart.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/admissible.h>
#include <pellicle/discretization/edge_loops.h>
#include <pellicle/discretization/point_walk.h>
#include <pellicle/discretization/refined_quads.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace pellicle
{
namespace
{
using Direction = Vector3<double>;

std::vector<Direction> admissible_directions(const SurfaceDiscretization &discretization, const std::size_t node)
{
  const AdmissibleDirections all = admissible_at(discretization, node);
  std::vector<Direction> directions;
  for (unsigned int j = 0; j < all.count; ++j)
    directions.emplace_back(all.columns[j][0], all.columns[j][1], all.columns[j][2]);
  return directions;
}

void append_column(NodalChart::Node &node, const Direction &d, const bool mesh_equation)
{
  for (unsigned int c = 0; c < 3; ++c)
    node.columns[3 * node.count + c] = d[c];
  node.mesh_equation[node.count++] = mesh_equation;
}

// Appends mesh equations along an orthonormal completion of the node's columns within the admissible directions
// (Gram-Schmidt, the most independent candidate first).
void complete(NodalChart::Node &node, const std::vector<Direction> &admissible)
{
  while (node.count < admissible.size())
  {
    Direction best;
    for (Direction candidate : admissible)
    {
      for (unsigned int j = 0; j < node.count; ++j)
      {
        const Direction column(node.columns[3 * j], node.columns[3 * j + 1], node.columns[3 * j + 2]);
        candidate -= dot(candidate, column) * column;
      }
      if (norm(candidate) > norm(best))
        best = candidate;
    }
    append_column(node, (1. / norm(best)) * best, true);
  }
}

} // namespace

bool NodalChart::has_mesh_equations() const
{
  return std::any_of(nodes.begin(), nodes.end(),
                     [](const Node &node)
                     { return node.mesh_equation[0] || node.mesh_equation[1] || node.mesh_equation[2]; });
}

void free_nodes(const SurfaceDiscretization &discretization, const std::vector<bool> &material, NodalChart &chart)
{
  for (std::size_t I = 0; I < discretization.n_nodes; ++I)
    if (material[I])
    {
      chart.nodes[I] = {};
      for (const Direction &d : admissible_directions(discretization, I))
        append_column(chart.nodes[I], d, false);
    }
}

NodalChart held_chart(const SurfaceDiscretization &discretization)
{
  NodalChart chart;
  chart.nodes.resize(discretization.n_nodes);
  return chart;
}

NodalChart free_chart(const SurfaceDiscretization &discretization)
{
  NodalChart chart;
  chart.nodes.resize(discretization.n_nodes);
  free_nodes(discretization, std::vector<bool>(discretization.n_nodes, true), chart);
  return chart;
}

NodalChart graph_chart(const SurfaceDiscretization &discretization, const NodalVectors &positions,
                       const NodalVectors &normals)
{
  NodalChart chart;
  chart.nodes.resize(discretization.n_nodes);
  for (std::size_t I = 0; I < discretization.n_nodes; ++I)
    if (norm(vector_at(normals, I)) > 0.)
      append_column(chart.nodes[I], vector_at(normals, I), false);
  for (const auto &[I, nu] : nodal_conormals(discretization, positions, normals))
    append_column(chart.nodes[I], nu, false);
  return chart;
}

NodalChart ale_chart(const SurfaceDiscretization &discretization, const NodalVectors &positions,
                     const NodalVectors &normals)
{
  NodalChart chart = graph_chart(discretization, positions, normals);
  for (std::size_t I = 0; I < discretization.n_nodes; ++I)
    complete(chart.nodes[I], admissible_directions(discretization, I));
  return chart;
}

NodalChart conormal_chart(const SurfaceDiscretization &discretization, const NodalVectors &positions,
                          const NodalVectors &conormals)
{
  NodalChart chart;
  chart.nodes.resize(discretization.n_nodes);
  chart.unit_vectors.resize(discretization.n_nodes);
  for (const auto &[I, t] : nodal_line_tangents(discretization, positions))
  {
    const Direction nu = vector_at(conormals, I);
    if (norm(nu) == 0.)
      continue;
    chart.unit_vectors[I]      = {{nu[0], nu[1], nu[2]}};
    const Direction about_line = (1. / norm(cross(t, nu))) * cross(t, nu);
    append_column(chart.nodes[I], about_line, false);
    if (discretization.kind == SurfaceDiscretization::Kind::surface)
      append_column(chart.nodes[I], cross(nu, about_line), false);
  }
  return chart;
}

NodalChart edge_scalar_chart(const SurfaceDiscretization &discretization)
{
  NodalChart chart;
  chart.nodes.resize(discretization.n_nodes);
  if (discretization.kind == SurfaceDiscretization::Kind::surface)
    for (const EdgeLoop &loop : discretization.edges)
      for (const std::size_t node : loop.cell_nodes)
        if (chart.nodes[node].count == 0)
          append_column(chart.nodes[node], {1., 0., 0.}, false);
  return chart;
}

namespace
{
/** Sums of x,1 x x,2 over the cells at each node, `counts`: which cells do. */
template <typename Counts>
NodalVectors sums_of_normals(const SurfaceDiscretization &discretization, const NodalVectors &positions,
                             const Counts &counts)
{
  const bool meridian            = discretization.kind == SurfaceDiscretization::Kind::meridian;
  const std::vector<double> line = line_nodes(discretization.degree);
  std::vector<std::array<double, 2>> sites;
  for (std::size_t i = 0; i < discretization.n_local(); ++i)
    sites.push_back({{0.5 * (1. + line[i % line.size()]), meridian ? 0. : 0.5 * (1. + line[i / line.size()])}});
  const ShapeTables tables = make_tables_at(discretization.kind, discretization.degree, sites);

  NodalVectors normals(3 * discretization.n_nodes, 0.);
  for_all_cells(tables, discretization.cell_nodes, positions, 3,
                [&](const WalkCell &cell)
                {
                  if (!counts(cell.number))
                    return;
                  for (unsigned int q = 0; q < tables.n_points; ++q)
                  {
                    // On a meridian x,2 = r e_y vanishes at the poles, its direction does not.
                    const Vector3<double> N = cross(cell[q][1], meridian ? Vector3<double>(0., 1., 0.) : cell[q][2]);
                    for (unsigned int c = 0; c < 3; ++c)
                      normals[3 * cell.nodes[q] + c] += N[c];
                  }
                });
  return normals;
}
} // namespace

NodalVectors nodal_normals(const SurfaceDiscretization &discretization, const NodalVectors &positions)
{
  NodalVectors normals = sums_of_normals(discretization, positions, [](const std::size_t) { return true; });
  std::vector<bool> on_surface(discretization.n_nodes, false);
  for (const std::size_t node : discretization.cell_nodes)
    on_surface[node] = true;
  for (std::size_t I = 0; I < discretization.n_nodes; ++I)
  {
    if (!on_surface[I])
      continue;
    const Vector3<double> d = admissible_part(admissible_at(discretization, I), vector_at(normals, I));
    const double length     = norm(d);
    if (!(length > 0.))
      throw SolveError("At node " + std::to_string(I) +
                       " of the surface the normals of its cells cancel: the mesh has collapsed there.");
    for (unsigned int c = 0; c < 3; ++c)
      normals[3 * I + c] = d[c] / length;
  }
  return normals;
}

NodalVectors nodal_normals_at_edges(const SurfaceDiscretization &discretization, const NodalVectors &positions)
{
  const std::vector<bool> on_edge = nodes_of_edges(discretization);
  std::vector<bool> is_left(discretization.n_cells, false);
  for (const EdgeLoop &loop : discretization.edges)
    for (const CellSide &side : loop.sides)
      is_left[side.cell] = true;
  NodalVectors normals = sums_of_normals(discretization, positions, [&](const std::size_t c) { return is_left[c]; });
  for (std::size_t I = 0; I < discretization.n_nodes; ++I)
  {
    const Vector3<double> d =
        on_edge[I] ? admissible_part(admissible_at(discretization, I), vector_at(normals, I)) : Vector3<double>();
    const double length = norm(d);
    for (unsigned int c = 0; c < 3; ++c)
      normals[3 * I + c] = length > 0. ? d[c] / length : 0.;
  }
  return normals;
}

std::vector<double> nodal_areas(const SurfaceDiscretization &discretization, const NodalVectors &positions)
{
  std::vector<double> areas(discretization.n_nodes, 0.);
  const ShapeTables &tables = discretization.tables;
  double total = 0., sum = 0.;
  for_all_points(tables, discretization.cell_nodes, positions, 3,
                 [&](const WalkPoint &x)
                 {
                   const double dA = x.area();
                   total += dA;
                   for (unsigned int I = 0; I < tables.n_nodes; ++I)
                   {
                     const double N = tables.tables[0][std::size_t(x.q) * tables.n_nodes + I];
                     areas[x.nodes[I]] += N * N * dA;
                     sum += N * N * dA;
                   }
                 });
  for (double &area : areas)
    area *= total / sum;
  return areas;
}
} // namespace pellicle

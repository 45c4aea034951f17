// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/edge_frames.h>
#include <pellicle/discretization/admissible.h>
#include <pellicle/discretization/refined_quads.h>

#include <array>
#include <vector>

namespace pellicle
{
namespace
{
Vector3<double> normalised(const Vector3<double> &v)
{
  return (1. / norm(v)) * v;
}

/** A line that ends on a plane of symmetry goes on as its mirror image: together their tangents are normal to the
 * plane, of whose directions nothing is left. */
Vector3<double> across_plane(const AdmissibleDirections &in_plane, const Vector3<double> &t)
{
  return in_plane.count == 3 ? t : t - admissible_part(in_plane, t);
}
} // namespace

std::map<std::size_t, Vector3<double>> nodal_line_tangents(const SurfaceDiscretization &discretization,
                                                           const NodalVectors &positions)
{
  std::map<std::size_t, Vector3<double>> tangents;
  if (discretization.kind == SurfaceDiscretization::Kind::meridian)
  {
    for (const EdgeLoop &loop : discretization.edges)
      tangents[loop.cell_nodes.front()] = {0., loop.tables.tables[1].front(), 0.};
    return tangents;
  }
  std::vector<std::array<double, 2>> sites;
  for (const double site : line_nodes(discretization.degree))
    sites.push_back({{0.5 * (1. + site), 0.}});
  const ShapeTables along = make_tables_at(SurfaceDiscretization::Kind::meridian, discretization.degree, sites);
  for (const EdgeLoop &loop : discretization.edges)
    for (std::size_t edge = 0; edge < loop.n_cells; ++edge)
    {
      const std::size_t *nodes = loop.cell_nodes.data() + edge * along.n_nodes;
      for (unsigned int i = 0; i < along.n_nodes; ++i)
        for (unsigned int j = 0; j < along.n_nodes; ++j)
          tangents[nodes[i]] += along.tables[1][std::size_t(i) * along.n_nodes + j] * vector_at(positions, nodes[j]);
    }
  for (const EdgeLoop &loop : discretization.edges)
    if (loop.cell_nodes.front() != loop.cell_nodes.back() && !discretization.admissible.empty())
      for (const std::size_t node : {loop.cell_nodes.front(), loop.cell_nodes.back()})
        tangents[node] = across_plane(discretization.admissible[node], tangents[node]);
  for (auto &[node, t] : tangents)
    t = normalised(t);
  return tangents;
}

std::map<std::size_t, Vector3<double>> nodal_conormals(const SurfaceDiscretization &discretization,
                                                       const NodalVectors &positions, const NodalVectors &normals)
{
  std::map<std::size_t, Vector3<double>> conormals = nodal_line_tangents(discretization, positions);
  for (auto &[node, t] : conormals)
    t = normalised(cross(t, vector_at(normals, node)));
  return conormals;
}

NodalVectors tangential_parts(const NodalVectors &vectors, const NodalVectors &normals)
{
  NodalVectors result(vectors.size());
  for (std::size_t I = 0; 3 * I < vectors.size(); ++I)
  {
    const Vector3<double> v = vector_at(vectors, I), n = vector_at(normals, I);
    set_vector_at(result, I, v - dot(v, n) * n);
  }
  return result;
}
} // namespace pellicle

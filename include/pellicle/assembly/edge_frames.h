// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>

#include <map>

namespace pellicle
{
/** Three coordinates of a node. */
inline Vector3<double> vector_at(const NodalVectors &vectors, const std::size_t node)
{
  return {vectors[3 * node], vectors[3 * node + 1], vectors[3 * node + 2]};
}

inline void set_vector_at(NodalVectors &vectors, const std::size_t node, const Vector3<double> &value)
{
  for (unsigned int c = 0; c < 3; ++c)
    vectors[3 * node + c] = value[c];
}

/** (I - n n) v at the nodes; normals: those of nodal_normals(). */
NodalVectors tangential_parts(const NodalVectors &vectors, const NodalVectors &normals);

/** Unit tangents t of the edge loops at their nodes, in the loops' direction: the mean over the edges that meet there.
 */
std::map<std::size_t, Vector3<double>> nodal_line_tangents(const SurfaceDiscretization &discretization,
                                                           const NodalVectors &positions);

/** Unit conormals nu = t x n of the edge loops at their nodes: out of the surface (of the region), tangential to it.
 * normals: those of nodal_normals(). */
std::map<std::size_t, Vector3<double>> nodal_conormals(const SurfaceDiscretization &discretization,
                                                       const NodalVectors &positions, const NodalVectors &normals);
} // namespace pellicle

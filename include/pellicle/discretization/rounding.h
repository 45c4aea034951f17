// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/polygon_mesh.h>
#include <pellicle/discretization/refined_quads.h>

namespace pellicle
{
/** Vertices with unit normals, joined by quadrilaterals oriented outwards: what curved patches are spanned between. */
struct RoundedSurface
{
  std::vector<Vector3<double>> vertices;
  std::vector<Vector3<double>> normals;
  std::vector<QuadVertices> quads; ///< lexicographic
};

/**
 * Unit normals at the vertices of an oriented closed mesh: sum over the corners of a x b/(|a|^2 |b|^2), a and b the two
 * edges that leave the corner, normalised. Exact where a vertex and its neighbours lie on a sphere (N. Max, Journal of
 * Graphics Tools 4(2), 1999). Throws UserError where the sum vanishes.
 */
std::vector<Vector3<double>> vertex_normals(const PolygonMesh &mesh);

/** Quadrilaterals as they are; or, if there are triangles, three for each triangle and four for each quadrilateral, by
 * way of rounded edge midpoints and centres. */
RoundedSurface round_polygons(const PolygonMesh &mesh);

/**
 * Cubic between two vertices: Hermite, with the tangent at each end along the chord's projection on the plane normal to
 * the vertex normal, and of length 2 |chord|/(1 + cos(angle between tangent and chord)): within 3e-4 R of a quarter of
 * a circle.
 */
Vector3<double> rounded_edge(const RoundedSurface &surface, unsigned int from, unsigned int to, double t);

/** Point (xi, eta) in [-1, 1]^2 of the bilinearly blended Coons patch between the four rounded edges, with a bulge in
 * the middle where the quadrilateral is no parallelogram. Off a smooth surface by the fourth power of the facets' size
 * if they are nearly parallelograms, by the third in general. */
Vector3<double> rounded_point(const RoundedSurface &surface, const QuadVertices &quad, double xi, double eta);
} // namespace pellicle

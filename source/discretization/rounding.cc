// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/rounding.h>

#include <cmath>
#include <map>
#include <utility>

namespace pellicle
{
namespace
{
/** Hermite tangent at a vertex of the curve that leaves it along `chord`. */
Vector3<double> end_tangent(const Vector3<double> &chord, const Vector3<double> &normal)
{
  const Vector3<double> along = chord - dot(chord, normal) * normal;
  const double cosine         = norm(along) / norm(chord);
  if (cosine < 1e-3) // the chord leaves along the normal: a spike, which no smooth curve follows
    return chord;
  // For a circular arc this is 4 R tan(arc/4), whose cubic meets the arc in both ends and in the middle.
  return 2. / (1. + cosine) * (1. / cosine * along);
}

Vector3<double> unit(const Vector3<double> &v)
{
  return v / norm(v);
}

/**
 * What the Coons patch misses in the middle of a quadrilateral that is no parallelogram. The patch reproduces
 * everything but x,uuvv; under a bilinear change of parameters with the mixed difference d = x_0 - x_1 - x_2 + x_3 that
 * is 2 II(d, d) n to leading order (of the square of the facet's size, where the remaining terms are of the third and
 * fourth), and II(d, d) = -d . Dn d. The normal's derivative is taken from the differences of the corners' normals.
 */
Vector3<double> missing_bulge(const RoundedSurface &surface, const QuadVertices &quad)
{
  const auto difference =
      [&](const std::vector<Vector3<double>> &f, const double s0, const double s1, const double s2, const double s3)
  { return s0 * f[quad[0]] + s1 * f[quad[1]] + s2 * f[quad[2]] + s3 * f[quad[3]]; };
  const Vector3<double> normal = unit(difference(surface.normals, 1., 1., 1., 1.));
  const Vector3<double> a      = difference(surface.vertices, -.5, .5, -.5, .5),
                        dn_a   = difference(surface.normals, -.5, .5, -.5, .5);
  const Vector3<double> b      = difference(surface.vertices, -.5, -.5, .5, .5),
                        dn_b   = difference(surface.normals, -.5, -.5, .5, .5);
  Vector3<double> d            = difference(surface.vertices, 1., -1., -1., 1.);
  d -= dot(d, normal) * normal;

  // d = alpha a + beta b in the tangent plane.
  const double determinant = dot(normal, cross(a, b));
  if (!(std::abs(determinant) > 1e-3 * norm(a) * norm(b)))
    return {};
  const double alpha = dot(normal, cross(d, b)) / determinant, beta = dot(normal, cross(a, d)) / determinant;
  const Vector3<double> dn_d = alpha * dn_a + beta * dn_b;
  return -2. * dot(d, dn_d) * normal; // x,uuvv
}

/** Makes and remembers the vertices in the middle of edges and facets. */
class Splitter
{
public:
  Splitter(const PolygonMesh &polygons, RoundedSurface &rounded)
      : mesh(polygons)
      , surface(rounded)
  {
  }

  void split(const Polygon &polygon)
  {
    const unsigned int centre = add_centre(polygon);
    const unsigned int n      = polygon.n_vertices;
    for (unsigned int i = 0; i < n; ++i)
    {
      const unsigned int next = middle(polygon.vertex(i), polygon.vertex(i + 1));
      const unsigned int last = middle(polygon.vertex(i + n - 1), polygon.vertex(i));
      surface.quads.push_back({{polygon.vertex(i), next, last, centre}});
    }
  }

private:
  unsigned int add(const Vector3<double> &point, const Vector3<double> &normal)
  {
    surface.vertices.push_back(point);
    surface.normals.push_back(normal);
    return static_cast<unsigned int>(surface.vertices.size() - 1);
  }

  unsigned int middle(unsigned int a, unsigned int b)
  {
    if (a > b)
      std::swap(a, b);
    const auto found = middles.find({a, b});
    if (found != middles.end())
      return found->second;
    return middles[{a, b}] = add(rounded_edge(surface, a, b, 0.5), edge_normal(a, b));
  }

  /** Normal at the middle of a rounded edge: across the curve, and as near as can be to the mean of the normals at its
   * ends. */
  Vector3<double> edge_normal(const unsigned int a, const unsigned int b) const
  {
    const Vector3<double> chord = surface.vertices[b] - surface.vertices[a];
    const Vector3<double> tangent =
        unit(1.5 * chord - 0.25 * (end_tangent(chord, surface.normals[a]) + end_tangent(chord, surface.normals[b])));
    const Vector3<double> mean   = surface.normals[a] + surface.normals[b];
    const Vector3<double> across = mean - dot(mean, tangent) * tangent;
    if (!(norm(across) > 1e-6))
      throw UserError(mesh.source + ": the edge between nodes " + std::to_string(mesh.vertex_names[a]) + " and " +
                      std::to_string(mesh.vertex_names[b]) +
                      " cannot be rounded: the surface turns back there. Refine or repair the mesh.");
    return unit(across);
  }

  unsigned int add_centre(const Polygon &polygon)
  {
    Vector3<double> normal;
    for (unsigned int i = 0; i < polygon.n_vertices; ++i)
      normal += surface.normals[polygon.vertex(i)];
    if (polygon.n_vertices == 4)
      return add(rounded_point(surface, {{polygon.vertex(0), polygon.vertex(1), polygon.vertex(3), polygon.vertex(2)}},
                               0., 0.),
                 unit(normal));

    // Cubic Bezier triangle with the edges' control points at a third of their end tangents; its inner point is lifted
    // so that quadratics are reproduced (A. Vlachos et al., "Curved PN triangles", 2001): centre = (27 terms of weight
    // 1, 3, 6)/27.
    Vector3<double> corners, edges;
    for (unsigned int i = 0; i < 3; ++i)
    {
      const unsigned int a = polygon.vertex(i), b = polygon.vertex(i + 1);
      const Vector3<double> chord = surface.vertices[b] - surface.vertices[a];
      corners += surface.vertices[a];
      edges += surface.vertices[a] + 1. / 3. * end_tangent(chord, surface.normals[a]);
      edges += surface.vertices[b] - 1. / 3. * end_tangent(chord, surface.normals[b]);
    }
    const Vector3<double> inner = 1.5 / 6. * edges - 0.5 / 3. * corners;
    return add(1. / 27. * (corners + 3. * edges + 6. * inner), unit(normal));
  }

  const PolygonMesh &mesh;
  RoundedSurface &surface;
  std::map<std::pair<unsigned int, unsigned int>, unsigned int> middles;
};
} // namespace

std::vector<Vector3<double>> vertex_normals(const PolygonMesh &mesh)
{
  std::vector<Vector3<double>> normals(mesh.vertices.size());
  std::vector<double> magnitudes(mesh.vertices.size(), 0.);
  for (const Polygon &polygon : mesh.polygons)
    for (unsigned int i = 0; i < polygon.n_vertices; ++i)
    {
      const unsigned int v    = polygon.vertex(i);
      const Vector3<double> a = mesh.vertices[polygon.vertex(i + 1)] - mesh.vertices[v];
      const Vector3<double> b = mesh.vertices[polygon.vertex(i + polygon.n_vertices - 1)] - mesh.vertices[v];
      if (!(norm(a) > 0. && norm(b) > 0.))
        throw UserError(mesh.source + ": element " + std::to_string(polygon.name) +
                        " has an edge of length zero at node " + std::to_string(mesh.vertex_names[v]) +
                        ". Remove the repeated node.");
      normals[v] += cross(a, b) / (dot(a, a) * dot(b, b));
      magnitudes[v] += 1. / (norm(a) * norm(b));
    }
  for (std::size_t v = 0; v < normals.size(); ++v)
  {
    if (!(norm(normals[v]) > 1e-6 * magnitudes[v]))
      throw UserError(mesh.source + ": the facets around node " + std::to_string(mesh.vertex_names[v]) +
                      " have no common outer side (a spike or a fold). Refine or repair the mesh there.");
    normals[v] = unit(normals[v]);
  }
  return normals;
}

Vector3<double> rounded_edge(const RoundedSurface &surface, const unsigned int from, const unsigned int to,
                             const double t)
{
  const Vector3<double> chord  = surface.vertices[to] - surface.vertices[from];
  const Vector3<double> first  = end_tangent(chord, surface.normals[from]);
  const Vector3<double> second = end_tangent(chord, surface.normals[to]);
  const double s               = 1. - t;
  // Hermite polynomials; t^2 (3 - 2 t) is the weight of the far end.
  return surface.vertices[from] + (t * t * (3. - 2. * t)) * chord + (t * s * s) * first - (t * t * s) * second;
}

Vector3<double> rounded_point(const RoundedSurface &surface, const QuadVertices &quad, const double xi,
                              const double eta)
{
  const double u = 0.5 * (1. + xi), v = 0.5 * (1. + eta);
  const auto x = [&](const unsigned int i) { return surface.vertices[quad[i]]; };
  const Vector3<double> across =
      (1. - v) * rounded_edge(surface, quad[0], quad[1], u) + v * rounded_edge(surface, quad[2], quad[3], u);
  const Vector3<double> along =
      (1. - u) * rounded_edge(surface, quad[0], quad[2], v) + u * rounded_edge(surface, quad[1], quad[3], v);
  const Vector3<double> corners =
      ((1. - u) * (1. - v)) * x(0) + (u * (1. - v)) * x(1) + ((1. - u) * v) * x(2) + (u * v) * x(3);
  return across + along - corners + (0.25 * u * (1. - u) * v * (1. - v)) * missing_bulge(surface, quad);
}

RoundedSurface round_polygons(const PolygonMesh &mesh)
{
  RoundedSurface surface;
  surface.vertices = mesh.vertices;
  surface.normals  = vertex_normals(mesh);

  bool triangles = false;
  for (const Polygon &polygon : mesh.polygons)
    triangles = triangles || polygon.n_vertices == 3;

  Splitter splitter(mesh, surface);
  for (const Polygon &polygon : mesh.polygons)
    if (triangles)
      splitter.split(polygon);
    else
      surface.quads.push_back({{polygon.vertices[0], polygon.vertices[1], polygon.vertices[3], polygon.vertices[2]}});
  return surface;
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/polygon_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace pellicle
{
inline void add_polygon(PolygonMesh &mesh, const std::vector<unsigned int> &vertices)
{
  Polygon polygon;
  polygon.n_vertices = static_cast<unsigned int>(vertices.size());
  std::copy(vertices.begin(), vertices.end(), polygon.vertices.begin());
  polygon.name = mesh.polygons.size() + 1;
  mesh.polygons.push_back(polygon);
}

/** Names vertices by their numbers. */
inline void name_vertices(PolygonMesh &mesh)
{
  mesh.source = "sample";
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    mesh.vertex_names.push_back(v);
}

/** Unit sphere of 6 n^2 quadrilaterals: a cube with n x n facets a side, projected. Outward. */
inline PolygonMesh quad_sphere(const unsigned int n)
{
  PolygonMesh mesh;
  const auto vertex = [&](const Vector3<double> &on_cube)
  {
    const Vector3<double> x = on_cube / norm(on_cube);
    for (unsigned int v = 0; v < mesh.vertices.size(); ++v)
      if (norm(mesh.vertices[v] - x) < 1e-9)
        return v;
    mesh.vertices.push_back(x);
    return static_cast<unsigned int>(mesh.vertices.size() - 1);
  };
  for (unsigned int axis = 0; axis < 3; ++axis)
    for (const int side : {-1, 1})
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < n; ++i)
        {
          std::vector<unsigned int> corners;
          for (const auto &step : {std::array<unsigned int, 2>{{0, 0}}, {{1, 0}}, {{1, 1}}, {{0, 1}}})
          {
            Vector3<double> x;
            x[axis]           = side;
            x[(axis + 1) % 3] = side * (-1. + 2. * (i + step[0]) / n);
            x[(axis + 2) % 3] = -1. + 2. * (j + step[1]) / n;
            corners.push_back(vertex(x));
          }
          add_polygon(mesh, corners);
        }
  name_vertices(mesh);
  return mesh;
}

/** Every quadrilateral cut into two triangles. */
inline PolygonMesh cut_into_triangles(const PolygonMesh &quads)
{
  PolygonMesh mesh = quads;
  mesh.polygons.clear();
  for (const Polygon &q : quads.polygons)
  {
    add_polygon(mesh, {q.vertices[0], q.vertices[1], q.vertices[2]});
    add_polygon(mesh, {q.vertices[0], q.vertices[2], q.vertices[3]});
  }
  return mesh;
}

/** Half of the polygons, at random, walked the other way round. */
inline PolygonMesh flipped_at_random(PolygonMesh mesh)
{
  std::mt19937 random(7);
  for (Polygon &polygon : mesh.polygons)
    if (random() % 2)
      std::reverse(polygon.vertices.begin(), polygon.vertices.begin() + polygon.n_vertices);
  return mesh;
}

/** The projective plane on six vertices: every one of the 15 edges belongs to two of the 10 triangles, but it has no
 * inside. */
inline PolygonMesh projective_plane()
{
  PolygonMesh mesh;
  for (int v = 0; v < 6; ++v)
    mesh.vertices.emplace_back(std::cos(v), std::sin(2. * v), .3 * v);
  for (const auto &t : std::vector<std::vector<unsigned int>>{{0, 1, 2},
                                                              {0, 2, 3},
                                                              {0, 3, 4},
                                                              {0, 4, 5},
                                                              {0, 5, 1},
                                                              {1, 2, 4},
                                                              {2, 3, 5},
                                                              {3, 4, 1},
                                                              {4, 5, 2},
                                                              {5, 1, 3}})
    add_polygon(mesh, t);
  name_vertices(mesh);
  return mesh;
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/constants.h>
#include <pellicle/discretization/builders.h>
#include <pellicle/discretization/refined_quads.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pellicle
{
namespace
{
std::vector<Vector3<double>> cube_vertices()
{
  std::vector<Vector3<double>> vertices;
  for (unsigned int v = 0; v < 8; ++v)
    vertices.emplace_back(v & 1 ? 1. : -1., v & 2 ? 1. : -1., v & 4 ? 1. : -1.);
  return vertices;
}

/** Faces -x, +x, -y, +y, -z, +z; first times second direction points outwards. */
std::vector<QuadVertices> cube_faces()
{
  return {{{0, 4, 2, 6}}, {{1, 3, 5, 7}}, {{0, 1, 4, 5}}, {{2, 6, 3, 7}}, {{0, 2, 1, 3}}, {{4, 5, 6, 7}}};
}

using Direction = Vector3<double>;

/** c/|c|, the same to the last bit however the coordinates are permuted. */
Direction normalised(const Direction &c)
{
  std::array<double, 3> squares{{c[0] * c[0], c[1] * c[1], c[2] * c[2]}};
  std::sort(squares.begin(), squares.end());
  return c / std::sqrt(squares[0] + squares[1] + squares[2]);
}

/**
 * Directions of the (2^r + 1)^2 vertices of a face of the cube, first coordinate fastest: every refinement puts new
 * ones at the middle of great circles between neighbours, and at the mean of four.
 */
std::vector<Direction> vertex_grid(const std::array<Direction, 4> &corners, const unsigned int refinements)
{
  std::vector<Direction> grid(corners.begin(), corners.end());
  std::size_t n = 2; // vertices in a row
  for (unsigned int r = 0; r < refinements; ++r)
  {
    const std::size_t m = 2 * n - 1;
    std::vector<Direction> finer(m * m);
    const auto old = [&](const std::size_t i, const std::size_t j) { return grid[j * n + i]; };
    for (std::size_t j = 0; j < m; ++j)
      for (std::size_t i = 0; i < m; ++i)
      {
        const std::size_t a = i / 2, b = j / 2, c = a + i % 2, d = b + j % 2;
        finer[j * m + i] = i % 2 + j % 2 == 0 ? old(a, b)
                           : j % 2 == 0       ? normalised(old(a, b) + old(c, b))
                           : i % 2 == 0       ? normalised(old(a, b) + old(a, d))
                                              : normalised((old(a, b) + old(c, d)) + (old(c, b) + old(a, d)));
      }
    grid = std::move(finer);
    n    = m;
  }
  return grid;
}

/** Weighted mean of four unit vectors on the sphere: Buss and Fillmore, ACM Trans. Graphics 20, 95-126 (2001). */
Direction spherical_mean(const std::array<Direction, 4> &points, const std::array<double, 4> &weights)
{
  Direction mean;
  for (unsigned int i = 0; i < 4; ++i)
    mean += weights[i] * points[i];
  for (unsigned int iteration = 0; iteration < 20; ++iteration)
  {
    mean = normalised(mean);
    Direction step;
    for (unsigned int i = 0; i < 4; ++i)
    {
      const double cosine     = dot(mean, points[i]);
      const Direction tangent = points[i] - cosine * mean;
      const double sine       = norm(tangent);
      if (sine > 0.)
        step += (weights[i] * std::atan2(sine, cosine) / sine) * tangent;
    }
    mean += step;
    if (norm(step) < 1e-16)
      break;
  }
  return normalised(mean);
}
} // namespace

SurfaceDiscretization on_cube_sphere(const SmoothShape &shape, const unsigned int degree,
                                     const unsigned int refinements)
{
  const std::vector<Direction> vertices = cube_vertices();
  const RefinedQuads mesh               = refine_quads(vertices, cube_faces(), refinements, degree);
  const std::size_t n_cells             = std::size_t(1) << refinements; // in a row of a face
  std::vector<std::vector<Direction>> grids;
  for (const QuadVertices &face : mesh.patches)
    grids.push_back(vertex_grid({{normalised(vertices[face[0]]), normalised(vertices[face[1]]),
                                  normalised(vertices[face[2]]), normalised(vertices[face[3]])}},
                                refinements));

  const auto direction = [&](const PatchPoint &site)
  {
    const auto split = [&](const double xi) { // cell in its row, and coordinate in the cell
      const double x         = 0.5 * (1. + xi) * static_cast<double>(n_cells);
      const std::size_t cell = std::min(static_cast<std::size_t>(x), n_cells - 1);
      return std::make_pair(cell, x - static_cast<double>(cell));
    };
    const auto [i, u] = split(site.xi);
    const auto [j, v] = split(site.eta);
    const auto vertex = [&](const std::size_t a, const std::size_t b)
    { return grids[site.patch][b * (n_cells + 1) + a]; };
    return spherical_mean({{vertex(i, j), vertex(i + 1, j), vertex(i, j + 1), vertex(i + 1, j + 1)}},
                          {{(1. - u) * (1. - v), u * (1. - v), (1. - u) * v, u * v}});
  };
  SurfaceDiscretization result =
      place_nodes(mesh, degree, [&](const PatchPoint &site) { return shape.point(direction(site)); });
  result.mesh_reference = result.positions;
  if (shape.even_mesh == SmoothShape::EvenMesh::sphere)
  {
    const double radius = std::sqrt(shape.area / (4. * pi));
    result.mesh_reference =
        place_nodes(mesh, degree, [&](const PatchPoint &site) { return radius * direction(site); }).positions;
  }
  return result;
}
} // namespace pellicle

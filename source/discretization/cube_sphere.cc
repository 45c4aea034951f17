// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/constants.h>
#include <pellicle/discretization/builders.h>
#include <pellicle/discretization/refined_quads.h>

#include <algorithm>
#include <cmath>

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

using Corners = std::array<Direction, 4>; ///< of a cell, lexicographic

/** Corners of one of the four cells that a cell is cut into: at the middle of great circles between its own corners,
 * and at the mean of all four. */
Corners part_of(const Corners &whole, const bool right, const bool upper)
{
  const Direction left_middle = normalised(whole[0] + whole[2]), right_middle = normalised(whole[1] + whole[3]),
                  lower_middle = normalised(whole[0] + whole[1]), upper_middle = normalised(whole[2] + whole[3]),
                  centre = normalised((whole[0] + whole[3]) + (whole[1] + whole[2]));
  const std::array<Direction, 9> grid{
      {whole[0], lower_middle, whole[1], left_middle, centre, right_middle, whole[2], upper_middle, whole[3]}};
  const unsigned int first = (right ? 1 : 0) + (upper ? 3 : 0);
  return {{grid[first], grid[first + 1], grid[first + 3], grid[first + 4]}};
}

/** Of the cell at a place of a face of the cube with the given corners. */
Corners corners_at(const CellPlace &place, Corners corners)
{
  double u = place.u0, v = place.v0; // within the part so far, whose size is 1
  for (double size = 1.; size > place.size; size *= 0.5)
  {
    const bool right = u >= 0.5, upper = v >= 0.5;
    corners = part_of(corners, right, upper);
    u       = 2. * u - (right ? 1. : 0.);
    v       = 2. * v - (upper ? 1. : 0.);
  }
  return corners;
}

/** Weighted mean of four unit vectors on the sphere: Buss and Fillmore, ACM Trans. Graphics 20, 95-126 (2001). */
Direction spherical_mean(const Corners &points, const std::array<double, 4> &weights)
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

SurfaceDiscretization on_cube_sphere(const SmoothShape &shape, const unsigned int degree, const Refinement &refinement)
{
  const std::vector<Direction> vertices = cube_vertices();
  const RefinedQuads mesh               = refine_quads(vertices, cube_faces(), refinement, degree);
  std::vector<Corners> faces;
  for (const QuadVertices &face : mesh.patches)
    faces.push_back({{normalised(vertices[face[0]]), normalised(vertices[face[1]]), normalised(vertices[face[2]]),
                      normalised(vertices[face[3]])}});

  const auto direction = [&](const PatchPoint &site)
  {
    const CellPlace &cell = site.cell;
    const double u = (0.5 * (1. + site.xi) - cell.u0) / cell.size, v = (0.5 * (1. + site.eta) - cell.v0) / cell.size;
    return spherical_mean(corners_at(cell, faces[site.patch]),
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

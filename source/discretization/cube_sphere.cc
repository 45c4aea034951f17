// SPDX-License-Identifier: LGPL-2.1-or-later
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

double equiangular(const double xi)
{
  const double quarter_pi = 0.7853981633974483;
  return std::abs(xi) == 1. ? xi : std::tan(quarter_pi * xi);
}

/** c/|c|, the same to the last bit however the coordinates are permuted. */
Vector3<double> normalised(const Vector3<double> &c)
{
  std::array<double, 3> squares{{c[0] * c[0], c[1] * c[1], c[2] * c[2]}};
  std::sort(squares.begin(), squares.end());
  return c / std::sqrt(squares[0] + squares[1] + squares[2]);
}
} // namespace

SurfaceDiscretization on_cube_sphere(const SmoothShape &shape, const unsigned int degree,
                                     const unsigned int refinements)
{
  const std::vector<Vector3<double>> vertices = cube_vertices();
  const RefinedQuads mesh                     = refine_quads(vertices, cube_faces(), refinements, degree);
  const auto direction                        = [&](const PatchPoint &site)
  {
    const QuadVertices &face     = mesh.patches[site.patch];
    const Vector3<double> centre = 0.5 * (vertices[face[0]] + vertices[face[3]]);
    const Vector3<double> first  = 0.5 * (vertices[face[1]] - vertices[face[0]]),
                          second = 0.5 * (vertices[face[2]] - vertices[face[0]]);
    return normalised(centre + equiangular(site.xi) * first + equiangular(site.eta) * second);
  };
  SurfaceDiscretization result =
      place_nodes(mesh, degree, [&](const PatchPoint &site) { return shape.point(direction(site)); });
  const double radius = std::sqrt(shape.area / (4. * 3.141592653589793));
  result.mesh_reference =
      place_nodes(mesh, degree, [&](const PatchPoint &site) { return radius * direction(site); }).positions;
  return result;
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/constants.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/edge_loops.h>
#include <pellicle/discretization/refined_quads.h>
#include <pellicle/discretization/shell_shapes.h>

#include <cmath>
#include <functional>

namespace pellicle
{
namespace
{
using Vector   = Vector3<double>;
using PatchMap = std::function<Vector(unsigned int patch, double u, double v)>;

/** The eighth of the unit sphere in three quadrilaterals that meet in its middle. */
Vector on_eighth(const unsigned int patch, const double u, const double v)
{
  const auto axis = [](const unsigned int i)
  {
    Vector e;
    e[i % 3] = 1.;
    return e;
  };
  const Vector corner = axis(patch), next = axis(patch) + axis(patch + 1), before = axis(patch) + axis(patch + 2);
  const auto unit = [](const Vector &x) { return x / norm(x); };
  return unit((1. - u) * (1. - v) * corner + u * (1. - v) * unit(next) + (1. - u) * v * unit(before) +
              u * v * unit(Vector(1., 1., 1.)));
}

PatchMap map_of(const ShellShape &shape)
{
  const double R = shape.radius, a = shape.angle;
  if (shape.name == "plate")
    return [=](unsigned int, const double u, const double v) { return Vector(u * shape.length, v * shape.width, 0.); };
  if (shape.name == "cylinder")
    return [=](unsigned int, const double u, const double v)
    { return Vector(R * std::cos(0.5 * pi * u), R * std::sin(0.5 * pi * u), 0.5 * shape.length * v); };
  if (shape.name == "roof")
    return [=](unsigned int, const double u, const double v)
    { return Vector(R * std::sin(a * u), 0.5 * shape.length * v, R * std::cos(a * u)); };
  if (shape.name == "hemisphere")
    return [=](unsigned int, const double u, const double v)
    {
      const double latitude = (0.5 * pi - a) * v, longitude = 0.5 * pi * u;
      return R * Vector(std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
                        std::sin(latitude));
    };
  PELLICLE_ASSERT(shape.name == "sphere", "a shell of unknown shape");
  return [=](const unsigned int patch, const double u, const double v) { return R * on_eighth(patch, u, v); };
}

double mirror_images(const std::string &shape)
{
  return shape == "plate" ? 1. : shape == "roof" || shape == "hemisphere" ? 4. : 8.;
}

ShapeTables point_tables(const double weight)
{
  ShapeTables tables;
  tables.n_points     = 1;
  tables.n_nodes      = 1;
  tables.weights      = {weight};
  tables.identity_map = true;
  for (unsigned int s = 0; s < 6; ++s)
  {
    tables.map[s]    = {{1., 0., 0., 0., 1., 0., 0., 0., 1.}};
    tables.tables[s] = {s == 0 ? 1. : 0.};
  }
  return tables;
}
} // namespace

const std::vector<std::string> &shell_shape_names()
{
  static const std::vector<std::string> names{"plate", "cylinder", "roof", "hemisphere", "sphere"};
  return names;
}

Vector shell_normal(const ShellShape &shape, const Vector &place)
{
  if (shape.name == "plate")
    return {0., 0., 1.};
  Vector radial = place;
  if (shape.name == "cylinder")
    radial[2] = 0.;
  if (shape.name == "roof")
    radial[1] = 0.;
  return radial / norm(radial);
}

SurfaceDiscretization shell_mesh(const ShellShape &shape)
{
  const bool is_sphere = shape.name == "sphere";
  // Corners of the sphere's eighth: three on the axes, the middles between x and y, y and z, z and x, the centre.
  const std::vector<QuadVertices> quads =
      is_sphere ? std::vector<QuadVertices>{{{0, 3, 5, 6}}, {{1, 4, 3, 6}}, {{2, 5, 4, 6}}}
                : std::vector<QuadVertices>{{{0, 1, 2, 3}}};
  const PatchMap map                = map_of(shape);
  const std::vector<Vector> corners = corner_points(quads, is_sphere ? 7 : 4, map);
  const RefinedQuads mesh =
      refine_quads(corners, quads, {shape.refinement.uniform + 1, shape.refinement.cut}, shape.degree);
  SurfaceDiscretization result = place_nodes(mesh, quads, shape.degree, map);
  result.edges                 = find_rims(result, [](const Vector &) { return std::string("boundary"); });
  for (ShapeTables *const tables : {&result.tables, &result.edges.front().tables})
    for (double &weight : tables->weights)
      weight *= mirror_images(shape.name);
  result.rigid_motions.clear();
  return result;
}

EdgeLoop point_loop(const std::string &name, const std::size_t node, const double weight)
{
  EdgeLoop loop;
  loop.name       = name;
  loop.is_rim     = false;
  loop.n_cells    = 1;
  loop.cell_nodes = {node};
  loop.tables     = point_tables(weight);
  return loop;
}

std::size_t nearest_node(const SurfaceDiscretization &surface, const Vector &place)
{
  std::size_t nearest = 0;
  double least        = -1.;
  for (std::size_t I = 0; I < surface.n_nodes; ++I)
  {
    const Vector x(surface.positions[3 * I], surface.positions[3 * I + 1], surface.positions[3 * I + 2]);
    if (const double distance = norm(x - place); least < 0. || distance < least)
    {
      least   = distance;
      nearest = I;
    }
  }
  return nearest;
}
} // namespace pellicle

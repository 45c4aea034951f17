// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/edge_frames.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/bodies.h>
#include <pellicle/models/shell_supports.h>
#include <pellicle/potentials/shell/cosserat_shell.h>

#include <cmath>

namespace pellicle
{
namespace
{
using Vector = Vector3<double>;

/** Directions taken from nodes, collected in the admissible directions of a surface without anything else. */
class Supports
{
public:
  explicit Supports(const SurfaceDiscretization &surface, const double length)
      : surface(surface)
      , tolerance(1e-9 * length)
      , touched(surface.n_nodes, false)
  {
    position.n_nodes = director.n_nodes = surface.n_nodes;
    position.admissible.resize(surface.n_nodes);
    director.admissible.resize(surface.n_nodes);
  }

  /** The nodes on the plane x_c = value. */
  std::vector<std::size_t> on_plane(const unsigned int c, const double value) const
  {
    std::vector<std::size_t> nodes;
    for (std::size_t I = 0; I < surface.n_nodes; ++I)
      if (std::abs(surface.positions[3 * I + c] - value) < tolerance)
        nodes.push_back(I);
    return nodes;
  }

  /** Takes directions from displacement and director of a node. */
  void at_node(const std::size_t node, const std::vector<Vector> &of_position, const std::vector<Vector> &of_director)
  {
    touched[node] = true;
    for (const Vector &direction : of_position)
      keep_on_plane(position, node, direction);
    for (const Vector &direction : of_director)
      keep_on_plane(director, node, direction);
  }

  void symmetric_about(const unsigned int c)
  {
    Vector normal;
    normal[c] = 1.;
    for (const std::size_t node : on_plane(c, 0.))
      at_node(node, {normal}, {normal});
  }

  NodalConditions conditions() const
  {
    NodalConditions result;
    FieldConditions &of_position = result["position"], &of_director = result[shell_director];
    of_position.only.resize(surface.n_nodes);
    of_director.only.resize(surface.n_nodes);
    for (std::size_t I = 0; I < surface.n_nodes; ++I)
      if (touched[I])
      {
        of_position.only[I] = position.admissible[I];
        of_director.only[I] = director.admissible[I];
      }
    return result;
  }

private:
  const SurfaceDiscretization &surface;
  double tolerance;
  std::vector<bool> touched;
  SurfaceDiscretization position, director;
};
} // namespace

NodalConditions shell_supports(const ShellShape &shape, const SurfaceDiscretization &surface)
{
  const Vector x(1., 0., 0.), y(0., 1., 0.), z(0., 0., 1.);
  Supports supports(surface, shape.name == "plate" ? shape.length : shape.radius);
  if (shape.name == "plate")
  {
    for (const double edge : {0., shape.length})
      for (const std::size_t node : supports.on_plane(0, edge))
        supports.at_node(node, {y, z}, {y});
    for (const double edge : {0., shape.width})
      for (const std::size_t node : supports.on_plane(1, edge))
        supports.at_node(node, {x, z}, {x});
    return supports.conditions();
  }
  supports.symmetric_about(0);
  supports.symmetric_about(1);
  if (shape.name == "roof")
    for (const std::size_t node : supports.on_plane(1, 0.5 * shape.length))
      supports.at_node(node, {x, z}, {cross(y, shell_normal(shape, vector_at(surface.positions, node)))});
  else if (shape.name == "hemisphere")
    supports.at_node(nearest_node(surface, {shape.radius, 0., 0.}), {z}, {});
  else
    supports.symmetric_about(2);
  return supports.conditions();
}

std::vector<LoadPoint> shell_load_points(const ShellShape &shape)
{
  const double R      = shape.radius;
  const std::string a = "load point a", b = "load point b";
  if (shape.name == "plate")
    return {{a, {0., 0., -1.}, {0.5 * shape.length, 0.5 * shape.width, 0.}}};
  if (shape.name == "cylinder")
    return {{a, {1., 0., 0.}, {R, 0., 0.}}};
  if (shape.name == "roof")
    return {{a, {0., 0., -1.}, {R * std::sin(shape.angle), 0., R * std::cos(shape.angle)}}};
  if (shape.name == "hemisphere")
    return {{a, {1., 0., 0.}, {R, 0., 0.}}, {b, {0., -1., 0.}, {0., R, 0.}}};
  PELLICLE_ASSERT(shape.name == "sphere", "a shell of unknown shape");
  return {{a, {1., 0., 0.}, {R, 0., 0.}}};
}

double shell_load_copies(const ShellShape &shape)
{
  return shape.name == "plate" ? 1. : 2.;
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
// Scenes whose start mesh is moved, turned or numbered anew, or whose numbers are in other units.
#pragma once

#include <pellicle/models/surface_scene.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace pellicle::test
{
/** A scene of the application's kind whose start mesh is changed before anything is done with it. */
template <typename Scene>
class Moved : public Scene
{
public:
  using Change = std::function<void(SurfaceDiscretization &)>;

  Moved(Scene scene, Change change)
      : Scene(std::move(scene))
      , change(std::move(change))
  {
  }
  SurfaceDiscretization start_mesh() const override
  {
    SurfaceDiscretization mesh = Scene::start_mesh();
    change(mesh);
    return mesh;
  }

private:
  Change change;
};

/** Every parameter of the scene in a unit of length and a unit of energy that are so many times smaller. */
inline void change_units(SurfaceScene &scene, const double length, const double energy)
{
  for (const ParameterSection &section : scene.sections())
    scale_entries(section, {1. / length, 1. / energy});
}

inline void translate(SurfaceDiscretization &mesh, const std::array<double, 3> &by)
{
  for (NodalVectors *values : {&mesh.positions, &mesh.mesh_reference})
    for (std::size_t i = 0; i < values->size(); ++i)
      (*values)[i] += by[i % 3];
}

/** About an axis through the origin, by an angle: Rodrigues' formula. */
inline void rotate(SurfaceDiscretization &mesh, const std::array<double, 3> &axis, const double angle)
{
  const double c = std::cos(angle), s = std::sin(angle);
  const auto turn = [&](NodalVectors &values)
  {
    for (std::size_t i = 0; i < values.size(); i += 3)
    {
      const Vector3<double> a{axis[0], axis[1], axis[2]}, v{values[i], values[i + 1], values[i + 2]};
      const Vector3<double> turned = c * v + s * cross(a, v) + (1. - c) * dot(a, v) * a;
      for (unsigned int k = 0; k < 3; ++k)
        values[i + k] = turned[k];
    }
  };
  turn(mesh.positions);
  turn(mesh.mesh_reference);
  for (auto &[name, values] : mesh.start_values)
    turn(values);
}

/** A random order of n things: new_number[old number]. */
inline std::vector<std::size_t> shuffled(const std::size_t n, const unsigned int seed)
{
  std::vector<std::size_t> numbers(n);
  std::iota(numbers.begin(), numbers.end(), 0);
  std::mt19937 random(seed);
  for (std::size_t i = n; i > 1; --i) // std::shuffle differs between libraries
    std::swap(numbers[i - 1], numbers[random() % i]);
  return numbers;
}

/** The entries of a list, `n` for each thing, in the order of the things' new numbers. */
template <typename T>
void reorder(std::vector<T> &list, const std::vector<std::size_t> &new_number, const std::size_t n)
{
  if (list.empty())
    return;
  std::vector<T> result(list.size());
  for (std::size_t i = 0; i < new_number.size(); ++i)
    std::copy_n(list.begin() + static_cast<std::ptrdiff_t>(n * i), n,
                result.begin() + static_cast<std::ptrdiff_t>(n * new_number[i]));
  list = std::move(result);
}

/** Nodes, and cells of surface and bodies, in a random order. */
inline void renumber(SurfaceDiscretization &mesh, const unsigned int seed = 1)
{
  const std::vector<std::size_t> node = shuffled(mesh.n_nodes, seed), cell = shuffled(mesh.n_cells, seed + 1);
  const auto rename = [&](std::vector<std::size_t> &nodes)
  {
    for (std::size_t &i : nodes)
      i = node[i];
  };
  for (NodalVectors *values : {&mesh.positions, &mesh.mesh_reference})
    reorder(*values, node, 3);
  for (auto &[name, values] : mesh.start_values)
    reorder(values, node, 3);
  reorder(mesh.admissible, node, 1);
  rename(mesh.cell_nodes);
  reorder(mesh.cell_nodes, cell, mesh.n_local());
  reorder(mesh.cell_places, cell, 1);
  reorder(mesh.cell_region, cell, 1);
  for (EdgeLoop &loop : mesh.edges)
  {
    rename(loop.cell_nodes);
    for (CellSide &side : loop.sides)
      side.cell = cell[side.cell];
  }
  for (BulkPart &body : mesh.bulks)
  {
    rename(body.cell_nodes);
    reorder(body.cell_nodes, shuffled(body.n_cells, seed + 2), body.tables.n_nodes);
    for (auto &[name, nodes] : body.faces)
      rename(nodes);
  }
}
} // namespace pellicle::test

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/edge_frames.h>
#include <pellicle/assembly/nodal_chart.h>
#include <pellicle/base/constants.h>
#include <pellicle/models/director_defects.h>
#include <pellicle/models/surface_model.h>
#include <pellicle/potentials/director/director_fields.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace pellicle
{
namespace
{
/** |t| from which directors count as lying in the surface. */
constexpr double in_surface = 0.5;

/** Four neighbouring nodes of a cell, counterclockwise seen from outside. */
using Patch = std::array<std::size_t, 4>;

/** Signed area of the triangle of three unit vectors on the unit sphere (van Oosterom & Strackee 1983). */
double solid_angle(const Vector3<double> &a, const Vector3<double> &b, const Vector3<double> &c)
{
  return 2. * std::atan2(dot(a, cross(b, c)), 1. + dot(a, b) + dot(b, c) + dot(c, a));
}

/** The tangential parts of directors at the nodes, and how they turn from node to node. */
class TangentField
{
public:
  TangentField(const SurfaceDiscretization &surface, const NodalVectors &positions, const NodalVectors &directors)
      : normals(nodal_normals(surface, positions))
      , tangents(tangential_parts(directors, normals))
  {
  }

  double length(const std::size_t I) const { return norm(vector_at(tangents, I)); }
  bool is_long(const std::size_t I) const { return length(I) >= in_surface; }

  /**
   * Turns of t along the edge of a patch. Along each side t is compared with t carried parallel along the great circle
   * between the normals; carried round the whole patch, a vector turns by the area of the normals' polygon. A whole
   * number for one patch if t is not zero at its nodes; in a sum over patches, sides between two of them drop out.
   */
  double turns(const Patch &p) const
  {
    double angle = 0.;
    for (unsigned int i = 0; i < 4; ++i)
      angle += angle_between(p[i], p[(i + 1) % 4]);
    const auto n = [&](const unsigned int i) { return vector_at(normals, p[i]); };
    return (angle + solid_angle(n(0), n(1), n(2)) + solid_angle(n(0), n(2), n(3))) / (2. * pi);
  }

private:
  /** Exactly antisymmetric, also where the angle is pi. */
  double angle_between(const std::size_t I, const std::size_t J) const
  {
    return I < J ? angle_upwards(I, J) : -angle_upwards(J, I);
  }

  double angle_upwards(const std::size_t I, const std::size_t J) const
  {
    const Vector3<double> a = vector_at(normals, I), b = vector_at(normals, J), t = vector_at(tangents, I);
    const Vector3<double> carried = t - (dot(b, t) / (1. + dot(a, b))) * (a + b), there = vector_at(tangents, J);
    return std::atan2(dot(b, cross(carried, there)), dot(carried, there));
  }

  NodalVectors normals, tangents;
};

/** Sets of nodes that grow together. */
class NodeSets
{
public:
  explicit NodeSets(const std::size_t n)
      : parent(n)
  {
    std::iota(parent.begin(), parent.end(), 0);
  }

  std::size_t find(std::size_t I)
  {
    while (parent[I] != I)
      I = parent[I] = parent[parent[I]];
    return I;
  }
  void join(const std::size_t I, const std::size_t J) { parent[find(I)] = find(J); }

private:
  std::vector<std::size_t> parent;
};

std::vector<Patch> patches_of(const SurfaceDiscretization &surface)
{
  const std::size_t k = surface.degree, row = k + 1;
  std::vector<Patch> patches;
  for (std::size_t cell = 0; cell < surface.n_cells; ++cell)
    for (std::size_t j = 0; j < k; ++j)
      for (std::size_t i = 0; i < k; ++i)
      {
        const std::size_t *const first = &surface.cell_nodes[cell * surface.n_local() + j * row + i];
        patches.push_back({{first[0], first[1], first[row + 1], first[row]}});
      }
  return patches;
}

struct Core
{
  double turns  = 0.;
  bool at_rim   = false;
  double weight = 0.;
  Vector3<double> centre; ///< times weight
};

std::vector<Defect> defects_in_space(const SurfaceDiscretization &surface, const NodalVectors &positions,
                                     const TangentField &field)
{
  const auto is_whole_turn = [&](const Patch &p)
  {
    return std::all_of(p.begin(), p.end(), [&](const auto I) { return field.is_long(I); }) &&
           std::abs(field.turns(p)) > 0.5;
  };
  const auto touches_core = [&](const Patch &p)
  { return std::any_of(p.begin(), p.end(), [&](const auto I) { return !field.is_long(I); }); };

  // Patches of a core share nodes, its outermost ones with the surroundings.
  const std::vector<Patch> all = patches_of(surface);
  std::vector<Patch> of_cores;
  NodeSets sets(surface.n_nodes);
  for (const Patch &p : all)
    if (touches_core(p) || is_whole_turn(p))
    {
      of_cores.push_back(p);
      for (const std::size_t I : p)
        sets.join(p[0], I);
    }
  if (of_cores.size() == all.size())
    return {};

  std::map<std::size_t, Core> cores;
  for (const Patch &p : of_cores)
    cores[sets.find(p[0])].turns += field.turns(p);
  const std::vector<double> areas = nodal_areas(surface, positions);
  for (std::size_t I = 0; I < surface.n_nodes; ++I)
    if (const auto core = cores.find(sets.find(I)); core != cores.end())
    {
      constexpr double least = 1e-6; // there may be no node where t is shorter than 1
      const double weight    = areas[I] * (1. + least - std::pow(std::min(field.length(I), 1.), 2));
      core->second.weight += weight;
      core->second.centre += weight * vector_at(positions, I);
    }
  for (const EdgeLoop &loop : surface.edges)
    if (loop.is_rim)
      for (const std::size_t I : loop.cell_nodes)
        if (const auto core = cores.find(sets.find(I)); core != cores.end() && !field.is_long(I))
          core->second.at_rim = true;

  std::vector<Defect> defects;
  for (const auto &[set, core] : cores)
    if (const int charge = static_cast<int>(std::lround(core.turns)); charge != 0 && !core.at_rim)
      defects.push_back({(1. / core.weight) * core.centre, charge});
  return defects;
}

/** t turns once round the axis; somewhere on the way from there it is long. */
std::vector<Defect> defects_on_axis(const SurfaceDiscretization &meridian, const NodalVectors &positions)
{
  std::vector<Defect> defects;
  for (std::size_t I = 0; I < meridian.n_nodes; ++I)
  {
    const Vector3<double> x = vector_at(positions, I);
    if (x[0] != 0.)
      continue;
    defects.push_back({x, 1});
    if (meridian.mirror)
      defects.push_back({{x[0], x[1], -x[2]}, 1});
  }
  return defects;
}
} // namespace

std::optional<std::vector<Defect>> director_defects(const SurfaceDiscretization &surface, const NodalVectors &positions,
                                                    const NodalVectors &directors)
{
  const TangentField field(surface, positions, directors);
  std::size_t n_long = 0;
  for (std::size_t I = 0; I < surface.n_nodes; ++I)
    n_long += field.is_long(I);
  if (n_long == 0)
    return std::nullopt;
  return surface.kind == SurfaceDiscretization::Kind::meridian ? defects_on_axis(surface, positions)
                                                               : defects_in_space(surface, positions, field);
}

std::optional<std::vector<Defect>> director_defects(const SurfaceModel &model)
{
  const FieldLayout &layout = model.equilibrium().layout();
  if (!layout.has(director))
    return std::nullopt;
  NodalVectors directors = model.equilibrium().state().fields[layout.index(director)];
  directors.resize(3 * model.mesh().n_nodes); // beyond them are those of lines along which the mesh is split
  return director_defects(model.mesh(), model.positions(), directors);
}
} // namespace pellicle

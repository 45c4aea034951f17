// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/bodies.h>
#include <pellicle/discretization/symmetric_part.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace pellicle
{
namespace
{
constexpr double on_plane     = 1e-9; // distance over the largest coordinate
constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();

Vector3<double> axis(const unsigned int c)
{
  Vector3<double> e;
  e[c] = 1.;
  return e;
}

std::string name_of_plane(const unsigned int c)
{
  return std::string(1, "xyz"[c]) + " = 0";
}

/** Which cells and nodes of a surface belong to its part, and their numbers there. */
class Restriction
{
public:
  Restriction(const SurfaceDiscretization &whole, const MirrorPlanes &planes)
      : whole(whole)
      , planes(planes)
      , nodes(whole.n_nodes, nowhere)
      , cells(whole.n_cells, nowhere)
  {
    double largest = 0.;
    for (const double x : whole.positions)
      largest = std::max(largest, std::abs(x));
    tolerance             = on_plane * largest;
    std::size_t n_in_part = 0;
    for (std::size_t cell = 0; cell < whole.n_cells; ++cell)
      if (is_inside(cell))
      {
        cells[cell] = n_in_part++;
        for (std::size_t i = 0; i < whole.n_local(); ++i)
          nodes[whole.cell_nodes[cell * whole.n_local() + i]] = 0;
      }
    if (n_in_part * planes.n_images() != whole.n_cells)
      throw UserError("The mesh of the start shape is not symmetric: " + std::to_string(n_in_part) + " of its " +
                      std::to_string(whole.n_cells) +
                      " cells lie between the planes of Mesh/Symmetry. Take another start shape, or Symmetry = none.");
    for (std::size_t &number : nodes)
      if (number != nowhere)
        number = n_nodes++;
  }

  bool has_cell(const std::size_t cell) const { return cells[cell] != nowhere; }
  std::size_t cell(const std::size_t of_whole) const { return cells[of_whole]; }
  std::size_t node(const std::size_t of_whole) const { return nodes[of_whole]; }
  std::size_t n_nodes_of_part() const { return n_nodes; }
  bool lies_on(const std::size_t node_of_whole, const unsigned int c) const
  {
    return planes.normal_to[c] && std::abs(whole.positions[3 * node_of_whole + c]) <= tolerance;
  }

  /** Entries of the part's cells, so many a cell. */
  template <typename T>
  std::vector<T> of_cells(const std::vector<T> &all, const std::size_t n) const
  {
    std::vector<T> kept;
    for (std::size_t c = 0; c * n < all.size(); ++c)
      if (has_cell(c))
        kept.insert(kept.end(), all.begin() + static_cast<std::ptrdiff_t>(c * n),
                    all.begin() + static_cast<std::ptrdiff_t>((c + 1) * n));
    return kept;
  }

  /** Vectors at the part's nodes; on a plane they have no component normal to it. */
  NodalVectors vectors(const NodalVectors &all) const
  {
    NodalVectors kept(all.empty() ? 0 : 3 * n_nodes);
    for (std::size_t I = 0; 3 * I < all.size(); ++I)
      for (unsigned int c = 0; c < 3 && nodes[I] != nowhere; ++c)
        kept[3 * nodes[I] + c] = lies_on(I, c) ? 0. : all[3 * I + c];
    return kept;
  }

private:
  bool is_inside(const std::size_t cell) const
  {
    bool inside = true;
    for (unsigned int c = 0; c < 3; ++c)
    {
      if (!planes.normal_to[c])
        continue;
      double least = 0., most = 0.;
      for (std::size_t i = 0; i < whole.n_local(); ++i)
      {
        const double x = whole.positions[3 * whole.cell_nodes[cell * whole.n_local() + i] + c];
        least          = std::min(least, x);
        most           = std::max(most, x);
      }
      if (least < -tolerance && most > tolerance)
        throw UserError("The plane " + name_of_plane(c) +
                        " cuts through cells of the start mesh, which has no part on one side of it. Set "
                        "Mesh/Refinements to 1 or more, or Mesh/Symmetry to none.");
      inside = inside && least >= -tolerance;
    }
    return inside;
  }

  const SurfaceDiscretization &whole;
  const MirrorPlanes &planes;
  std::vector<std::size_t> nodes, cells; ///< numbers in the part
  std::size_t n_nodes = 0;
  double tolerance    = 0.;
};

/** The part of a line, from the plane where it begins if a plane cuts it. */
EdgeLoop restricted(const EdgeLoop &loop, const Restriction &part, const double n_images)
{
  std::vector<std::size_t> kept;
  for (std::size_t c = 0; c < loop.n_cells; ++c)
    if (part.has_cell(loop.sides[c].cell))
      kept.push_back(c);
  // A closed line begins anywhere: the part may be its end and its beginning.
  const auto gap =
      std::adjacent_find(kept.begin(), kept.end(), [](const std::size_t a, const std::size_t b) { return b != a + 1; });
  if (gap != kept.end())
    std::rotate(kept.begin(), gap + 1, kept.end());

  EdgeLoop result = loop;
  result.n_cells  = kept.size();
  result.cell_nodes.clear();
  result.sides.clear();
  for (const std::size_t c : kept)
  {
    for (std::size_t i = 0; i < loop.tables.n_nodes; ++i)
      result.cell_nodes.push_back(part.node(loop.cell_nodes[c * loop.tables.n_nodes + i]));
    result.sides.push_back({part.cell(loop.sides[c].cell), loop.sides[c].side});
  }
  for (double &weight : result.tables.weights)
    weight *= n_images;
  return result;
}
} // namespace

unsigned int MirrorPlanes::n_images() const
{
  return 1u << std::count(normal_to.begin(), normal_to.end(), true);
}

// Of t + r x x on the plane x_c = 0 the component c is t_c + r_a x_b - r_b x_a.
bool keeps_in_place(const RigidMotion &motion, const MirrorPlanes &planes)
{
  for (unsigned int c = 0; c < 3; ++c)
    if (planes.normal_to[c] &&
        (motion.translation[c] != 0. || motion.rotation[(c + 1) % 3] != 0. || motion.rotation[(c + 2) % 3] != 0.))
      return false;
  return true;
}

SurfaceDiscretization symmetric_part(const SurfaceDiscretization &whole, const MirrorPlanes &planes)
{
  if (!planes.any())
    return whole;
  PELLICLE_ASSERT(whole.kind == SurfaceDiscretization::Kind::surface && whole.bulks.empty() && whole.twins.empty(),
                  "parts are made of surfaces in space, before anything else is done to them");
  const Restriction restriction(whole, planes);
  const double n_images = planes.n_images();

  SurfaceDiscretization part = whole;
  part.n_nodes               = restriction.n_nodes_of_part();
  part.cell_nodes            = restriction.of_cells(whole.cell_nodes, whole.n_local());
  part.n_cells               = part.cell_nodes.size() / whole.n_local();
  for (std::size_t &node : part.cell_nodes)
    node = restriction.node(node);
  part.cell_places    = restriction.of_cells(whole.cell_places, 1);
  part.cell_region    = restriction.of_cells(whole.cell_region, 1);
  part.positions      = restriction.vectors(whole.positions);
  part.mesh_reference = restriction.vectors(whole.mesh_reference);
  for (auto &[name, values] : part.start_values)
    values = restriction.vectors(whole.start_values.at(name));
  part.hanging.clear();
  for (HangingNode hanging : whole.hanging)
    if (hanging.node = restriction.node(hanging.node); hanging.node != nowhere)
    {
      for (auto &[node, share] : hanging.shares)
        node = restriction.node(node);
      part.hanging.push_back(hanging);
    }
  for (EdgeLoop &loop : part.edges)
    loop = restricted(loop, restriction, n_images);
  for (double &weight : part.tables.weights)
    weight *= n_images;

  if (!whole.admissible.empty())
    part.admissible.resize(part.n_nodes);
  for (std::size_t I = 0; I < whole.n_nodes; ++I)
  {
    const std::size_t node = restriction.node(I);
    if (node == nowhere)
      continue;
    if (!whole.admissible.empty())
      part.admissible[node] = whole.admissible[I];
    for (unsigned int c = 0; c < 3; ++c)
      if (restriction.lies_on(I, c))
        keep_on_plane(part, node, axis(c));
  }
  part.rigid_motions.erase(std::remove_if(part.rigid_motions.begin(), part.rigid_motions.end(),
                                          [&](const RigidMotion &motion) { return !keeps_in_place(motion, planes); }),
                           part.rigid_motions.end());
  return part;
}
} // namespace pellicle

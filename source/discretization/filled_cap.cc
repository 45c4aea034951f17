// SPDX-License-Identifier: LGPL-2.1-or-later
#include "body_degree.h"

#include <pellicle/base/constants.h>
#include <pellicle/base/exact_text.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/balanced_disc.h>
#include <pellicle/discretization/bodies.h>
#include <pellicle/discretization/builders.h>
#include <pellicle/discretization/edge_loops.h>
#include <pellicle/discretization/filled_cap.h>
#include <pellicle/discretization/refined_quads.h>

#include <cmath>
#include <map>
#include <utility>

namespace pellicle
{
namespace
{
// The block inside, relative to the drop: its half-width on a meridian to the contact radius, the same of the disc's
// block on a surface, and its height to the apex'.
constexpr double axial_width = 0.45, disc_width = 0.8, block_height = 0.5;

/** A cap, the surface of the block that its nodes are joined to, and which of its cells are above the block. */
struct CapOverBlock
{
  SurfaceDiscretization cap;
  NodalVectors on_block;
  std::vector<bool> above_block;
};

CapOverBlock meridian_over_block(const double angle, const double area, const unsigned int degree,
                                 const unsigned int refinements)
{
  CapOverBlock result;
  result.cap             = cap(angle, area, degree, refinements, true);
  const NodalVectors &x  = result.cap.positions;
  const std::size_t half = result.cap.n_cells / 2;
  const double width = axial_width * x[x.size() - 3], height = block_height * x[2];
  const std::vector<double> nodes = line_nodes(degree);
  for (std::size_t I = 0; I < result.cap.n_nodes; ++I)
  {
    // Up to 1 outwards along the top of the block, then down its side.
    const double way = (static_cast<double>(I / degree) + 0.5 * (1. + nodes[I % degree])) / static_cast<double>(half);
    result.on_block.insert(result.on_block.end(), {width * std::min(1., way), 0., height * std::min(1., 2. - way)});
  }
  for (std::size_t c = 0; c < result.cap.n_cells; ++c)
    result.above_block.push_back(c < half);
  return result;
}

CapOverBlock surface_over_block(const double angle, const double area, const unsigned int degree,
                                const unsigned int refinements)
{
  const BalancedDisc disc(angle);
  const double radius = std::sqrt(area / (4. * pi)) / std::sin(0.5 * angle),
               width = disc_width * radius * std::sin(angle), height = block_height * radius * (1. - std::cos(angle));
  const std::vector<QuadVertices> quads = BalancedDisc::quads();
  const auto on_cap                     = [&](const unsigned int patch, const double u, const double v)
  {
    const DiscPoint p  = disc.at(patch, u, v);
    const double polar = angle * p.radius, r = radius * std::sin(polar);
    const double z = 2. * radius * std::sin(0.5 * (angle + polar)) * std::sin(0.5 * (angle - polar));
    return Vector3<double>(r * p.cosine, r * p.sine, z);
  };
  // The four quadrilaterals in the middle are the block's top, the others run down its sides to the rim.
  const auto on_block = [&](const unsigned int patch, const double u, const double v)
  {
    const bool top    = patch < 4;
    const DiscPoint p = disc.at(patch, top ? u : 0., v);
    return Vector3<double>(width * p.radius * p.cosine, width * p.radius * p.sine, height * (top ? 1. : 1. - u));
  };
  const RefinedQuads mesh =
      refine_quads(corner_points(quads, BalancedDisc::n_vertices, on_cap), quads, refinements, degree);
  CapOverBlock result;
  result.cap       = place_nodes(mesh, quads, degree, on_cap);
  result.cap.edges = find_rims(result.cap, [](const Vector3<double> &) { return "rim"; });
  result.on_block  = place_nodes(mesh, quads, degree, on_block).positions;
  for (const auto &[patch, u0, v0, size] : mesh.cell_places)
    result.above_block.push_back(patch < 4);
  return result;
}

Vector3<double> place_of(const NodalVectors &positions, const std::size_t node)
{
  return {positions[3 * node], positions[3 * node + 1], positions[3 * node + 2]};
}

/** Numbers nodes by their places, new ones as they come. */
class NodesByPlace
{
public:
  NodesByPlace(NodalVectors &positions, const double length)
      : positions(positions)
      , grid(same_place * length)
  {
  }

  std::size_t at(const Vector3<double> &x)
  {
    const std::array<long long, 3> key{
        {std::llround(x[0] / grid), std::llround(x[1] / grid), std::llround(x[2] / grid)}};
    const auto [found, is_new] = numbers.emplace(key, numbers.size());
    if (is_new && 3 * numbers.size() > positions.size())
      positions.insert(positions.end(), x.components.begin(), x.components.end());
    return found->second;
  }

private:
  static constexpr double same_place = 1e-7; ///< relative; far above round-off, far below the size of a cell
  NodalVectors &positions;
  const double grid;
  std::map<std::array<long long, 3>, std::size_t> numbers;
};

/** Appends `n_layers` cells one above the other between two surfaces, over cell `cell` of the cap: outwards first. */
void append_column(const SurfaceDiscretization &cap, const std::size_t cell, const std::size_t n_layers,
                   const NodalVectors &from, const NodalVectors &to, NodesByPlace &nodes, BulkPart &body)
{
  const std::vector<double> unit = line_nodes(cap.degree);
  for (std::size_t layer = 0; layer < n_layers; ++layer, ++body.n_cells)
    for (std::size_t s = 0; s < cap.n_local(); ++s)
    {
      const std::size_t I = cap.cell_nodes[cell * cap.n_local() + s];
      for (const double node : unit)
      {
        const double f = (static_cast<double>(layer) + 0.5 * (1. + node)) / static_cast<double>(n_layers);
        body.cell_nodes.push_back(nodes.at((1. - f) * place_of(from, I) + f * place_of(to, I)));
      }
    }
}
} // namespace

SurfaceDiscretization filled_cap(const double angle, const double area, const unsigned int degree,
                                 const unsigned int refinements, const bool axial)
{
  if (!(angle > 0. && angle < pi))
    throw UserError("Contact angle = " + exact_text(angle) +
                    ": the polar angle of the rim of a cap with liquid below it must lie strictly between 0 and pi "
                    "(radians).");
  check_body_degree(degree, axial ? 5 : 3);
  CapOverBlock outline         = axial ? meridian_over_block(angle, area, degree, refinements)
                                       : surface_over_block(angle, area, degree, refinements);
  SurfaceDiscretization result = std::move(outline.cap);
  const NodalVectors on_cap    = result.positions;
  NodalVectors on_base         = outline.on_block;
  for (std::size_t I = 0; I < result.n_nodes; ++I)
    on_base[3 * I + 2] = 0.;

  NodesByPlace nodes(result.positions, std::sqrt(area));
  for (std::size_t I = 0; I < result.n_nodes; ++I)
    nodes.at(place_of(on_cap, I)); // the cap's nodes keep their numbers
  BulkPart body;
  body.name   = "liquid";
  body.tables = axial ? make_revolved_quad_tables(degree, 2 * degree) : make_hexahedron_tables(degree, 2 * degree);
  const std::size_t n_layers = std::size_t(1) << refinements;
  for (std::size_t c = 0; c < result.n_cells; ++c)
  {
    append_column(result, c, n_layers, outline.on_block, on_cap, nodes, body);
    if (outline.above_block[c])
      append_column(result, c, n_layers, on_base, outline.on_block, nodes, body);
  }

  const std::size_t n_on_cap = result.n_nodes;
  result.n_nodes             = result.positions.size() / 3;
  result.admissible.resize(result.n_nodes);
  for (std::size_t I = 0; I < result.n_nodes; ++I)
  {
    const double *const x = result.positions.data() + 3 * I;
    if (I < n_on_cap)
      body.faces["cap"].push_back(I);
    if (x[2] == 0.)
      body.faces["base"].push_back(I);
    if (axial && x[0] == 0.)
      body.faces["axis"].push_back(I);
  }
  if (axial)
  {
    for (std::size_t I = n_on_cap; I < result.n_nodes; ++I)
      result.admissible[I] = {2, {{{{1., 0., 0.}}, {{0., 0., 1.}}, {{0., 0., 0.}}}}};
    keep_on_plane(result, body.faces["axis"], {1., 0., 0.});
  }
  keep_on_plane(result, body.faces["base"], {0., 0., 1.});
  result.rigid_motions.clear();
  if (!axial)
    result.rigid_motions = {{{}, {{0., 0., 1.}}}, {{{1., 0., 0.}}, {}}, {{{0., 1., 0.}}, {}}};
  result.mesh_reference = result.positions;
  result.bulks.push_back(std::move(body));
  return result;
}
} // namespace pellicle

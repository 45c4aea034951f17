// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/polygon_mesh.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <utility>

namespace pellicle
{
namespace
{
/** A side of a polygon, from vertex `place` to the next. */
struct Side
{
  std::size_t polygon = 0;
  unsigned int place  = 0;
};

using Edge    = std::pair<unsigned int, unsigned int>; // smaller vertex first
using EdgeMap = std::map<Edge, std::vector<Side>>;

Edge edge_of(const Polygon &polygon, const unsigned int place)
{
  return std::minmax(polygon.vertex(place), polygon.vertex(place + 1));
}

std::string name(const PolygonMesh &mesh, const Edge &edge)
{
  return "edge (" + std::to_string(mesh.vertex_names[edge.first]) + ", " +
         std::to_string(mesh.vertex_names[edge.second]) + ")";
}

EdgeMap collect_edges(const PolygonMesh &mesh)
{
  EdgeMap edges;
  for (std::size_t p = 0; p < mesh.polygons.size(); ++p)
    for (unsigned int i = 0; i < mesh.polygons[p].n_vertices; ++i)
      edges[edge_of(mesh.polygons[p], i)].push_back({p, i});
  return edges;
}

void check_edges(const PolygonMesh &mesh, const EdgeMap &edges)
{
  for (const auto &[edge, sides] : edges)
  {
    if (sides.size() == 1)
      throw UserError(mesh.source + ": " + name(mesh, edge) + " belongs to one cell only (element " +
                      std::to_string(mesh.polygons[sides[0].polygon].name) +
                      "): a closed surface is needed. Close the hole, or merge nodes that lie on top of each other.");
    if (sides.size() > 2)
      throw UserError(mesh.source + ": " + name(mesh, edge) + " belongs to " + std::to_string(sides.size()) +
                      " cells: the mesh is non-manifold there. A closed surface has exactly two cells at every edge.");
  }
}

/** Round a vertex one can walk from cell to cell through edges and meet all of its cells, or else it pinches the
 * surface. */
void check_vertices(const PolygonMesh &mesh, const EdgeMap &edges)
{
  std::vector<unsigned int> n_cells(mesh.vertices.size(), 0);
  std::vector<Side> first(mesh.vertices.size());
  for (std::size_t p = 0; p < mesh.polygons.size(); ++p)
    for (unsigned int i = 0; i < mesh.polygons[p].n_vertices; ++i)
    {
      ++n_cells[mesh.polygons[p].vertex(i)];
      first[mesh.polygons[p].vertex(i)] = {p, i};
    }

  for (unsigned int v = 0; v < mesh.vertices.size(); ++v)
  {
    if (n_cells[v] == 0)
      continue;
    Side at          = first[v]; // a side that begins or ends at v
    unsigned int met = 0;
    do
    {
      ++met;
      const auto &sides = edges.at(edge_of(mesh.polygons[at.polygon], at.place));
      at                = sides[0].polygon == at.polygon ? sides[1] : sides[0];
      // The other side of that polygon which touches v.
      const Polygon &polygon = mesh.polygons[at.polygon];
      const unsigned int n   = polygon.n_vertices;
      at.place               = polygon.vertex(at.place) == v ? (at.place + n - 1) % n : (at.place + 1) % n;
    } while (at.polygon != first[v].polygon && met <= n_cells[v]);
    if (met != n_cells[v])
      throw UserError(mesh.source + ": the surface touches itself at node " + std::to_string(mesh.vertex_names[v]) +
                      ": the mesh is non-manifold there. Give each part a node of its own.");
  }
}

/** Breadth first: a neighbour must walk the shared edge the other way round. */
void turn_alike(PolygonMesh &mesh, const EdgeMap &edges)
{
  std::vector<char> known(mesh.polygons.size(), 0), flipped(mesh.polygons.size(), 0);
  std::deque<std::size_t> front = {0};
  known[0]                      = 1;
  std::size_t n_known           = 1;
  while (!front.empty())
  {
    const std::size_t p = front.front();
    front.pop_front();
    for (unsigned int i = 0; i < mesh.polygons[p].n_vertices; ++i)
    {
      const Edge edge   = edge_of(mesh.polygons[p], i);
      const auto &sides = edges.at(edge);
      const Side here   = sides[0].polygon == p ? sides[0] : sides[1],
                 there  = sides[0].polygon == p ? sides[1] : sides[0];
      // Compared in the order of the file; `flipped` says who has to be turned.
      const bool same_way = mesh.polygons[p].vertex(here.place) == mesh.polygons[there.polygon].vertex(there.place);
      const char wanted   = static_cast<char>(flipped[p] ^ (same_way ? 1 : 0));
      if (!known[there.polygon])
      {
        known[there.polygon]   = 1;
        flipped[there.polygon] = wanted;
        ++n_known;
        front.push_back(there.polygon);
      }
      else if (flipped[there.polygon] != wanted)
        throw UserError(mesh.source +
                        ": the surface is not orientable (like a Klein bottle, it has no inside; noticed at " +
                        name(mesh, edge) + "). A vesicle needs a surface that separates inside from outside.");
    }
  }
  if (n_known != mesh.polygons.size())
    throw UserError(mesh.source + ": the mesh has more than one piece (element " +
                    std::to_string(mesh.polygons[0].name) + "'s piece has " + std::to_string(n_known) + " of " +
                    std::to_string(mesh.polygons.size()) + " cells). Keep one closed surface.");
  for (std::size_t p = 0; p < mesh.polygons.size(); ++p)
    if (flipped[p])
      std::reverse(mesh.polygons[p].vertices.begin(), mesh.polygons[p].vertices.begin() + mesh.polygons[p].n_vertices);
}

/** Six times the volume, and a bound of the sum's terms, by fans of triangles seen from the first vertex. */
std::pair<double, double> six_volumes(const PolygonMesh &mesh)
{
  double sum = 0., magnitude = 0.;
  for (const Polygon &polygon : mesh.polygons)
    for (unsigned int i = 1; i + 1 < polygon.n_vertices; ++i)
    {
      const Vector3<double> a = mesh.vertices[polygon.vertex(0)] - mesh.vertices[0],
                            b = mesh.vertices[polygon.vertex(i)] - mesh.vertices[0],
                            c = mesh.vertices[polygon.vertex(i + 1)] - mesh.vertices[0];
      const double term       = dot(a, cross(b, c));
      sum += term;
      magnitude += norm(a) * norm(b) * norm(c);
    }
  return {sum, magnitude};
}
} // namespace

void orient_closed_surface(PolygonMesh &mesh)
{
  const EdgeMap edges = collect_edges(mesh);
  check_edges(mesh, edges);
  turn_alike(mesh, edges);
  check_vertices(mesh, collect_edges(mesh)); // polygons may have been turned, and their sides renumbered

  const auto [volume, magnitude] = six_volumes(mesh);
  if (!(std::abs(volume) > 1e-12 * magnitude))
    throw UserError(mesh.source + ": the surface encloses no volume (it is flat or folded onto itself).");
  if (volume < 0.)
    for (Polygon &polygon : mesh.polygons)
      std::reverse(polygon.vertices.begin(), polygon.vertices.begin() + polygon.n_vertices);
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/kinematics/vector3.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace pellicle
{
/** Triangle or quadrilateral: its vertices in the order in which its boundary is walked. */
struct Polygon
{
  unsigned int n_vertices = 3;
  std::array<unsigned int, 4> vertices{};
  std::size_t name = 0; ///< its number in the file, for messages

  /** Vertex after i places, cyclic. */
  unsigned int vertex(const unsigned int i) const { return vertices[i % n_vertices]; }
};

/** Flat facets as a file has them. */
struct PolygonMesh
{
  std::string source; ///< file name, for messages
  std::vector<Vector3<double>> vertices;
  std::vector<std::size_t> vertex_names; ///< numbers in the file, for messages
  std::vector<Polygon> polygons;
};

/**
 * Reads the triangles (type 2) and quadrilaterals (type 3) of a Gmsh MSH 4.1 ASCII file. Elements of other dimensions
 * are passed over, and so are nodes that no facet uses.
 *
 * Throws UserError with file and line: no such file, not MSH, another version, binary, cut short, malformed numbers,
 * unknown or repeated nodes, curved or other surface elements, no surface elements.
 */
PolygonMesh read_msh(const std::string &file);

/**
 * Turns the polygons so that all of them run counter-clockwise seen from outside.
 *
 * Throws UserError unless the mesh is one closed, connected, orientable surface without pinched edges or vertices, and
 * encloses a volume. (deal.II 9.4 checks none of this reliably for surfaces, and in release mode nothing at all.)
 */
void orient_closed_surface(PolygonMesh &mesh);
} // namespace pellicle

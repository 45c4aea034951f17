// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/cell_place.h>
#include <pellicle/kinematics/vector3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace pellicle
{
/** Three coordinates a node, node after node: x_I = (values[3 I], values[3 I + 1], values[3 I + 2]). */
using NodalVectors = std::vector<double>;

/**
 * Shape functions of one cell at its quadrature points, and the constant map from nodal values in R^3 to point inputs.
 *
 * The input in slot s (0 value, 1 ",1", 2 ",2", 3 ",11", 4 ",12", 5 ",22") at point q is
 *
 *     input_s(q) = map[s] * sum_I table(s, q, I) * (nodal value of I)
 *
 * On a surface every map is the identity and the tables are N_I, N_I,1, ... on the unit cell (x_,a = sum_I x_I N_I,a,
 * never a mapping). On a meridian (x = (r, 0, z), revolved about the z axis, second parameter phi) x_,2 = r e_phi:
 * table N_I, map e_y e_x^T. In a body slot 3 is ",3", and slots 4 and 5 are zero; of a body of revolution x_,3 = r
 * e_phi.
 */
struct ShapeTables
{
  unsigned int n_points = 0;
  unsigned int n_nodes  = 0; ///< nodes of one cell
  std::vector<double>
      weights; ///< quadrature weights; on a meridian with the factor 2 pi, twice that with a mirror plane

  /** Row-major 3 x 3 matrix for each slot. */
  std::array<std::array<double, 9>, 6> map{};
  /** tables[s][q * n_nodes + I]. */
  std::array<std::vector<double>, 6> tables;
  /** True if every map is the identity, so that it need not be applied. */
  bool identity_map = true;
};

/** Directions in which a node's vectors (position and moment alike) may change: `count` orthonormal columns. */
struct AdmissibleDirections
{
  unsigned int count = 3;
  std::array<std::array<double, 3>, 3> columns{{{{1., 0., 0.}}, {{0., 1., 0.}}, {{0., 0., 1.}}}};
};

/** A node on the edge of a cell whose neighbour there is twice as large: its values, of whichever field, are those of
 * the neighbour's polynomial, sum of share * (value of node). None of these nodes hangs itself. */
struct HangingNode
{
  std::size_t node = 0;
  std::vector<std::pair<std::size_t, double>> shares;
};

/** A rigid motion that leaves the energy unchanged: w_I = translation + rotation x (x_I - centre). */
struct RigidMotion
{
  std::array<double, 3> translation{};
  std::array<double, 3> rotation{};
};

/** A side of a cell, numbered as the cell's boundary is walked with the cell on the left: 0 along the first coordinate
 * (second 0), 1 along the second (first 1), 2 back, 3 down. Of a meridian's cell: 0 its beginning, 1 its end. */
struct CellSide
{
  std::size_t cell  = 0;
  unsigned int side = 0;
};

/**
 * A closed line made of edges of cells: a rim at which an open surface ends, or the line around a region (not closed
 * where a mirror plane cuts it). It runs so that the surface (the region) lies on its left seen from outside: nu = t x
 * n, the conormal, points out of it.
 */
struct EdgeLoop
{
  std::string name;            ///< "rim", "ring", "tip", "domain boundary"
  bool is_rim         = true;  ///< the surface ends here; else it goes on
  bool is_junction    = false; ///< three sheets of the surface meet here, regions of it; the loop is on the first one
  std::size_t n_cells = 0;     ///< one-dimensional ones; a meridian has one, a point
  /** Nodes of edge c along the line: cell_nodes[c * tables.n_nodes + i], nodes of the surface. */
  std::vector<std::size_t> cell_nodes;
  std::vector<CellSide> sides; ///< of the surface's cell on the left of edge c
  /** Slots 0 (value) and 1 (derivative along the line); the others are zero. */
  ShapeTables tables;
};

/**
 * A body in R^3: hexahedra of degree k or, where the surface is described by its meridian, quadrilaterals in the half
 * plane r >= 0, y = 0, revolved about z (,3 is the derivative along phi). Cells are oriented so that x,1 . (x,2 x x,3)
 * > 0. It shares nodes with the surfaces that bound it.
 */
struct BulkPart
{
  std::string name; ///< "substrate", "liquid"
  std::size_t n_cells = 0;
  /** Nodes of cell c: cell_nodes[c * tables.n_nodes + i], i lexicographic on the unit cell (first coordinate fastest),
   * then the cell's pressure nodes. */
  std::vector<std::size_t> cell_nodes;
  ShapeTables tables; ///< Gauss, degree + 1 points a direction, slots 0 to 3
  /**
   * The last nodes of every cell that carry a pressure, polynomials of degree k - 1 without continuity between cells;
   * see add_pressure_nodes(). Such a node is an amplitude, not a place: its position is zero for ever, and a pressure
   * is zero at all other nodes, so that one table serves both fields.
   */
  unsigned int n_pressure_nodes = 0;
  std::map<std::string, std::vector<std::size_t>> faces; ///< nodes on the faces, by name: "top", "bottom", "side"
};

/**
 * A surface in pieces of degree k, whichever way it is described: cells, nodes, shape tables, what the nodes may
 * do. Nothing here knows physics; the positions are a start shape and from then on a field like any other. Bodies may
 * come with the surface, or stand alone (no cells in the surface).
 */
struct SurfaceDiscretization
{
  enum class Kind
  {
    surface, ///< quadrilateral cells of degree k in R^3
    meridian ///< line cells of degree k in the half plane r >= 0, y = 0, from the north pole (z > 0) down
  };

  Kind kind           = Kind::surface;
  unsigned int degree = 3;
  std::size_t n_nodes = 0;
  std::size_t n_cells = 0;
  /** Nodes of cell c: cell_nodes[c * n_local + i], i lexicographic on the tensor-product unit cell (first coordinate
   * fastest). */
  std::vector<std::size_t> cell_nodes;
  /** One per cell; empty: the mesh is none of a family, nothing can be carried over to a finer one. */
  std::vector<CellPlace> cell_places;
  std::vector<HangingNode> hanging; ///< where cells of different sizes meet
  NodalVectors positions;           ///< start shape, oriented so that a_1 x a_2 points out of the enclosed volume
  /** Start values of fields other than the position, by name; those that are not named start as their kind does
   * (unit vectors: along the normals; others: zero). */
  std::map<std::string, NodalVectors> start_values;
  /** The same nodes on a surface where they are well spread: the start shape, or the sphere it is a map of. */
  NodalVectors mesh_reference;
  ShapeTables tables;                           ///< Gauss, degree + 1 points a direction, all six slots
  std::vector<AdmissibleDirections> admissible; ///< one per node; empty: all nodes are free
  std::vector<RigidMotion> rigid_motions;       ///< six in R^3, one (along z) on a meridian, none with a mirror plane
  bool mirror = false;                          ///< a meridian that ends on the mirror plane z = 0
  std::vector<EdgeLoop> edges;                  ///< rims of an open surface and lines around regions
  std::vector<BulkPart> bulks;                  ///< bodies
  std::vector<unsigned int> cell_region;        ///< index into region_names, one per cell; empty: one region
  std::vector<std::string> region_names;        ///< the first is the membrane outside all other regions

  /** Nodes that stand at the place of another one (copy, original), where a surface is split along a line. */
  std::vector<std::pair<std::size_t, std::size_t>> twins;

  std::size_t n_local() const { return tables.n_nodes; }
  /** Whether more than two sheets meet along a line: then the surface as a whole has no inside. */
  bool has_junctions() const
  {
    return std::any_of(edges.begin(), edges.end(), [](const EdgeLoop &edge) { return edge.is_junction; });
  }
  bool is_closed() const
  {
    return std::none_of(edges.begin(), edges.end(), [](const EdgeLoop &edge) { return edge.is_rim; });
  }
};

/** Shape tables of the unit cell with tensor-product Gauss points, for output and quantities as well as for assembly.
 */
ShapeTables make_surface_tables(unsigned int degree, unsigned int n_gauss_points);
ShapeTables make_meridian_tables(unsigned int degree, unsigned int n_gauss_points, bool mirror);
/** Of one edge of a surface's cell: Gauss points on [0, 1], slots 0 and 1. */
ShapeTables make_edge_tables(unsigned int degree, unsigned int n_gauss_points);
/** Of the circle that one node of a meridian stands for, weight 2 pi. `direction` +1: the line runs along e_phi (the
 * surface comes down to it), -1: against it. */
ShapeTables make_circle_tables(int direction);

/** Of a hexahedron, and of a quadrilateral revolved about z (weights with the factor 2 pi): tensor-product Gauss
 * points.
 */
ShapeTables make_hexahedron_tables(unsigned int degree, unsigned int n_gauss_points);
ShapeTables make_revolved_quad_tables(unsigned int degree, unsigned int n_gauss_points);

/** Values of the cell's 1-D or tensor-product Lagrange basis (Gauss-Lobatto support points of FE_Q, lexicographic) at
 * arbitrary unit points: a table like the above with the given points (surface: xi in [0,1]^2; meridian: only the first
 * coordinate counts) and unit weights. */
ShapeTables make_tables_at(SurfaceDiscretization::Kind kind, unsigned int degree,
                           const std::vector<std::array<double, 2>> &unit_points);

/** Point inputs of one field in one cell: inputs[(q * 6 + s) * 3 + c] for the first `n_slots` slots (others untouched).
 */
void evaluate_field(const ShapeTables &tables, const std::size_t *cell_nodes, const NodalVectors &values,
                    unsigned int n_slots, double *inputs);
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/refinement.h>
#include <pellicle/discretization/surface_discretization.h>

#include <functional>

namespace pellicle
{
/** Four vertices of a quadrilateral, lexicographic: (0,0), (1,0), (0,1), (1,1) on the unit cell. */
using QuadVertices = std::array<unsigned int, 4>;

/** Where a node of a cell lies: local coordinates in [-1, 1]^2 of a coarse quadrilateral. */
struct PatchPoint
{
  unsigned int patch = 0;
  double xi          = 0.;
  double eta         = 0.;
  CellPlace cell     = {}; ///< the cell's
};

/**
 * Coarse quadrilaterals ("patches") of a surface, each cut into 4^r cells of degree k or more, with all nodes
 * numbered across patches. Pure topology: where the nodes are in space is up to the map given to place_nodes().
 */
struct RefinedQuads
{
  std::vector<QuadVertices>
      patches; ///< as given, but each turned (never flipped) so that neighbours agree on edge directions
  std::size_t n_nodes = 0;
  std::size_t n_cells = 0;
  std::vector<std::size_t> cell_nodes; ///< lexicographic in a cell, as in SurfaceDiscretization
  std::vector<CellPlace> cell_places;
  std::vector<PatchPoint> cell_sites; ///< of every entry of cell_nodes; exactly antisymmetric about the patch's centre
  std::vector<HangingNode> hanging;
};

/**
 * The same quadrilaterals, each turned so that two neighbours run along their common edge in the same direction, as
 * deal.II needs for nodes on edges to be shared. Opposite edges of a cell run alike, so that this can be done band of
 * cells by band of cells; on a surface oriented outwards no band is twisted, and turning (without flipping) is enough.
 */
std::vector<QuadVertices> with_consistent_edges(const std::vector<QuadVertices> &quads);

/**
 * Cuts and numbers, by means of a deal.II triangulation that lives no longer than this call.
 *
 * Vertices are needed for their connectivity only. The quadrilaterals must cover an orientable surface, closed
 * or with rims, and be oriented alike; this is asserted, not diagnosed (see orient_closed_surface() for meshes that
 * come from users). Neighbours differ in size by a factor of two at most, also those that share a vertex only, so that
 * nothing hangs on a hanging node. Throws UserError beyond a million cells.
 *
 * @param regions  one number per quadrilateral, or none: at lines between regions, and so on them, no node hangs.
 */
RefinedQuads refine_quads(const std::vector<Vector3<double>> &vertices, const std::vector<QuadVertices> &quads,
                          const Refinement &refinement, unsigned int degree,
                          const std::vector<unsigned int> &regions = {});

/** Discretization with Gauss tables and six rigid motions, whose node at site s is point(s), but for hanging ones,
 * which lie on their neighbours. `point` must be continuous across patches. */
SurfaceDiscretization place_nodes(const RefinedQuads &mesh, unsigned int degree,
                                  const std::function<Vector3<double>(const PatchPoint &)> &point);

/**
 * The same for a map given patch by patch in the coordinates (u, v) in [0, 1]^2 of the quadrilaterals as they were
 * before refine_quads() turned them: `quads` are the ones it was given.
 */
SurfaceDiscretization place_nodes(const RefinedQuads &mesh, const std::vector<QuadVertices> &quads, unsigned int degree,
                                  const std::function<Vector3<double>(unsigned int patch, double u, double v)> &point);

/** Vertices of quadrilaterals whose coordinates (u, v) the map is given in, for refine_quads(). */
std::vector<Vector3<double>>
corner_points(const std::vector<QuadVertices> &quads, std::size_t n_vertices,
              const std::function<Vector3<double>(unsigned int patch, double u, double v)> &point);

/** Gauss-Lobatto points of degree k on [-1, 1], exactly antisymmetric: the nodes of a cell along one direction. */
std::vector<double> line_nodes(unsigned int degree);
} // namespace pellicle

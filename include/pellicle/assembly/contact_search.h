// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/cell_projection.h>
#include <pellicle/assembly/surface_cells.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace pellicle
{
/** How far from the master a partner is looked for. */
struct SearchLimits
{
  /** Points farther outside have no partner. Below half the smallest radius of curvature closest points are unique. */
  double distance = 0.;
  /** Points deeper inside are an error: which side they came from is no longer certain. */
  double penetration = 0.;
};

/** The closest point of the master to a point x. */
struct ContactPartner
{
  std::size_t cell = 0; ///< of the master
  CellProjection at;
  double gap = 0.;        ///< negative inside
  Vector3<double> normal; ///< n_p; of an edge or vertex along x - x_p
};

/**
 * Looks for closest points of a surface made of cells of degree k, as it stands. An R-tree holds a box for each cell:
 * that of its nodes, widened about its centre by the square of the Lebesgue constant, so that no cell leaves its box
 * however it bulges. Cells are visited with growing distance of their boxes until no nearer point is possible.
 *
 * Points whose closest point is on a rim of the master have none: they are beside it.
 */
class ContactSearch
{
public:
  /** Throws UserError unless both limits are positive. Nothing is found before update(). */
  ContactSearch(SurfaceCells master, const SearchLimits &limits);
  ~ContactSearch();
  ContactSearch(ContactSearch &&) noexcept;

  /** The master's nodes are now here. */
  void update(const NodalVectors &positions);

  /**
   * The closest point that faces x: slave_normal . n_p < 0 for a slave surface with that normal at x; a zero vector
   * asks for nothing. `previous`: a cell to try first, which is kept among equally near ones. Nothing, if x is too far
   * outside, beside the master, or next to a side of it that does not face x. Throws SolveError with the point, the
   * cell and the gap for a point that is too deep inside.
   */
  std::optional<ContactPartner> closest(const Vector3<double> &x, const Vector3<double> &slave_normal,
                                        std::optional<std::size_t> previous = {}) const;

  const SurfaceCells &master() const { return cells; }
  CellShape shape(const std::size_t cell) const { return {line, nodes.data() + cell * cells.n_local()}; }

private:
  struct Boxes;
  struct Candidates;

  bool on_rim(std::size_t cell, const CellProjection &at) const;
  void try_cell(std::size_t cell, const Vector3<double> &x, const Vector3<double> &slave_normal,
                Candidates &candidates) const;

  SurfaceCells cells;
  SearchLimits limits;
  LagrangeLine line;
  std::vector<Vector3<double>> nodes; ///< [cell * n_local + i]
  std::unique_ptr<Boxes> boxes;
};
} // namespace pellicle

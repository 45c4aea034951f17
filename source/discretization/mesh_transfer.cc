// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/mesh_transfer.h>
#include <pellicle/discretization/refined_quads.h>

#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace pellicle
{
namespace
{
/** Cells by their places: those of one size stand on a grid. */
class CellsByPlace
{
public:
  explicit CellsByPlace(const std::vector<CellPlace> &places)
  {
    for (std::size_t cell = 0; cell < places.size(); ++cell)
    {
      const auto &[patch, u0, v0, size]                                        = places[cell];
      grids[{patch, size}][{std::llround(u0 / size), std::llround(v0 / size)}] = cell;
    }
  }

  /** The cell in which the given one lies; a meridian's cells have no second coordinate. */
  std::optional<std::size_t> around(const CellPlace &inner, const bool meridian) const
  {
    const double u = inner.u0 + 0.5 * inner.size, v = meridian ? 0. : inner.v0 + 0.5 * inner.size;
    for (auto grid = grids.lower_bound({inner.patch, 0.}); grid != grids.end() && grid->first.first == inner.patch;
         ++grid)
    {
      const double size = grid->first.second;
      const auto found  = grid->second.find(
           {static_cast<long long>(std::floor(u / size)), static_cast<long long>(std::floor(v / size))});
      if (found != grid->second.end())
        return found->second;
    }
    return std::nullopt;
  }

private:
  using Grid = std::map<std::pair<long long, long long>, std::size_t>;
  std::map<std::pair<unsigned int, double>, Grid> grids; ///< by patch and size of the cells
};

/** The part of a cell that another one is: square number (i, j) of n x n. */
struct Part
{
  long long n = 1, i = 0, j = 0;

  bool operator<(const Part &other) const
  {
    return std::array<long long, 3>{{n, i, j}} < std::array<long long, 3>{{other.n, other.i, other.j}};
  }
};

Part part_of(const CellPlace &outer, const CellPlace &inner)
{
  return {std::llround(outer.size / inner.size), std::llround((inner.u0 - outer.u0) / inner.size),
          std::llround((inner.v0 - outer.v0) / inner.size)};
}

/** Whether the inner cell is a whole part of the outer one, and not only overlaps with it. */
bool is_part(const CellPlace &outer, const CellPlace &inner)
{
  constexpr double round_off = 1e-9;
  const double n = outer.size / inner.size, i = (inner.u0 - outer.u0) / inner.size;
  return n > 1. - round_off && std::abs(n - std::round(n)) < round_off * n &&
         std::abs(i - std::round(i)) < round_off * n;
}

/** Nodes of a cell of the given degree that is a part of another cell, in the unit coordinates of that one. */
std::vector<std::array<double, 2>> nodes_of_part(const Part &part, const unsigned int degree, const bool meridian)
{
  const std::vector<double> line = line_nodes(degree);
  const auto at                  = [&](const long long number, const double xi)
  { return (static_cast<double>(number) + 0.5 * (1. + xi)) / static_cast<double>(part.n); };
  std::vector<std::array<double, 2>> points;
  for (std::size_t b = 0; b < (meridian ? 1 : line.size()); ++b)
    for (const double xi : line)
      points.push_back({{at(part.i, xi), meridian ? 0. : at(part.j, line[b])}});
  return points;
}
} // namespace

bool MeshTransfer::is_possible(const SurfaceDiscretization &from, const SurfaceDiscretization &to)
{
  if (from.kind != to.kind || from.n_cells == 0 || from.cell_places.size() != from.n_cells ||
      to.cell_places.size() != to.n_cells || !from.bulks.empty() || !to.bulks.empty())
    return false;
  const CellsByPlace cells(from.cell_places);
  for (const CellPlace &place : to.cell_places)
  {
    const std::optional<std::size_t> cell = cells.around(place, from.kind == SurfaceDiscretization::Kind::meridian);
    if (!cell || !is_part(from.cell_places[*cell], place))
      return false;
  }
  return true;
}

MeshTransfer::MeshTransfer(const SurfaceDiscretization &from, const SurfaceDiscretization &to)
    : n_local(from.n_local())
    , cell_nodes(from.cell_nodes)
    , places(to.n_nodes, {std::numeric_limits<std::size_t>::max(), 0, 0})
{
  PELLICLE_ASSERT(is_possible(from, to), "nothing can be carried over between these meshes");
  const bool meridian = from.kind == SurfaceDiscretization::Kind::meridian;
  const CellsByPlace cells(from.cell_places);
  std::map<Part, std::size_t> table_of;
  for (std::size_t c = 0; c < to.n_cells; ++c)
  {
    const std::size_t cell  = *cells.around(to.cell_places[c], meridian);
    const Part part         = part_of(from.cell_places[cell], to.cell_places[c]);
    const auto [at, is_new] = table_of.try_emplace(part, tables.size());
    if (is_new)
      tables.push_back(make_tables_at(from.kind, from.degree, nodes_of_part(part, to.degree, meridian)).tables[0]);
    for (unsigned int i = 0; i < to.n_local(); ++i)
      places[to.cell_nodes[c * to.n_local() + i]] = {cell, at->second, i};
  }
}

NodalVectors MeshTransfer::operator()(const NodalVectors &values) const
{
  NodalVectors result(3 * places.size(), 0.);
  for (std::size_t I = 0; I < places.size(); ++I)
  {
    const Place &place = places[I];
    if (place.cell == std::numeric_limits<std::size_t>::max())
      continue; // a node of no cell of the surface
    const std::size_t *const nodes = cell_nodes.data() + place.cell * n_local;
    const double *const shares     = tables[place.table].data() + place.point * n_local;
    for (std::size_t i = 0; i < n_local; ++i)
      for (unsigned int c = 0; c < 3; ++c)
        result[3 * I + c] += shares[i] * values[3 * nodes[i] + c];
  }
  return result;
}
} // namespace pellicle

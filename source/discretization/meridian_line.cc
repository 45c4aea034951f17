// SPDX-License-Identifier: LGPL-2.1-or-later
#include "meridian_line.h"

#include <pellicle/discretization/refined_quads.h>

namespace pellicle
{
namespace
{
constexpr std::array<double, 3> e_x{{1., 0., 0.}}, e_z{{0., 0., 1.}};

/** Columns beyond the count are zero. */
AdmissibleDirections directions(const std::vector<std::array<double, 3>> &columns)
{
  AdmissibleDirections result;
  result.count   = columns.size();
  result.columns = {};
  for (std::size_t i = 0; i < columns.size(); ++i)
    result.columns[i] = columns[i];
  return result;
}

/** From `begin` to `begin + size` in the line's parameter t. */
struct LineCell
{
  double begin = 0.;
  double size  = 1.;
};

std::vector<LineCell> line_cells(const std::size_t n_uniform, const std::vector<CellPlace> &cut)
{
  std::vector<LineCell> cells(n_uniform);
  for (std::size_t cell = 0; cell < n_uniform; ++cell)
    cells[cell].begin = static_cast<double>(cell);
  const Refinement wanted(0, cut);
  const auto n = static_cast<double>(n_uniform);
  for (bool any = !cut.empty(); any;)
  {
    std::vector<LineCell> finer;
    for (std::size_t c = 0; c < cells.size(); ++c)
    {
      const auto [begin, size] = cells[c];
      const bool next_to_finest =
          (c > 0 && cells[c - 1].size < 0.5 * size) || (c + 1 < cells.size() && cells[c + 1].size < 0.5 * size);
      if (next_to_finest || wanted.cuts({0, begin / n, 0., size / n}))
        finer.insert(finer.end(), {{begin, 0.5 * size}, {begin + 0.5 * size, 0.5 * size}});
      else
        finer.push_back(cells[c]);
    }
    any = finer.size() > cells.size();
    cells.swap(finer);
  }
  return cells;
}
} // namespace

SurfaceDiscretization meridian_line(const unsigned int degree, const std::size_t n_cells,
                                    const std::vector<CellPlace> &cut, const bool mirror,
                                    const std::function<Vector3<double>(double)> &point)
{
  const std::vector<LineCell> cells = line_cells(n_cells, cut);
  SurfaceDiscretization result;
  result.kind    = SurfaceDiscretization::Kind::meridian;
  result.degree  = degree;
  result.mirror  = mirror;
  result.n_cells = cells.size();
  result.n_nodes = degree * cells.size() + 1;
  result.tables  = make_meridian_tables(degree, degree + 1, mirror);
  result.positions.resize(3 * result.n_nodes, 0.);
  result.admissible.resize(result.n_nodes, directions({e_x, e_z}));

  const std::vector<double> nodes = line_nodes(degree);
  const auto n                    = static_cast<double>(n_cells);
  for (std::size_t cell = 0; cell < cells.size(); ++cell)
  {
    const auto [begin, size] = cells[cell];
    result.cell_places.push_back({0, begin / n, 0., size / n});
    for (unsigned int i = 0; i <= degree; ++i)
    {
      const std::size_t node = cell * degree + i;
      result.cell_nodes.push_back(node);
      const Vector3<double> x        = point(begin + size * (0.5 * (1. + nodes[i])));
      result.positions[3 * node]     = x[0];
      result.positions[3 * node + 2] = x[2];
    }
  }
  return result;
}

void put_on_axis(SurfaceDiscretization &meridian, const std::size_t node)
{
  meridian.positions[3 * node] = 0.;
  meridian.admissible[node]    = directions({e_z});
}

void put_on_mirror(SurfaceDiscretization &meridian, const std::size_t node)
{
  meridian.positions[3 * node + 2] = 0.;
  meridian.admissible[node]        = directions({e_x});
}

void free_along_axis(SurfaceDiscretization &meridian)
{
  meridian.rigid_motions.resize(1);
  meridian.rigid_motions[0].translation = e_z;
}
} // namespace pellicle

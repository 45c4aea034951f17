// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/edge_loops.h>
#include <pellicle/discretization/point_walk.h>

#include <deal.II/base/quadrature_lib.h>

namespace pellicle
{
namespace
{
/** The cell's shape functions along one of its sides, at Gauss points in the direction that has the cell on its left.
 */
ShapeTables side_tables(const unsigned int degree, const unsigned int n_points, const unsigned int side)
{
  std::vector<std::array<double, 2>> points;
  const dealii::QGauss<1> rule(n_points);
  for (const dealii::Point<1> &gauss : rule.get_points())
  {
    const double g = gauss[0];
    const std::array<std::array<double, 2>, 4> on_side{{{{g, 0.}}, {{1., g}}, {{1. - g, 1.}}, {{0., 1. - g}}}};
    points.push_back(on_side[side]);
  }
  return make_tables_at(SurfaceDiscretization::Kind::surface, degree, points);
}

std::vector<Vector3<double>> conormal_of_circle(const SurfaceDiscretization &meridian, const CellSide &at,
                                                const NodalVectors &positions)
{
  const ShapeTables tables = make_tables_at(meridian.kind, meridian.degree, {{{at.side == 1 ? 1. : 0., 0.}}});
  double x[18];
  evaluate_field(tables, &meridian.cell_nodes[at.cell * meridian.n_local()], positions, 2, x);
  const Vector3<double> along(x[3], x[4], x[5]);
  return {(at.side == 1 ? 1. : -1.) / norm(along) * along};
}
} // namespace

double loop_length(const EdgeLoop &loop, const NodalVectors &positions)
{
  double length = 0.;
  for_all_points(loop.tables, loop.cell_nodes, positions, 2,
                 [&](const WalkPoint &x) { length += x.weight * norm(x[1]); });
  return length;
}

std::vector<double> line_elements(const EdgeLoop &loop, const NodalVectors &positions)
{
  std::vector<double> elements;
  for_all_points(loop.tables, loop.cell_nodes, positions, 2,
                 [&](const WalkPoint &x) { elements.push_back(norm(x[1])); });
  return elements;
}

std::vector<Vector3<double>> conormals(const SurfaceDiscretization &surface, const EdgeLoop &loop,
                                       const NodalVectors &positions)
{
  PELLICLE_ASSERT(loop.sides.size() == loop.n_cells, "every edge has a cell on its left");
  if (surface.kind == SurfaceDiscretization::Kind::meridian)
    return conormal_of_circle(surface, loop.sides[0], positions);

  const unsigned int n_points = loop.tables.n_points;
  std::array<ShapeTables, 4> tables;
  for (unsigned int side = 0; side < 4; ++side)
    tables[side] = side_tables(surface.degree, n_points, side);

  std::vector<Vector3<double>> result;
  std::vector<double> inputs(std::size_t(n_points) * 18);
  for (const CellSide &at : loop.sides)
  {
    const WalkCell cell{at.cell, &surface.cell_nodes[at.cell * surface.n_local()], tables[at.side], inputs.data()};
    evaluate_field(cell.tables, cell.nodes, positions, 3, inputs.data());
    for (unsigned int q = 0; q < n_points; ++q)
    {
      const Vector3<double> a1 = cell[q][1], a2 = cell[q][2];
      const Vector3<double> along = (at.side < 2 ? 1. : -1.) * (at.side % 2 == 0 ? a1 : a2);
      const Vector3<double> out   = cross(along, cross(a1, a2));
      result.push_back(out / norm(out));
    }
  }
  return result;
}
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/point_walk.h>
#include <pellicle/models/cell_geometry.h>

#include <deal.II/base/quadrature_lib.h>

#include <array>
#include <vector>

namespace pellicle
{
CellGeometry::CellGeometry(const SurfaceDiscretization &discretization, const NodalVectors &nodal_positions)
    : surface(discretization)
    , positions(nodal_positions)
    , basis(dealii::Polynomials::generate_complete_Lagrange_basis(
          dealii::QGaussLobatto<1>(discretization.degree + 1).get_points()))
    , n_grid(2 * discretization.degree + 3)
{
  PELLICLE_ASSERT(positions.size() == 3 * surface.n_nodes, "three coordinates for every node");
  std::vector<std::array<double, 2>> points(n_samples());
  for (unsigned int i = 0; i < n_samples(); ++i)
    points[i] = sample_coordinates(i);
  const ShapeTables tables = make_tables_at(surface.kind, surface.degree, points);
  samples.reserve(n_cells() * n_samples());
  for_all_points(tables, surface.cell_nodes, positions, 1, [&](const WalkPoint &x) { samples.push_back(x[0]); });
}

std::array<double, 2> CellGeometry::sample_coordinates(const unsigned int sample) const
{
  const double spacing = 1. / (n_grid - 1);
  return {{spacing * (sample % n_grid), spacing * (sample / n_grid)}};
}

CellPoint CellGeometry::at(const CellSite &site) const
{
  constexpr unsigned int most_nodes = 8;
  const unsigned int n              = surface.degree + 1;
  PELLICLE_ASSERT(n <= most_nodes, "degree too high");

  // values[direction][node][order of the derivative]; without a second direction the one factor is 1.
  double values[2][most_nodes][3] = {};
  values[1][0][0]                 = 1.;
  for (unsigned int d = 0; d < n_parameters(); ++d)
    for (unsigned int i = 0; i < n; ++i)
      basis[i].value(site.xi[d], 2, values[d][i]);

  CellPoint point;
  const std::size_t *node = &surface.cell_nodes[site.cell * surface.n_local()];
  for (unsigned int j = 0; j < (n_parameters() == 2 ? n : 1); ++j)
    for (unsigned int i = 0; i < n; ++i, ++node)
    {
      const double *const u = values[0][i], *const v = values[1][j];
      const Vector3<double> x(positions[3 * *node], positions[3 * *node + 1], positions[3 * *node + 2]);
      point.x += (u[0] * v[0]) * x;
      point.first[0] += (u[1] * v[0]) * x;
      point.first[1] += (u[0] * v[1]) * x;
      point.second[0] += (u[2] * v[0]) * x;
      point.second[1] += (u[1] * v[1]) * x;
      point.second[2] += (u[0] * v[2]) * x;
    }
  return point;
}
} // namespace pellicle

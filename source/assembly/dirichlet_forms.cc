// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/dirichlet_forms.h>
#include <pellicle/discretization/point_walk.h>

#include <algorithm>
#include <cmath>

namespace pellicle
{
using Entries = std::vector<Eigen::Triplet<double>>;

std::array<Entries, 3> dirichlet_forms(const SurfaceDiscretization &discretization, const NodalVectors &positions,
                                       const std::function<bool(std::size_t)> &counts)
{
  const ShapeTables &tables = discretization.tables;
  const unsigned int n      = tables.n_nodes;
  std::array<Entries, 3> forms;
  std::vector<double> local(std::size_t(n) * n);
  const auto add_cell = [&](const WalkCell &cell)
  {
    if (std::none_of(cell.nodes, cell.nodes + n, counts))
      return;
    for (unsigned int c = 0; c < 3; ++c)
    {
      // How derivatives of the component enter: not at all, or with the length of the map's column.
      std::array<double, 2> factor{};
      for (unsigned int a = 0; a < 2; ++a)
        for (unsigned int row = 0; row < 3; ++row)
          factor[a] += std::pow(tables.map[1 + a][3 * row + c], 2);
      const bool identity = discretization.kind == SurfaceDiscretization::Kind::surface;
      std::fill(local.begin(), local.end(), 0.);
      for (unsigned int q = 0; q < tables.n_points; ++q)
      {
        const Vector3<double> x1 = cell[q][1], x2 = cell[q][2];
        const double dA = cell[q].area(), J2 = std::pow(norm(cross(x1, x2)), 2);
        const double a11 = factor[0] * dot(x2, x2) / J2, a12 = identity ? -dot(x1, x2) / J2 : 0.,
                     a22 = factor[1] * dot(x1, x1) / J2;
        const double *N1 = tables.tables[1].data() + std::size_t(q) * n,
                     *N2 = tables.tables[2].data() + std::size_t(q) * n;
        for (unsigned int I = 0; I < n; ++I)
          for (unsigned int J = 0; J < n; ++J)
            local[I * n + J] +=
                dA * (a11 * N1[I] * N1[J] + a12 * (N1[I] * N2[J] + N2[I] * N1[J]) + a22 * N2[I] * N2[J]);
      }
      for (unsigned int I = 0; I < n; ++I)
        for (unsigned int J = 0; J < n; ++J)
          forms[c].emplace_back(static_cast<int>(cell.nodes[I]), static_cast<int>(cell.nodes[J]), local[I * n + J]);
    }
  };
  for_all_cells(tables, discretization.cell_nodes, positions, 3, add_cell);
  return forms;
}
} // namespace pellicle

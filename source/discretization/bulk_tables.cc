// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/constants.h>
#include <pellicle/discretization/surface_discretization.h>

namespace pellicle
{
namespace
{
/** Tensor product of two or three one-dimensional tables, slots 0 to 3; of two, slot 3 holds the values again. */
ShapeTables tensor_product(const ShapeTables &line, const unsigned int dimension)
{
  const unsigned int n_third_points = dimension == 3 ? line.n_points : 1, n_third = dimension == 3 ? line.n_nodes : 1;
  ShapeTables t;
  t.n_points = line.n_points * line.n_points * n_third_points;
  t.n_nodes  = line.n_nodes * line.n_nodes * n_third;
  for (std::vector<double> &table : t.tables)
    table.reserve(std::size_t(t.n_points) * t.n_nodes);
  // N or N' of the line's node i at its point q; 1 along a direction that is not there.
  const auto factor = [&](const unsigned int slot, const unsigned int q, const unsigned int i)
  { return line.tables[slot][std::size_t(q) * line.n_nodes + i]; };
  for (unsigned int r = 0; r < n_third_points; ++r)
    for (unsigned int q = 0; q < line.n_points; ++q)
      for (unsigned int p = 0; p < line.n_points; ++p)
      {
        t.weights.push_back(line.weights[p] * line.weights[q] * (dimension == 3 ? line.weights[r] : 1.));
        for (unsigned int k = 0; k < n_third; ++k)
          for (unsigned int j = 0; j < line.n_nodes; ++j)
            for (unsigned int i = 0; i < line.n_nodes; ++i)
            {
              const double N1 = factor(0, p, i), N2 = factor(0, q, j), N3 = dimension == 3 ? factor(0, r, k) : 1.;
              t.tables[0].push_back(N1 * N2 * N3);
              t.tables[1].push_back(factor(1, p, i) * N2 * N3);
              t.tables[2].push_back(N1 * factor(1, q, j) * N3);
              t.tables[3].push_back(dimension == 3 ? N1 * N2 * factor(1, r, k) : N1 * N2);
            }
      }
  for (const unsigned int slot : {4, 5})
    t.tables[slot].assign(t.tables[0].size(), 0.);
  return t;
}
} // namespace

ShapeTables make_hexahedron_tables(const unsigned int degree, const unsigned int n_gauss_points)
{
  ShapeTables t = tensor_product(make_edge_tables(degree, n_gauss_points), 3);
  t.map.fill({{1., 0., 0., 0., 1., 0., 0., 0., 1.}});
  return t;
}

// d/dphi of v = (v_r, 0, v_z) carried along by the revolution, in the plane phi = 0: v,3 = v_r e_phi.
ShapeTables make_revolved_quad_tables(const unsigned int degree, const unsigned int n_gauss_points)
{
  ShapeTables t = tensor_product(make_edge_tables(degree, n_gauss_points), 2);
  for (double &weight : t.weights)
    weight *= 2. * pi;
  t.map.fill({{1., 0., 0., 0., 0., 0., 0., 0., 1.}});      // diag(1, 0, 1)
  t.map[3]       = {{0., 0., 0., 1., 0., 0., 0., 0., 0.}}; // e_y e_x^T
  t.identity_map = false;
  return t;
}
} // namespace pellicle

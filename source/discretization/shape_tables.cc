// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/constants.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/surface_discretization.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>

namespace pellicle
{
namespace
{
constexpr double two_pi = 2. * pi;
constexpr std::array<double, 9> identity{{1., 0., 0., 0., 1., 0., 0., 0., 1.}};
constexpr std::array<double, 9> in_plane{{1., 0., 0., 0., 0., 0., 0., 0., 1.}};      // diag(1, 0, 1)
constexpr std::array<double, 9> radial_to_phi{{0., 0., 0., 1., 0., 0., 0., 0., 0.}}; // e_y e_x^T
constexpr std::array<double, 9> minus_radial{{-1., 0., 0., 0., 0., 0., 0., 0., 0.}}; // -e_x e_x^T

/** Sizes, weights and maps; the tables themselves are left at zero. */
template <int dim>
ShapeTables empty_tables(const unsigned int n_nodes, const std::vector<double> &weights)
{
  ShapeTables t;
  t.n_points = weights.size();
  t.n_nodes  = n_nodes;
  t.weights  = weights;
  for (std::vector<double> &table : t.tables)
    table.assign(std::size_t(t.n_points) * n_nodes, 0.);
  if constexpr (dim == 2)
    t.map.fill(identity);
  else
    // d/dphi of v(s) = (v_r, 0, v_z) carried along by the revolution, in the plane phi = 0: v,2 = v_r e_phi, v,22 =
    // -v_r e_r.
    t.map = {{in_plane, in_plane, radial_to_phi, in_plane, radial_to_phi, minus_radial}};
  t.identity_map = (dim == 2);
  return t;
}

/** Values and first two derivatives of all shape functions of a line at each point, along one direction. */
template <int dim>
std::vector<std::array<double, 3>> tabulate_line(const std::vector<dealii::Polynomials::Polynomial<double>> &basis,
                                                 const std::vector<dealii::Point<dim>> &points, const unsigned int d)
{
  std::vector<std::array<double, 3>> line;
  line.reserve(points.size() * basis.size());
  for (const dealii::Point<dim> &point : points)
    for (const auto &polynomial : basis)
    {
      line.emplace_back();
      polynomial.value(point[d], 2, line.back().data());
    }
  return line;
}

/** Products of FE_Q's polynomials, lexicographic. */
template <int dim>
ShapeTables tabulate(const unsigned int degree, const std::vector<dealii::Point<dim>> &points,
                     const std::vector<double> &weights)
{
  PELLICLE_ASSERT(degree >= 1, "piecewise constants do not describe a surface");
  const unsigned int n = degree + 1;
  const auto basis  = dealii::Polynomials::generate_complete_Lagrange_basis(dealii::QGaussLobatto<1>(n).get_points());
  const auto first  = tabulate_line<dim>(basis, points, 0);
  const auto second = tabulate_line<dim>(basis, points, dim - 1);

  ShapeTables t = empty_tables<dim>(dim == 2 ? n * n : n, weights);
  for (unsigned int q = 0; q < t.n_points; ++q)
    for (unsigned int i = 0; i < t.n_nodes; ++i)
    {
      const std::size_t at = std::size_t(q) * t.n_nodes + i;
      const auto &u        = first[q * n + i % n];
      if constexpr (dim == 2)
      {
        const auto &v   = second[q * n + i / n];
        t.tables[0][at] = u[0] * v[0];
        t.tables[1][at] = u[1] * v[0];
        t.tables[2][at] = u[0] * v[1];
        t.tables[3][at] = u[2] * v[0];
        t.tables[4][at] = u[1] * v[1];
        t.tables[5][at] = u[0] * v[2];
      }
      else
      {
        t.tables[0][at] = u[0];
        t.tables[1][at] = u[1];
        t.tables[2][at] = u[0];
        t.tables[3][at] = u[2];
        t.tables[4][at] = u[1];
        t.tables[5][at] = u[0];
      }
    }
  return t;
}

template <int dim>
ShapeTables tabulate_gauss(const unsigned int degree, const unsigned int n_gauss_points, const double factor)
{
  const dealii::QGauss<dim> gauss(n_gauss_points);
  std::vector<double> weights = gauss.get_weights();
  for (double &weight : weights)
    weight *= factor;
  return tabulate<dim>(degree, gauss.get_points(), weights);
}
} // namespace

ShapeTables make_surface_tables(const unsigned int degree, const unsigned int n_gauss_points)
{
  return tabulate_gauss<2>(degree, n_gauss_points, 1.);
}

ShapeTables make_meridian_tables(const unsigned int degree, const unsigned int n_gauss_points, const bool mirror)
{
  return tabulate_gauss<1>(degree, n_gauss_points, mirror ? 2. * two_pi : two_pi);
}

ShapeTables make_edge_tables(const unsigned int degree, const unsigned int n_gauss_points)
{
  ShapeTables t = tabulate_gauss<1>(degree, n_gauss_points, 1.);
  t.map.fill(identity);
  t.identity_map = true;
  for (const unsigned int slot : {2, 3, 4, 5})
    std::fill(t.tables[slot].begin(), t.tables[slot].end(), 0.);
  return t;
}

ShapeTables make_circle_tables(const int direction)
{
  PELLICLE_ASSERT(direction == 1 || direction == -1, "a circle is run through in one of two directions");
  ShapeTables t  = empty_tables<1>(1, {two_pi});
  t.tables[0][0] = 1.;
  t.tables[1][0] = direction;
  t.map[1]       = radial_to_phi;
  return t;
}

ShapeTables make_tables_at(const SurfaceDiscretization::Kind kind, const unsigned int degree,
                           const std::vector<std::array<double, 2>> &unit_points)
{
  const std::vector<double> unit_weights(unit_points.size(), 1.);
  if (kind == SurfaceDiscretization::Kind::surface)
  {
    std::vector<dealii::Point<2>> points;
    for (const auto &p : unit_points)
      points.emplace_back(p[0], p[1]);
    return tabulate<2>(degree, points, unit_weights);
  }
  std::vector<dealii::Point<1>> points;
  for (const auto &p : unit_points)
    points.emplace_back(p[0]);
  return tabulate<1>(degree, points, unit_weights);
}
} // namespace pellicle

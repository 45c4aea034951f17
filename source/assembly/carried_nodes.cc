// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/carried_nodes.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/point_walk.h>

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <array>
#include <cmath>

namespace pellicle
{
namespace
{
constexpr double smallest_share = 1e-14;

using Entries = std::vector<Eigen::Triplet<double>>;

/** Entries of the Dirichlet form for each of the three components, over cells of which some node is carried. On a
 * meridian the component along r gains u^2/r^2, the derivative along phi. */
std::array<Entries, 3> dirichlet_forms(const SurfaceDiscretization &discretization, const NodalVectors &positions,
                                       const std::vector<bool> &own)
{
  const ShapeTables &tables = discretization.tables;
  const unsigned int n      = tables.n_nodes;
  std::array<Entries, 3> forms;
  std::vector<double> local(std::size_t(n) * n);
  const auto add_cell = [&](const WalkCell &cell)
  {
    if (std::all_of(cell.nodes, cell.nodes + n, [&](const std::size_t node) { return own[node]; }))
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

bool admits(const SurfaceDiscretization &discretization, const std::size_t node, const unsigned int component)
{
  if (discretization.admissible.empty())
    return true;
  const AdmissibleDirections &directions = discretization.admissible[node];
  double part                            = 0.;
  for (unsigned int j = 0; j < directions.count; ++j)
    part += std::pow(directions.columns[j][component], 2);
  return part > 0.5;
}
} // namespace

std::vector<std::vector<NodalChart::Carrier>> carriers_of_sheets(const SurfaceDiscretization &discretization,
                                                                 const NodalVectors &positions,
                                                                 const std::vector<bool> &own,
                                                                 const std::vector<bool> &held)
{
  std::vector<std::vector<NodalChart::Carrier>> carriers(discretization.n_nodes);
  const std::array<Entries, 3> forms = dirichlet_forms(discretization, positions, own);
  for (unsigned int c = 0; c < 3; ++c)
  {
    // Numbers of the carried nodes, and of the sources, among the nodes of the sheets.
    constexpr int none = -1;
    std::vector<int> unknown(discretization.n_nodes, none), source(discretization.n_nodes, none);
    std::vector<std::size_t> unknown_nodes, source_nodes;
    const auto number = [](std::vector<int> &numbers, std::vector<std::size_t> &nodes, const int node)
    {
      if (numbers[node] != none)
        return;
      numbers[node] = static_cast<int>(nodes.size());
      nodes.push_back(static_cast<std::size_t>(node));
    };
    for (const auto &entry : forms[c])
      if (own[entry.row()])
        number(source, source_nodes, entry.row());
      else if (!held[entry.row()] && admits(discretization, entry.row(), c))
        number(unknown, unknown_nodes, entry.row());
    if (unknown_nodes.empty() || source_nodes.empty())
      continue;
    Entries inner;
    Eigen::MatrixXd right =
        Eigen::MatrixXd::Zero(static_cast<int>(unknown_nodes.size()), static_cast<int>(source_nodes.size()));
    for (const auto &entry : forms[c])
      if (unknown[entry.row()] != none && unknown[entry.col()] != none)
        inner.emplace_back(unknown[entry.row()], unknown[entry.col()], entry.value());
      else if (unknown[entry.row()] != none && source[entry.col()] != none)
        right(unknown[entry.row()], source[entry.col()]) -= entry.value();
    Eigen::SparseMatrix<double> matrix(right.rows(), right.rows());
    matrix.setFromTriplets(inner.begin(), inner.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factorised(matrix);
    PELLICLE_ASSERT(factorised.info() == Eigen::Success, "a sheet that nothing carries");
    const Eigen::MatrixXd shares = factorised.solve(right);
    for (int i = 0; i < shares.rows(); ++i)
      for (int j = 0; j < shares.cols(); ++j)
      {
        if (std::abs(shares(i, j)) < smallest_share)
          continue;
        auto &list = carriers[unknown_nodes[i]];
        const auto known =
            std::find_if(list.begin(), list.end(),
                         [&](const NodalChart::Carrier &carrier) { return carrier.node == source_nodes[j]; });
        if (known == list.end())
        {
          list.push_back({source_nodes[j], {}});
          list.back().share[c] = shares(i, j);
        }
        else
          known->share[c] = shares(i, j);
      }
  }
  return carriers;
}
} // namespace pellicle

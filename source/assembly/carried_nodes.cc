// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/carried_nodes.h>
#include <pellicle/assembly/dirichlet_forms.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/admissible.h>

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <array>
#include <cmath>

namespace pellicle
{
namespace
{
constexpr double smallest_share = 1e-14;
} // namespace

std::vector<std::vector<NodalChart::Carrier>> carriers_of_sheets(const SurfaceDiscretization &discretization,
                                                                 const NodalVectors &positions,
                                                                 const std::vector<bool> &own,
                                                                 const std::vector<bool> &held)
{
  std::vector<std::vector<NodalChart::Carrier>> carriers(discretization.n_nodes);
  const auto is_carried = [&](const std::size_t node) { return !own[node]; };
  const auto forms      = dirichlet_forms(discretization, positions, is_carried);
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
      else if (!held[entry.row()] && admits(admissible_at(discretization, entry.row()), c))
        number(unknown, unknown_nodes, entry.row());
    if (unknown_nodes.empty() || source_nodes.empty())
      continue;
    std::vector<Eigen::Triplet<double>> inner;
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

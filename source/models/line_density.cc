// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/discretization/point_walk.h>
#include <pellicle/models/line_density.h>

#include <Eigen/Cholesky>

namespace pellicle
{
std::vector<LineDensity> density_along_line(const EdgeLoop &line, const NodalVectors &positions,
                                            const std::map<std::size_t, double> &integrals)
{
  std::map<std::size_t, int> number;
  for (const std::size_t node : line.cell_nodes)
    number.emplace(node, static_cast<int>(number.size()));
  const int n             = static_cast<int>(number.size());
  Eigen::MatrixXd mass    = Eigen::MatrixXd::Zero(n, n);
  const ShapeTables &unit = line.tables;
  for_all_points(unit, line.cell_nodes, positions, 2,
                 [&](const WalkPoint &x)
                 {
                   const double ds = x.weight * norm(x[1]);
                   const double *N = unit.tables[0].data() + std::size_t(x.q) * unit.n_nodes;
                   for (unsigned int i = 0; i < unit.n_nodes; ++i)
                     for (unsigned int j = 0; j < unit.n_nodes; ++j)
                       mass(number[x.nodes[i]], number[x.nodes[j]]) += ds * N[i] * N[j];
                 });
  Eigen::VectorXd right(n);
  for (const auto &[node, i] : number)
    right(i) = integrals.at(node);
  const Eigen::VectorXd q = mass.ldlt().solve(right), lengths = mass.rowwise().sum();
  std::vector<LineDensity> result;
  for (int i = 0; i < n; ++i)
    result.push_back({q(i), lengths(i)});
  return result;
}
} // namespace pellicle

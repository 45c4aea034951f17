// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/dirichlet_forms.h>
#include <pellicle/assembly/faired_positions.h>
#include <pellicle/assembly/nodal_chart.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/admissible.h>

#include <Eigen/SparseCholesky>

#include <numeric>

namespace pellicle
{
namespace
{
constexpr int n_steps = 2;

/** M + tau D of one component; components that a node may not have are decoupled. */
Eigen::SparseMatrix<double> diffusion(const SurfaceDiscretization &discretization, const unsigned int component,
                                      const std::vector<Eigen::Triplet<double>> &form,
                                      const std::vector<double> &masses, const double tau)
{
  std::vector<Eigen::Triplet<double>> entries;
  const auto moves = [&](const int node)
  { return admits(admissible_at(discretization, static_cast<std::size_t>(node)), component); };
  for (const auto &entry : form)
    if (moves(entry.row()) && moves(entry.col()))
      entries.emplace_back(entry.row(), entry.col(), tau * entry.value());
  for (std::size_t node = 0; node < masses.size(); ++node)
    entries.emplace_back(static_cast<int>(node), static_cast<int>(node), masses[node]);
  Eigen::SparseMatrix<double> matrix(static_cast<int>(masses.size()), static_cast<int>(masses.size()));
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}
} // namespace

NodalVectors faired_positions(const SurfaceDiscretization &discretization, const NodalVectors &reference,
                              const NodalVectors &positions)
{
  const std::vector<double> masses = nodal_areas(discretization, reference);
  const double area                = std::accumulate(masses.begin(), masses.end(), 0.);
  const auto n                     = static_cast<double>(discretization.n_nodes);
  const bool meridian              = discretization.kind == SurfaceDiscretization::Kind::meridian;
  const double tau                 = meridian ? area / (n * n) : area / n;
  const auto forms                 = dirichlet_forms(discretization, reference, [](std::size_t) { return true; });
  NodalVectors result              = positions;
  for (unsigned int c = 0; c < 3; ++c)
  {
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factorised(
        diffusion(discretization, c, forms[c], masses, tau));
    PELLICLE_ASSERT(factorised.info() == Eigen::Success, "masses are positive, and the form has no negative values");
    Eigen::VectorXd values(static_cast<int>(discretization.n_nodes));
    for (int step = 0; step < n_steps; ++step)
    {
      for (std::size_t node = 0; node < discretization.n_nodes; ++node)
        values[static_cast<int>(node)] = masses[node] * result[3 * node + c];
      values = factorised.solve(values).eval();
      for (std::size_t node = 0; node < discretization.n_nodes; ++node)
        result[3 * node + c] = values[static_cast<int>(node)];
    }
  }
  return result;
}
} // namespace pellicle

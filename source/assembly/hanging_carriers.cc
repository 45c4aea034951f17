// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/hanging_carriers.h>
#include <pellicle/discretization/hanging_nodes.h>

#include <algorithm>
#include <vector>

namespace pellicle
{
namespace
{
using Carriers = std::vector<NodalChart::Carrier>;

/** Adds a share of the motion of a node, component by component. */
void add_share(Carriers &carriers, const std::size_t node, const std::array<double, 3> &share)
{
  auto found = std::find_if(carriers.begin(), carriers.end(),
                            [&](const NodalChart::Carrier &carrier) { return carrier.node == node; });
  if (found == carriers.end())
    found = carriers.insert(carriers.end(), {node, {}});
  for (unsigned int c = 0; c < 3; ++c)
    found->share[c] += share[c];
}

std::array<double, 3> product(const std::array<double, 3> &a, const std::array<double, 3> &b)
{
  return {{a[0] * b[0], a[1] * b[1], a[2] * b[2]}};
}
} // namespace

void carry_hanging_nodes(const SurfaceDiscretization &discretization, NodalChart &chart)
{
  if (discretization.hanging.empty())
    return;
  chart.carriers.resize(discretization.n_nodes);
  for (const HangingNode &hangs : discretization.hanging)
  {
    chart.nodes[hangs.node] = {};
    if (!chart.on_body.empty())
      chart.on_body[hangs.node].reset();
    Carriers all;
    for (const auto &[node, share] : hangs.shares)
    {
      const std::array<double, 3> alike{{share, share, share}};
      if (chart.nodes[node].count > 0)
        add_share(all, node, alike);
      for (const NodalChart::Carrier &carrier : chart.carriers[node])
        add_share(all, carrier.node, product(alike, carrier.share));
    }
    chart.carriers[hangs.node] = std::move(all);
  }
  const std::vector<bool> hangs = hanging_flags(discretization);
  for (std::size_t I = 0; I < discretization.n_nodes; ++I)
  {
    const auto is_carried_itself = [&](const NodalChart::Carrier &carrier) { return hangs[carrier.node]; };
    if (hangs[I] || std::none_of(chart.carriers[I].begin(), chart.carriers[I].end(), is_carried_itself))
      continue;
    Carriers all;
    for (const NodalChart::Carrier &carrier : chart.carriers[I])
      if (!hangs[carrier.node])
        add_share(all, carrier.node, carrier.share);
      else
        for (const NodalChart::Carrier &behind : chart.carriers[carrier.node])
          add_share(all, behind.node, product(carrier.share, behind.share));
    chart.carriers[I] = std::move(all);
  }
}

bool covers_surface(const Field &field)
{
  return field.space != FieldSpace::edge_conormals && field.space != FieldSpace::edge_scalars &&
         field.space != FieldSpace::bulk_scalars;
}

Eigen::SparseMatrix<double> hanging_prolongation(const SurfaceDiscretization &discretization)
{
  const auto size               = static_cast<Eigen::Index>(discretization.n_nodes);
  const std::vector<bool> hangs = hanging_flags(discretization);
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index I = 0; I < size; ++I)
    if (!hangs[static_cast<std::size_t>(I)])
      entries.emplace_back(I, I, 1.);
  for (const HangingNode &hanging : discretization.hanging)
    for (const auto &[node, share] : hanging.shares)
      entries.emplace_back(static_cast<Eigen::Index>(hanging.node), static_cast<Eigen::Index>(node), share);
  Eigen::SparseMatrix<double> P(size, size);
  P.setFromTriplets(entries.begin(), entries.end());
  return P;
}

Eigen::SparseMatrix<double> condensed(const SurfaceDiscretization &discretization,
                                      const Eigen::SparseMatrix<double> &matrix)
{
  if (discretization.hanging.empty())
    return matrix;
  const Eigen::SparseMatrix<double> P = hanging_prolongation(discretization);
  Eigen::SparseMatrix<double> result  = P.transpose() * matrix * P;
  for (const HangingNode &hanging : discretization.hanging)
  {
    const auto I          = static_cast<Eigen::Index>(hanging.node);
    result.coeffRef(I, I) = 1.;
  }
  return result;
}
} // namespace pellicle

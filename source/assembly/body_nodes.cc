// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/body_nodes.h>
#include <pellicle/base/exact_text.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/point_walk.h>

namespace pellicle
{
std::vector<ReferenceBasis> reference_bases(const BulkPart &body, const NodalVectors &positions)
{
  std::vector<ReferenceBasis> bases;
  bases.reserve(body.n_cells * body.tables.n_points);
  for_all_points(body.tables, body.cell_nodes, positions, 4,
                 [&](const WalkPoint &X)
                 {
                   bases.emplace_back(X[1], X[2], X[3]);
                   if (!(bases.back().volume > 0.))
                     throw UserError("The body \"" + body.name + "\" is folded at x = " + exact_text(X[0][0]) +
                                     ", y = " + exact_text(X[0][1]) + ", z = " + exact_text(X[0][2]) +
                                     ": a cell there is turned inside out. Move its nodes apart.");
                 });
  return bases;
}

NodalChart bulk_scalar_chart(const SurfaceDiscretization &discretization)
{
  NodalChart number, chart;
  number.nodes.resize(1);
  number.nodes[0].count      = 1;
  number.nodes[0].columns[0] = 1.;
  chart.nodes.resize(discretization.n_nodes);
  for (const BulkPart &body : discretization.bulks)
    for (std::size_t c = 1; c <= body.n_cells; ++c)
      for (unsigned int j = 1; j <= body.n_pressure_nodes; ++j)
        chart.nodes[body.cell_nodes[c * body.tables.n_nodes - j]] = number.nodes[0];
  return chart;
}

NodalChart surface_vector_chart(const SurfaceDiscretization &discretization)
{
  NodalChart chart = free_chart(discretization);
  if (discretization.bulks.empty())
    return chart;
  std::vector<bool> on_surface(discretization.n_nodes, false);
  for (const std::size_t node : discretization.cell_nodes)
    on_surface[node] = true;
  for (std::size_t I = 0; I < discretization.n_nodes; ++I)
    if (!on_surface[I])
      chart.nodes[I] = {};
  return chart;
}

std::vector<double> nodal_weights(const SurfaceDiscretization &discretization, const NodalVectors &positions)
{
  std::vector<double> weights = discretization.n_cells > 0 ? nodal_areas(discretization, positions)
                                                           : std::vector<double>(discretization.n_nodes, 0.);
  for (const BulkPart &body : discretization.bulks)
  {
    const ShapeTables &tables  = body.tables;
    const unsigned int n_nodes = tables.n_nodes - body.n_pressure_nodes;
    std::vector<double> volumes(discretization.n_nodes, 0.);
    double total = 0., sum = 0.;
    for_all_points(tables, body.cell_nodes, positions, 4,
                   [&](const WalkPoint &x)
                   {
                     const double dV = x.weight * dot(x[1], cross(x[2], x[3]));
                     total += dV;
                     for (unsigned int I = 0; I < n_nodes; ++I)
                     {
                       const double N = tables.tables[0][std::size_t(x.q) * tables.n_nodes + I];
                       volumes[x.nodes[I]] += N * N * dV;
                       sum += N * N * dV;
                     }
                   });
    for (std::size_t I = 0; I < weights.size(); ++I)
      weights[I] += volumes[I] * total / sum;
  }
  return weights;
}

void hold_nodes(NodalConditions &conditions, const std::string &field, const std::vector<std::size_t> &nodes,
                const std::size_t n_nodes)
{
  FieldConditions &these = conditions[field];
  these.only.resize(n_nodes);
  for (const std::size_t node : nodes)
    these.only[node] = held();
}
} // namespace pellicle

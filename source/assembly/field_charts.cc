// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/body_nodes.h>
#include <pellicle/assembly/edge_frames.h>
#include <pellicle/assembly/field_charts.h>
#include <pellicle/assembly/hanging_carriers.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/refined_quads.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace pellicle
{
namespace
{
constexpr double smallest_share = 1e-12; // of a carrier: below it, round-off of the interpolation

/** Orthonormal columns that span what the node's columns span, but for v; one less where v is in their span. */
NodalChart::Node orthogonal_to(const NodalChart::Node &node, const Vector3<double> &v)
{
  constexpr double in_span = 1e-6; // of the squared length that is left of a unit vector
  // Householder reflection of the columns' coefficients: the first of the new columns is along v's part in the span.
  std::array<double, 3> along{};
  double length = 0.;
  for (unsigned int j = 0; j < node.count; ++j)
  {
    along[j] = v[0] * node.columns[3 * j] + v[1] * node.columns[3 * j + 1] + v[2] * node.columns[3 * j + 2];
    length += along[j] * along[j];
  }
  if (length < in_span)
    return node;
  length             = std::sqrt(length);
  const double sign  = along[0] < 0. ? -1. : 1.;
  const double first = along[0] / length + sign; // of the reflection's vector u = a/|a| + sign e_0
  NodalChart::Node rest;
  rest.count = node.count - 1;
  for (unsigned int j = 1; j < node.count; ++j)
    for (unsigned int c = 0; c < 3; ++c)
    {
      double value = node.columns[3 * j + c];
      // H_ij = delta_ij - 2 u_i u_j/|u|^2, |u|^2 = 2 |first|
      for (unsigned int i = 0; i < node.count; ++i)
      {
        const double u_i = i == 0 ? first : along[i] / length;
        value -= u_i * (along[j] / length) / std::abs(first) * node.columns[3 * i + c];
      }
      rest.columns[3 * (j - 1) + c] = value;
    }
  return rest;
}

/** Interpolation of degree k - 1 from chosen local nodes of a cell to all of them. */
class LowerDegree
{
public:
  LowerDegree(const unsigned int degree, const unsigned int dimension)
      : k(degree)
      , dimension(dimension)
      , line(line_nodes(degree))
  {
  }

  std::size_t n_local() const { return dimension == 2 ? std::size_t(k + 1) * (k + 1) : k + 1; }

  /** Whether a local node has unknowns, given the numbers of the cell's nodes. */
  bool has_unknowns(const std::size_t *nodes, const std::size_t local) const
  {
    const std::size_t i = local % (k + 1), j = local / (k + 1);
    const bool inner_i = i != 0 && i != k;
    const bool inner_j = j != 0 && j != k;
    if (dimension == 1)
      return !inner_i || i != k - 1;
    if (inner_i && inner_j)
      return i != k - 1 && j != k - 1;
    if (!inner_i && !inner_j)
      return true;
    const std::size_t stride = inner_i ? 1 : k + 1, first = local - (inner_i ? i : j) * stride;
    std::size_t smallest = nodes[first + stride];
    for (std::size_t m = 2; m < k; ++m)
      smallest = std::min(smallest, nodes[first + m * stride]);
    return nodes[local] != smallest;
  }

  /** shares(i, m): of the m-th of `from` at local node i. */
  Eigen::MatrixXd shares(const std::vector<std::size_t> &from) const
  {
    const Eigen::Index n = static_cast<Eigen::Index>(from.size());
    Eigen::MatrixXd basis(static_cast<Eigen::Index>(n_local()), n), at_from(n, n);
    for (Eigen::Index i = 0; i < basis.rows(); ++i)
      for (Eigen::Index f = 0; f < n; ++f)
        basis(i, f) = function(f, static_cast<std::size_t>(i));
    for (Eigen::Index m = 0; m < n; ++m)
      at_from.row(m) = basis.row(static_cast<Eigen::Index>(from[m]));
    return basis * at_from.inverse();
  }

private:
  // Products of Chebyshev polynomials.
  double function(const Eigen::Index f, const std::size_t local) const
  {
    const double xi = line[local % (k + 1)];
    if (dimension == 1)
      return std::cos(static_cast<double>(f) * std::acos(xi));
    const double eta = line[local / (k + 1)];
    return std::cos(static_cast<double>(f % k) * std::acos(xi)) * std::cos(static_cast<double>(f / k) * std::acos(eta));
  }

  const std::size_t k;
  const unsigned int dimension;
  const std::vector<double> line;
};
} // namespace

NodalChart unit_vector_chart(const SurfaceDiscretization &discretization, const NodalVectors &values)
{
  NodalChart chart = surface_vector_chart(discretization);
  chart.unit_vectors.resize(discretization.n_nodes);
  for (std::size_t I = 0; I < discretization.n_nodes; ++I)
  {
    const Vector3<double> v = vector_at(values, I);
    chart.unit_vectors[I]   = {{v[0], v[1], v[2]}};
    if (chart.nodes[I].count > 0)
      chart.nodes[I] = orthogonal_to(chart.nodes[I], v);
  }
  return chart;
}

NodalChart lower_degree_chart(const SurfaceDiscretization &discretization)
{
  PELLICLE_ASSERT(discretization.degree >= 2, "a field of lower degree needs degree 2 of the surface");
  const LowerDegree lower(discretization.degree, discretization.kind == SurfaceDiscretization::Kind::surface ? 2 : 1);
  const NodalChart all = surface_vector_chart(discretization);
  NodalChart chart     = held_chart(discretization);
  chart.carriers.resize(discretization.n_nodes);
  std::vector<bool> done(discretization.n_nodes, false);
  for (std::size_t cell = 0; cell < discretization.n_cells; ++cell)
  {
    const std::size_t *const nodes = discretization.cell_nodes.data() + cell * lower.n_local();
    std::vector<std::size_t> from;
    for (std::size_t i = 0; i < lower.n_local(); ++i)
      if (lower.has_unknowns(nodes, i))
        from.push_back(i);
    const Eigen::MatrixXd shares = lower.shares(from);
    for (std::size_t i = 0; i < lower.n_local(); ++i)
    {
      if (done[nodes[i]])
        continue;
      done[nodes[i]] = true;
      if (std::binary_search(from.begin(), from.end(), i))
      {
        chart.nodes[nodes[i]] = all.nodes[nodes[i]];
        continue;
      }
      for (std::size_t m = 0; m < from.size(); ++m)
        if (const double share = shares(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(m));
            std::abs(share) > smallest_share)
          chart.carriers[nodes[i]].push_back({nodes[from[m]], {{share, share, share}}});
    }
  }
  return chart;
}

NodalChart chart_of_field(const SurfaceDiscretization &discretization, const Field &field,
                          const NodalVectors &positions, const NodalVectors &values, const NodalConditions &conditions)
{
  NodalChart chart;
  switch (field.space)
  {
  case FieldSpace::edge_conormals:
    chart = conormal_chart(discretization, positions, values);
    break;
  case FieldSpace::edge_scalars:
    chart = edge_scalar_chart(discretization);
    break;
  case FieldSpace::bulk_scalars:
    chart = bulk_scalar_chart(discretization);
    break;
  case FieldSpace::material_places:
    chart = held_chart(discretization);
    break;
  case FieldSpace::unit_vectors:
    chart = unit_vector_chart(discretization, values);
    break;
  case FieldSpace::lower_degree_vectors:
    chart = lower_degree_chart(discretization);
    break;
  case FieldSpace::vectors:
    chart = surface_vector_chart(discretization);
  }
  apply_conditions(conditions, field.name, chart);
  if (covers_surface(field))
    carry_hanging_nodes(discretization, chart);
  return chart;
}

bool chart_follows_values(const Field &field)
{
  return field.space == FieldSpace::edge_conormals || field.space == FieldSpace::unit_vectors;
}
} // namespace pellicle

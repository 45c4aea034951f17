// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/edge_frames.h>
#include <pellicle/assembly/hanging_carriers.h>
#include <pellicle/assembly/rim_directions.h>
#include <pellicle/base/constants.h>
#include <pellicle/discretization/admissible.h>
#include <pellicle/discretization/point_walk.h>

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace pellicle
{
namespace
{
constexpr double reach = 0.25; // l over the radius of a disc with the surface's area

/** Directions m at the nodes of lines that stay on bodies. */
std::map<std::size_t, Vector3<double>> directions_across(const FieldConditions &conditions,
                                                         const SurfaceDiscretization &discretization,
                                                         const NodalVectors &positions, const NodalVectors &normals)
{
  std::map<std::size_t, Vector3<double>> across;
  for (const auto &[node, t] : nodal_line_tangents(discretization, positions))
    if (node < conditions.body.size() && conditions.body[node])
    {
      const Vector3<double> m = cross(t, conditions.body[node]->gap(vector_at(positions, node)).normal);
      across[node]            = (std::copysign(1., dot(m, vector_at(normals, node))) / norm(m)) * m;
    }
  return across;
}

/** Matrix of l^2 grad . grad + 1 on the surface. */
Eigen::SparseMatrix<double> screened_laplacian(const SurfaceDiscretization &discretization,
                                               const NodalVectors &positions)
{
  const ShapeTables &tables = discretization.tables;
  const unsigned int n      = tables.n_nodes;
  const bool meridian       = discretization.kind == SurfaceDiscretization::Kind::meridian;
  double area               = 0.;
  for_all_points(tables, discretization.cell_nodes, positions, 3, [&](const WalkPoint &x) { area += x.area(); });
  const double l2 = reach * reach * area / pi;

  std::vector<Eigen::Triplet<double>> entries;
  std::vector<double> local(std::size_t(n) * n);
  const auto add_cell = [&](const WalkCell &cell)
  {
    std::fill(local.begin(), local.end(), 0.);
    for (unsigned int q = 0; q < tables.n_points; ++q)
    {
      const Vector3<double> x1 = cell[q][1], x2 = cell[q][2];
      const double dA = cell[q].area(), J2 = std::pow(norm(cross(x1, x2)), 2);
      // Inverse metric; on a meridian nothing depends on the second parameter.
      const double a11 = dot(x2, x2) / J2, a12 = meridian ? 0. : -dot(x1, x2) / J2,
                   a22 = meridian ? 0. : dot(x1, x1) / J2;
      const double *N  = tables.tables[0].data() + std::size_t(q) * n,
                   *N1 = tables.tables[1].data() + std::size_t(q) * n,
                   *N2 = tables.tables[2].data() + std::size_t(q) * n;
      for (unsigned int I = 0; I < n; ++I)
        for (unsigned int J = 0; J < n; ++J)
          local[I * n + J] +=
              dA *
              (N[I] * N[J] + l2 * (a11 * N1[I] * N1[J] + a12 * (N1[I] * N2[J] + N2[I] * N1[J]) + a22 * N2[I] * N2[J]));
    }
    for (unsigned int I = 0; I < n; ++I)
      for (unsigned int J = 0; J < n; ++J)
        entries.emplace_back(static_cast<int>(cell.nodes[I]), static_cast<int>(cell.nodes[J]), local[I * n + J]);
  };
  for_all_cells(tables, discretization.cell_nodes, positions, 3, add_cell);
  const auto size = static_cast<int>(discretization.n_nodes);
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/** Solutions with given values at the same nodes. */
struct Continuation
{
  Continuation(Eigen::SparseMatrix<double> matrix, std::vector<bool> nodes)
      : is_given(std::move(nodes))
  {
    matrix.prune([&](const Eigen::Index i, const Eigen::Index j, const double)
                 { return i == j || (!is_given[i] && !is_given[j]); });
    for (Eigen::Index i = 0; i < matrix.rows(); ++i)
      if (is_given[i])
        matrix.coeffRef(i, i) = 1.;
    factorised = std::make_unique<Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>>(matrix);
  }

  Eigen::VectorXd operator()(const Eigen::SparseMatrix<double> &matrix, const Eigen::VectorXd &given) const
  {
    Eigen::VectorXd right = -(matrix * given);
    for (Eigen::Index i = 0; i < right.size(); ++i)
      if (is_given[i])
        right[i] = given[i];
    return factorised->solve(right);
  }

  std::vector<bool> is_given;
  std::unique_ptr<Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>> factorised;
};
} // namespace

NodalVectors directions_towards_bodies(const FieldConditions &conditions, const SurfaceDiscretization &discretization,
                                       const NodalVectors &positions, const NodalVectors &normals)
{
  const NodalVectors at_edges = nodal_normals_at_edges(discretization, positions);
  const std::map<std::size_t, Vector3<double>> across =
      directions_across(conditions, discretization, positions, at_edges);
  if (across.empty())
    return normals;
  const Eigen::SparseMatrix<double> matrix = condensed(discretization, screened_laplacian(discretization, positions));
  const bool is_in_space                   = discretization.kind == SurfaceDiscretization::Kind::surface;
  std::vector<Continuation> continuations;
  Eigen::MatrixXd b(matrix.rows(), 3);
  for (unsigned int c = 0; c < 3; ++c)
  {
    std::vector<bool> is_given(static_cast<std::size_t>(matrix.rows()), false);
    for (std::size_t I = 0; I < discretization.admissible.size() && is_in_space; ++I)
      is_given[I] = !admits(discretization.admissible[I], c); // a plane of symmetry
    Eigen::VectorXd given = Eigen::VectorXd::Zero(matrix.rows());
    for (const auto &[node, m] : across)
    {
      is_given[node]                = true;
      given[static_cast<int>(node)] = m[c] - at_edges[3 * node + c];
    }
    if (continuations.empty() || continuations.back().is_given != is_given)
      continuations.emplace_back(matrix, std::move(is_given));
    b.col(c) = continuations.back()(matrix, given);
  }

  NodalVectors directions = normals;
  for (std::size_t I = 0; I < discretization.n_nodes; ++I)
  {
    const auto row            = static_cast<int>(I);
    const Vector3<double> sum = admissible_part(
        admissible_at(discretization, I), vector_at(normals, I) + Vector3<double>(b(row, 0), b(row, 1), b(row, 2)));
    for (unsigned int c = 0; c < 3; ++c)
      directions[3 * I + c] = sum[c] / norm(sum);
  }
  return directions;
}
} // namespace pellicle

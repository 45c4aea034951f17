// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/hanging_carriers.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/edge_loops.h>
#include <pellicle/discretization/point_walk.h>
#include <pellicle/kinematics/surface_point.h>
#include <pellicle/models/nodal_curvature.h>

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <array>
#include <vector>

namespace pellicle
{
namespace
{
struct WeakForms
{
  Eigen::SparseMatrix<double> mass; ///< scalar
  Eigen::MatrixX3d laplacian;       ///< integral of a^ab x_,a . y_,b: row = node of y, column = component of y
  Eigen::VectorXd gauss;            ///< integral of K y
};

/** m^T v of a row-major matrix. */
Vector3<double> transposed_times(const std::array<double, 9> &m, const Vector3<double> &v)
{
  Vector3<double> result;
  for (unsigned int c = 0; c < 3; ++c)
    result[c] = m[c] * v[0] + m[3 + c] * v[1] + m[6 + c] * v[2];
  return result;
}

// Where the surface ends, the curvature vector h is the integral of a^ab x,a . y,b less that of nu . y over the rim.
void subtract_rim(const SurfaceDiscretization &discretization, const EdgeLoop &rim, const NodalVectors &positions,
                  Eigen::MatrixX3d &laplacian)
{
  const ShapeTables &tables             = rim.tables;
  const std::vector<Vector3<double>> nu = conormals(discretization, rim, positions);
  const auto subtract                   = [&](const WalkCell &edge)
  {
    for (unsigned int q = 0; q < tables.n_points; ++q)
    {
      const double ds               = edge[q].weight * norm(edge[q][1]);
      const Vector3<double> &normal = nu[edge.number * tables.n_points + q];
      for (unsigned int I = 0; I < tables.n_nodes; ++I)
      {
        const double value = ds * tables.tables[0][std::size_t(q) * tables.n_nodes + I];
        for (unsigned int c = 0; c < 3; ++c)
          laplacian(edge.nodes[I], c) -= value * normal[c];
      }
    }
  };
  for_all_cells(tables, rim.cell_nodes, positions, 2, subtract);
}

WeakForms assemble(const SurfaceDiscretization &discretization, const NodalVectors &positions)
{
  const ShapeTables &tables = discretization.tables;
  const unsigned int n      = tables.n_nodes;
  const auto N              = static_cast<Eigen::Index>(discretization.n_nodes);
  WeakForms forms{Eigen::SparseMatrix<double>(N, N), Eigen::MatrixX3d::Zero(N, 3), Eigen::VectorXd::Zero(N)};

  std::vector<Eigen::Triplet<double>> entries;
  std::vector<double> cell_mass(std::size_t(n) * n);
  entries.reserve(discretization.n_cells * cell_mass.size());
  const auto add_cell = [&](const WalkCell &cell)
  {
    const std::size_t *const nodes = cell.nodes;
    std::fill(cell_mass.begin(), cell_mass.end(), 0.);
    for (unsigned int q = 0; q < tables.n_points; ++q)
    {
      const WalkPoint x = cell[q];
      const SurfacePoint<double> point(x[1], x[2], x[3], x[4], x[5]);
      const double dA = x.weight * point.jacobian;
      for (unsigned int I = 0; I < n; ++I)
      {
        const auto row     = [&](const unsigned int slot) { return tables.tables[slot][std::size_t(q) * n + I]; };
        const double value = row(0);
        for (unsigned int J = 0; J < n; ++J)
          cell_mass[I * n + J] += dA * value * tables.tables[0][std::size_t(q) * n + J];
        for (unsigned int b = 0; b < 2; ++b)
        {
          const Vector3<double> at_node = (dA * row(1 + b)) * transposed_times(tables.map[1 + b], point.dual[b]);
          for (unsigned int c = 0; c < 3; ++c)
            forms.laplacian(nodes[I], c) += at_node[c];
        }
        forms.gauss[nodes[I]] += dA * point.gauss_curvature * value;
      }
    }
    for (unsigned int I = 0; I < n; ++I)
      for (unsigned int J = 0; J < n; ++J)
        entries.emplace_back(nodes[I], nodes[J], cell_mass[I * n + J]);
  };
  for_all_cells(tables, discretization.cell_nodes, positions, 6, add_cell);
  forms.mass.setFromTriplets(entries.begin(), entries.end());
  for (const EdgeLoop &rim : discretization.edges)
    if (rim.is_rim)
      subtract_rim(discretization, rim, positions, forms.laplacian);
  return forms;
}

/** Nodes at which a vector may have component c. Admissible directions here are always coordinate axes. */
std::vector<bool> free_nodes(const SurfaceDiscretization &discretization, const unsigned int c)
{
  std::vector<bool> result(discretization.n_nodes, true);
  for (std::size_t I = 0; I < discretization.admissible.size(); ++I)
  {
    const AdmissibleDirections &d = discretization.admissible[I];
    result[I] =
        std::any_of(d.columns.begin(), d.columns.begin() + d.count,
                    [&](const std::array<double, 3> &column)
                    {
                      PELLICLE_ASSERT(column[c] == 0. || column[c] == 1., "admissible directions are coordinate axes");
                      return column[c] == 1.;
                    });
  }
  return result;
}

using Factorization = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;

void factorize(Factorization &factorization, const Eigen::SparseMatrix<double> &mass)
{
  factorization.compute(mass);
  if (factorization.info() != Eigen::Success)
    throw SolveError("The curvature cannot be computed: the mass matrix of the surface is singular. A cell has "
                     "collapsed; use a finer mesh or "
                     "smaller steps.");
}

/** Solves for one component that must vanish at the other nodes: their rows and columns become those of the identity.
 */
Eigen::VectorXd solve_constrained(Eigen::SparseMatrix<double> mass, Eigen::VectorXd right_hand_side,
                                  const std::vector<bool> &is_free)
{
  for (Eigen::Index j = 0; j < mass.outerSize(); ++j)
  {
    if (!is_free[j])
      right_hand_side[j] = 0.;
    for (Eigen::SparseMatrix<double>::InnerIterator entry(mass, j); entry; ++entry)
      if (!is_free[entry.row()] || !is_free[j])
        entry.valueRef() = entry.row() == j ? 1. : 0.;
  }
  Factorization factorization;
  factorize(factorization, mass);
  return factorization.solve(right_hand_side);
}

/** Integral of (h . n/2) y for every scalar shape function y. */
Eigen::VectorXd normal_part(const SurfaceDiscretization &discretization, const NodalVectors &positions,
                            const NodalVectors &curvature_vector)
{
  const ShapeTables &tables = discretization.tables;
  std::vector<double> h(std::size_t(tables.n_points) * 18);
  Eigen::VectorXd result = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(discretization.n_nodes));
  const auto add         = [&](const WalkPoint &x)
  {
    if (x.q == 0)
      evaluate_field(tables, x.nodes, curvature_vector, 1, h.data());
    const double *const at = &h[18 * x.q];
    const double half      = 0.5 * x.weight * dot(Vector3<double>(at[0], at[1], at[2]), cross(x[1], x[2]));
    for (unsigned int I = 0; I < tables.n_nodes; ++I)
      result[x.nodes[I]] += half * tables.tables[0][std::size_t(x.q) * tables.n_nodes + I];
  };
  for_all_points(tables, discretization.cell_nodes, positions, 3, add);
  return result;
}
} // namespace

NodalCurvature nodal_curvature(const SurfaceDiscretization &discretization, const NodalVectors &positions)
{
  const std::size_t n_nodes           = discretization.n_nodes;
  const Eigen::SparseMatrix<double> P = hanging_prolongation(discretization);
  WeakForms forms                     = assemble(discretization, positions);
  forms.mass                          = condensed(discretization, forms.mass);
  forms.laplacian                     = P.transpose() * forms.laplacian;
  forms.gauss                         = P.transpose() * forms.gauss;
  Factorization factorization;
  factorize(factorization, forms.mass);

  NodalCurvature result;
  result.curvature_vector.assign(3 * n_nodes, 0.);
  for (unsigned int c = 0; c < 3; ++c)
  {
    const std::vector<bool> is_free = free_nodes(discretization, c);
    if (std::none_of(is_free.begin(), is_free.end(), [](const bool node) { return node; }))
      continue;
    const bool all             = std::all_of(is_free.begin(), is_free.end(), [](const bool node) { return node; });
    const Eigen::VectorXd load = forms.laplacian.col(c);
    const Eigen::VectorXd of_free =
        all ? Eigen::VectorXd(factorization.solve(load)) : solve_constrained(forms.mass, load, is_free);
    const Eigen::VectorXd h = P * of_free;
    for (std::size_t I = 0; I < n_nodes; ++I)
      result.curvature_vector[3 * I + c] = h[I];
  }

  const Eigen::VectorXd projected = P.transpose() * normal_part(discretization, positions, result.curvature_vector);
  const Eigen::VectorXd H         = P * Eigen::VectorXd(factorization.solve(projected));
  result.mean_outward.assign(H.data(), H.data() + H.size());
  const Eigen::VectorXd K = P * Eigen::VectorXd(factorization.solve(forms.gauss));
  result.gauss.assign(K.data(), K.data() + K.size());
  return result;
}

double integrated_mean_curvature(const SurfaceDiscretization &discretization, const NodalVectors &positions,
                                 const NodalVectors &curvature_vector)
{
  return normal_part(discretization, positions, curvature_vector).sum(); // the shape functions add up to 1
}
} // namespace pellicle

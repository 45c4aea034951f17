// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/hanging_carriers.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/refined_quads.h>
#include <pellicle/models/error_indicators.h>

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace pellicle
{
namespace
{
/** Projection of nodal values of degree k on polynomials of degree m < k along a line, by Legendre's. */
Eigen::MatrixXd onto_degree(const unsigned int k, const unsigned int m)
{
  const std::vector<double> nodes = line_nodes(k);
  Eigen::MatrixXd legendre(k + 1, k + 1);
  for (unsigned int i = 0; i <= k; ++i)
  {
    legendre(i, 0) = 1.;
    legendre(i, 1) = nodes[i];
    for (unsigned int j = 2; j <= k; ++j)
      legendre(i, j) = ((2. * j - 1.) * nodes[i] * legendre(i, j - 1) - (j - 1.) * legendre(i, j - 2)) / j;
  }
  Eigen::MatrixXd kept = legendre;
  kept.rightCols(k - m).setZero();
  return kept * legendre.inverse();
}

Eigen::MatrixXd tensor_square(const Eigen::MatrixXd &a)
{
  const Eigen::Index n = a.rows();
  Eigen::MatrixXd result(n * n, n * n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      result.block(i * n, j * n, n, n) = a(i, j) * a;
  return result;
}

/** What a cell's nodal values have of the highest degree, and of the one below. */
struct Parts
{
  Eigen::MatrixXd highest, below;

  explicit Parts(const SurfaceDiscretization &surface)
  {
    const unsigned int k    = surface.degree;
    Eigen::MatrixXd to_less = onto_degree(k, k - 1), to_least = onto_degree(k, k - 2);
    if (surface.kind == SurfaceDiscretization::Kind::surface)
    {
      to_less  = tensor_square(to_less);
      to_least = tensor_square(to_least);
    }
    highest = Eigen::MatrixXd::Identity(to_less.rows(), to_less.cols()) - to_less;
    below   = to_less - to_least;
  }
};

/** What is integrated of a part of a field: squares of its slots at a point with the given tangents. */
enum class Measure
{
  value,
  gradient,
  normal_gradient
};

double square(const Measure measure, const double *const x, const double *const part)
{
  const auto vector = [](const double *const slots, const unsigned int s)
  { return Vector3<double>(slots[3 * s], slots[3 * s + 1], slots[3 * s + 2]); };
  if (measure == Measure::value)
    return dot(vector(part, 0), vector(part, 0));
  const Vector3<double> x1 = vector(x, 1), x2 = vector(x, 2), N = cross(x1, x2), f1 = vector(part, 1),
                        f2 = vector(part, 2);
  const double J2          = dot(N, N);
  const auto along         = [&](const Vector3<double> &f, const Vector3<double> &g)
  { return measure == Measure::gradient ? dot(f, g) : dot(f, N) * dot(g, N) / J2; };
  return (dot(x2, x2) * along(f1, f1) - 2. * dot(x1, x2) * along(f1, f2) + dot(x1, x1) * along(f2, f2)) / J2;
}

/** The parts of one cell, integrated. */
class CellIntegral
{
public:
  CellIntegral(const SurfaceDiscretization &discretization, const NodalVectors &all_positions)
      : surface(discretization)
      , tables(discretization.tables)
      , positions(all_positions)
      , local(tables.n_nodes)
      , x(18 * std::size_t(tables.n_points))
      , inputs(x.size())
  {
    std::iota(local.begin(), local.end(), std::size_t(0));
  }

  double operator()(const std::size_t cell, const Measure measure, const Eigen::MatrixXd &part,
                    const NodalVectors &values)
  {
    const std::size_t *const nodes = surface.cell_nodes.data() + cell * tables.n_nodes;
    NodalVectors of_part(3 * std::size_t(tables.n_nodes), 0.);
    for (unsigned int i = 0; i < tables.n_nodes; ++i)
      for (unsigned int j = 0; j < tables.n_nodes; ++j)
        for (unsigned int c = 0; c < 3; ++c)
          of_part[3 * i + c] += part(i, j) * values[3 * nodes[j] + c];
    evaluate_field(tables, nodes, positions, 3, x.data());
    evaluate_field(tables, local.data(), of_part, 3, inputs.data());
    double sum = 0.;
    for (unsigned int q = 0; q < tables.n_points; ++q)
    {
      const double *const at = x.data() + 18 * std::size_t(q);
      const double J         = norm(cross(Vector3<double>(at[3], at[4], at[5]), Vector3<double>(at[6], at[7], at[8])));
      sum += tables.weights[q] * J * square(measure, at, inputs.data() + 18 * std::size_t(q));
    }
    return sum;
  }

private:
  const SurfaceDiscretization &surface;
  const ShapeTables &tables;
  const NodalVectors &positions;
  std::vector<std::size_t> local;
  std::vector<double> x, inputs;
};

bool counts(const Field &field)
{
  return field.role != FieldRole::multiplier &&
         (field.space == FieldSpace::vectors || field.space == FieldSpace::unit_vectors);
}

Measure measure_of(const Field &field)
{
  return field.name == "position"            ? Measure::normal_gradient
         : field.role == FieldRole::internal ? Measure::value
                                             : Measure::gradient;
}
} // namespace

std::vector<double> error_indicators(const SurfaceProblem &problem)
{
  const SurfaceDiscretization &surface = problem.discretization();
  const FieldValues &values            = problem.state().fields;
  const Parts parts(surface);
  CellIntegral integral(surface, values[0]);
  std::vector<double> indicators(surface.n_cells, 0.);
  for (std::size_t f = 0; f < values.size(); ++f)
    if (const Field &field = problem.layout().fields()[f]; counts(field))
      for (std::size_t cell = 0; cell < surface.n_cells; ++cell)
      {
        const double highest = integral(cell, measure_of(field), parts.highest, values[f]),
                     below   = integral(cell, measure_of(field), parts.below, values[f]);
        indicators[cell] += highest < below ? highest * (highest / below) : highest;
      }
  return indicators;
}

WorstCells cells_with_most(const double fraction, const std::vector<double> &indicators,
                           const std::vector<CellPlace> &places)
{
  constexpr double alike = 1e-3; // relative difference of what symmetry makes equal
  PELLICLE_ASSERT(fraction > 0. && fraction < 1. && indicators.size() == places.size(), "one indicator for each cell");
  std::vector<std::size_t> order(indicators.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](const std::size_t a, const std::size_t b) { return indicators[a] > indicators[b]; });
  const double total = std::accumulate(indicators.begin(), indicators.end(), 0.);
  double left = fraction * total, last = 0.;
  WorstCells worst;
  for (const std::size_t cell : order)
  {
    if (left <= 0. && indicators[cell] < (1. - alike) * last)
      break;
    if (left > 0.)
      last = indicators[cell];
    left -= indicators[cell];
    worst.places.push_back(places[cell]);
  }
  worst.share = total > 0. ? fraction - left / total : 0.;
  return worst;
}
} // namespace pellicle

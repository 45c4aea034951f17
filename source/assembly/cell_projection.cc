// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/cell_projection.h>
#include <pellicle/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace pellicle
{
namespace
{
using Tensor = SymmetricSurfaceTensor<double>;

/** A derivative of the position: `orders[a]` times with respect to parameter a. */
Vector3<double> derivative(const CellShape &cell, const std::array<LagrangeLine::Values, 2> &lines,
                           const std::array<unsigned int, 2> &orders)
{
  const std::size_t n = cell.line.degree() + 1;
  Vector3<double> sum;
  for (std::size_t j = 0; j < n; ++j)
  {
    Vector3<double> row;
    for (std::size_t i = 0; i < n; ++i)
      row += lines[0][orders[0]][i] * cell.nodes[j * n + i];
    sum += lines[1][orders[1]][j] * row;
  }
  return sum;
}

/** Half the squared distance as a function of the parameters, and its derivatives. */
struct Distance
{
  Distance(const Vector3<double> &x, const CellShape &cell, const std::array<double, 2> &xi)
      : lines{{cell.line.at(xi[0]), cell.line.at(xi[1])}}
      , foot(derivative(cell, lines, {{0, 0}}))
      , r(x - foot)
  {
  }

  double value() const { return 0.5 * dot(r, r); }

  void differentiate(const CellShape &cell)
  {
    base = {{derivative(cell, lines, {{1, 0}}), derivative(cell, lines, {{0, 1}})}};
    const Tensor bend(dot(r, derivative(cell, lines, {{2, 0}})), dot(r, derivative(cell, lines, {{1, 1}})),
                      dot(r, derivative(cell, lines, {{0, 2}})));
    for (unsigned int a = 0; a < 2; ++a)
    {
      pull[a] = dot(r, base[a]);
      for (unsigned int b = a; b < 2; ++b)
      {
        metric(a, b)  = dot(base[a], base[b]);
        hessian(a, b) = metric(a, b) - bend(a, b);
      }
    }
  }

  std::array<LagrangeLine::Values, 2> lines;
  Vector3<double> foot, r;
  FirstDerivatives<double> base;
  std::array<double, 2> pull{}; ///< minus the gradient, f_a of (18)
  Tensor metric, hessian;
};

/** Solves on the free parameters; zero for the others. */
std::array<double, 2> solve(const Tensor &m, const std::array<double, 2> &f, const std::array<bool, 2> &free)
{
  if (free[0] && free[1])
  {
    const double det = determinant(m);
    return {{(m(1, 1) * f[0] - m(0, 1) * f[1]) / det, (m(0, 0) * f[1] - m(0, 1) * f[0]) / det}};
  }
  return {{free[0] ? f[0] / m(0, 0) : 0., free[1] ? f[1] / m(1, 1) : 0.}};
}

bool is_positive(const Tensor &m, const std::array<bool, 2> &free)
{
  return (!free[0] || m(0, 0) > 0.) && (!free[1] || m(1, 1) > 0.) && (!free[0] || !free[1] || determinant(m) > 0.);
}

/** Whether a parameter at a bound is pushed beyond it by a change. */
bool leaves(const double xi, const double change)
{
  return (xi <= 0. && change < 0.) || (xi >= 1. && change > 0.);
}

/** Newton's or the Gauss-Newton step; parameters that it would push out of bounds at once are held instead. */
std::array<double, 2> step_from(const Distance &d, const std::array<double, 2> &xi, std::array<bool, 2> free)
{
  for (;;)
  {
    const std::array<double, 2> step = solve(is_positive(d.hessian, free) ? d.hessian : d.metric, d.pull, free);
    bool held                        = false;
    for (unsigned int a = 0; a < 2; ++a)
      if (free[a] && leaves(xi[a], step[a]))
      {
        free[a] = false;
        held    = true;
      }
    if (!held)
      return step;
  }
}

/** Largest part, at most 1, of a step within bounds. */
double room(const std::array<double, 2> &xi, const std::array<double, 2> &step)
{
  double part = 1.;
  for (unsigned int a = 0; a < 2; ++a)
    if (step[a] != 0.)
      part = std::min(part, ((step[a] > 0. ? 1. : 0.) - xi[a]) / step[a]);
  return part;
}

std::array<double, 2> nearest_node(const Vector3<double> &x, const CellShape &cell)
{
  const std::vector<double> &points = cell.line.points();
  std::array<double, 2> xi{};
  double nearest = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < cell.n_nodes(); ++i)
  {
    const double distance = norm(x - cell.nodes[i]);
    if (distance < nearest)
    {
      nearest = distance;
      xi      = {{points[i % points.size()], points[i / points.size()]}};
    }
  }
  return xi;
}
} // namespace

CellProjection project_on_cell(const Vector3<double> &x, const CellShape &cell)
{
  constexpr unsigned int most_iterations = 100;
  constexpr double flat = 1e-9, converged = 1e-13, almost_converged = 1e-7;
  CellProjection result;
  std::array<double, 2> &xi = result.xi = nearest_node(x, cell);
  Distance now(x, cell, xi);
  for (unsigned int iteration = 0; iteration < most_iterations; ++iteration)
  {
    now.differentiate(cell);
    for (unsigned int a = 0; a < 2; ++a)
      result.free[a] = !leaves(xi[a], std::abs(now.pull[a]) > flat * now.metric(a, a) ? now.pull[a] : 0.);
    const std::array<double, 2> step = step_from(now, xi, result.free);
    const double length              = std::max(std::abs(step[0]), std::abs(step[1]));
    const double digits = 4. * std::numeric_limits<double>::epsilon() * (now.value() + norm(now.r) * norm(x));

    double part        = room(xi, step);
    const double slope = now.pull[0] * step[0] + now.pull[1] * step[1], before = now.value();
    if (length > converged)
      for (bool lower = false; !lower; part *= 0.5)
      {
        std::array<double, 2> next;
        for (unsigned int a = 0; a < 2; ++a)
          next[a] = std::min(1., std::max(0., xi[a] + part * step[a]));
        const Distance ahead(x, cell, next);
        lower = ahead.value() <= before - 1e-4 * part * slope + digits || part < 1e-12;
        if (lower)
        {
          xi  = next;
          now = ahead;
        }
      }
    if (length <= converged || (length <= almost_converged && before - now.value() <= digits))
    {
      now.differentiate(cell);
      result.foot     = now.foot;
      result.outward  = cross(now.base[0], now.base[1]);
      result.distance = norm(now.r);
      return result;
    }
  }
  throw SolveError("The closest point to (" + std::to_string(x[0]) + ", " + std::to_string(x[1]) + ", " +
                   std::to_string(x[2]) + ") in a cell was not found: the point is near the cell's centre of " +
                   "curvature, or the cell is degenerate.");
}

MasterPoint master_point(const CellShape &cell, const CellProjection &at)
{
  const std::array<LagrangeLine::Values, 2> lines{{cell.line.at(at.xi[0]), cell.line.at(at.xi[1])}};
  std::vector<unsigned int> free;
  for (unsigned int a = 0; a < 2; ++a)
    if (at.free[a])
      free.push_back(a);
  const auto orders = [&](const std::vector<unsigned int> &parameters)
  {
    std::array<unsigned int, 2> times{};
    for (const unsigned int a : parameters)
      ++times[free[a]];
    return times;
  };
  const auto shapes = [&](const std::array<unsigned int, 2> &times)
  {
    const std::size_t n = cell.line.degree() + 1;
    std::vector<double> m;
    for (std::size_t i = 0; i < n * n; ++i)
      m.push_back(lines[0][times[0]][i % n] * lines[1][times[1]][i / n]);
    return m;
  };

  MasterPoint p;
  p.n_parameters = free.size();
  p.x            = at.foot;
  p.outward      = at.outward;
  p.values       = shapes({});
  for (unsigned int a = 0; a < p.n_parameters; ++a)
  {
    p.first[a]        = derivative(cell, lines, orders({a}));
    p.first_values[a] = shapes(orders({a}));
    for (unsigned int b = a; b < p.n_parameters; ++b)
    {
      p.second(a, b)         = derivative(cell, lines, orders({a, b}));
      p.second_values[a + b] = shapes(orders({a, b}));
      for (unsigned int c = b; c < p.n_parameters; ++c)
        p.third[a + b + c] = derivative(cell, lines, orders({a, b, c}));
    }
  }
  return p;
}
} // namespace pellicle

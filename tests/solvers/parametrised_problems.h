// SPDX-License-Identifier: LGPL-2.1-or-later
// Small problems with a parameter, for continuation: stationary points of E(x; p), also under g(x) = p.
#pragma once

#include "synthetic_matrices.h"

#include <pellicle/solvers/parametrised_problem.h>

#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace pellicle::synthetic
{
using Vector = std::vector<double>;
using Rows   = std::vector<Vector>;

/** E(x; p) with its derivatives; `mixed` is that of the gradient with respect to p. */
struct Energy
{
  std::function<double(const Vector &, double)> value;
  std::function<Vector(const Vector &, double)> gradient;
  std::function<Rows(const Vector &, double)> hessian;
  std::function<Vector(const Vector &, double)> mixed;
};

/** Stationary points of an energy, under a linear constraint a.x = p if there is one; its multiplier is the last
 * unknown. */
class BranchProblem : public ParametrisedProblem
{
public:
  BranchProblem(Energy energy_, Vector start, const double start_parameter)
      : e(std::move(energy_))
      , x(std::move(start))
      , p(start_parameter)
  {
  }

  void linearize() override
  {
    const std::size_t n = x.size(), size = n + (constraint.empty() ? 0 : 1);
    const Rows H = e.hessian(x, p);
    MatrixBuilder builder(symmetry, int(size));
    r.assign(size, 0.);
    const Vector g = gradient();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
      {
        r[i] += axis(j, i) * g[j];
        double sum = 0.;
        for (std::size_t k = 0; k < n; ++k)
          for (std::size_t l = 0; l < n; ++l)
            sum += axis(k, i) * H[k][l] * axis(l, j);
        builder.add(int(i), int(j), sum);
      }
    if (!constraint.empty())
    {
      for (std::size_t i = 0; i < n; ++i)
      {
        double sum = 0.;
        for (std::size_t k = 0; k < n; ++k)
          sum += constraint[k] * axis(k, i);
        builder.add(int(n), int(i), sum);
        builder.add(int(i), int(n), sum);
      }
      builder.add(int(n), int(n), 0.);
      r[n] = violation(x);
    }
    sparse = builder.matrix();
  }
  const SparseMatrix &matrix() const override { return sparse; }
  const Vector &residual() const override { return r; }
  double relative_residual() const override
  {
    double sum = 0.;
    for (const double ri : r)
      sum += ri * ri;
    return std::sqrt(sum);
  }
  double constraint_violation() const override { return constraint.empty() ? 0. : std::abs(violation(x)); }
  void add_drag(const double zeta) override
  {
    for (int i = 0; i < int(x.size()); ++i)
      for (int k = sparse.row_start[i]; k < sparse.row_start[i + 1]; ++k)
        if (sparse.columns[k] == i)
          sparse.values[k] += zeta;
  }
  bool is_variational() const override { return true; }
  int expected_negative_pivots() const override { return constraint.empty() ? 0 : 1; }
  double merit_slope(const Vector &direction) const override
  {
    double slope = 0.;
    for (std::size_t i = 0; i < x.size(); ++i)
      slope += r[i] * direction[i];
    return slope;
  }
  double merit(const Vector &) const override { return e.value(x, p); }
  double try_step(const Vector &direction, const double length) override
  {
    trial = x;
    for (std::size_t i = 0; i < x.size(); ++i)
      for (std::size_t j = 0; j < x.size(); ++j)
        trial[i] += length * axis(i, j) * direction[j];
    trial_lambda = lambda + (constraint.empty() ? 0. : direction.back());
    return makes_sense(trial) ? e.value(trial, p) : std::numeric_limits<double>::infinity();
  }
  void accept_trial() override
  {
    x      = trial;
    lambda = trial_lambda;
  }
  double displacement(const Vector &direction) const override
  {
    double largest = 0.;
    for (std::size_t i = 0; i < x.size(); ++i)
      largest = std::max(largest, std::abs(direction[i]));
    return largest;
  }
  double energy() const override { return e.value(x, p); }

  double parameter() const override { return p; }
  void set_parameter(const double value) override { p = value; }
  Vector residual_derivative() override
  {
    Vector derivative(r.size(), 0.);
    const Vector m = e.mixed(x, p);
    for (std::size_t i = 0; i < x.size(); ++i)
      for (std::size_t j = 0; j < x.size(); ++j)
        derivative[i] += axis(j, i) * m[j];
    if (!constraint.empty())
      derivative.back() = -1.;
    return derivative;
  }
  Vector weights() const override
  {
    Vector w(x.size(), 1.);
    if (!constraint.empty())
      w.push_back(0.);
    return w;
  }
  double parameter_scale() const override { return scale; }
  bool begin_step() override
  {
    ++steps_begun;
    angle += turn_of_chart;
    return turn_of_chart != 0.;
  }
  void remember() override { kept = {x, p, lambda, angle}; }
  void recall() override
  {
    x      = kept.x;
    p      = kept.p;
    lambda = kept.lambda;
    angle  = kept.angle;
  }

  Vector gradient() const
  {
    Vector g = e.gradient(x, p);
    for (std::size_t i = 0; i < constraint.size(); ++i)
      g[i] += lambda * constraint[i];
    return g;
  }

  Energy e;
  Vector x;
  double p = 0., lambda = 0., scale = 1.;
  Vector constraint; ///< a; empty: none, and p is a parameter of the energy only
  MatrixSymmetry symmetry                         = MatrixSymmetry::symmetric;
  std::function<bool(const Vector &)> makes_sense = [](const Vector &) { return true; };
  double turn_of_chart = 0.; ///< the first two unknowns are coordinates in axes that turn so far at each step
  int steps_begun      = 0;

private:
  struct Kept
  {
    Vector x;
    double p, lambda, angle;
  };

  double violation(const Vector &y) const
  {
    double sum = -p;
    for (std::size_t i = 0; i < y.size(); ++i)
      sum += constraint[i] * y[i];
    return sum;
  }
  /** dx_i/du_j */
  double axis(const std::size_t i, const std::size_t j) const
  {
    if (turn_of_chart == 0. || i > 1 || j > 1)
      return i == j ? 1. : 0.;
    return i == j ? std::cos(angle) : (i < j ? -std::sin(angle) : std::sin(angle));
  }

  SparseMatrix sparse;
  Vector r, trial;
  double trial_lambda = 0., angle = 0.;
  Kept kept;
};

/** x^4/4 - x^2/2 - p x + (y - x)^2/2: on p = x^3 - x, y = x; folds at x = -+1/sqrt(3), p = +-2/(3 sqrt(3)). */
inline Energy s_curve()
{
  return {[](const Vector &x, const double p)
          { return std::pow(x[0], 4) / 4. - x[0] * x[0] / 2. - p * x[0] + std::pow(x[1] - x[0], 2) / 2.; },
          [](const Vector &x, const double p) {
            return Vector{std::pow(x[0], 3) - x[0] - p - (x[1] - x[0]), x[1] - x[0]};
          },
          [](const Vector &x, double) {
            return Rows{{3. * x[0] * x[0], -1.}, {-1., 1.}};
          },
          [](const Vector &, double) {
            return Vector{-1., 0.};
          }};
}

/** x^3/3 - (1 - p^2) x: on the circle x^2 + p^2 = 1, nowhere beyond |p| = 1. */
inline Energy circle()
{
  return {[](const Vector &x, const double p) { return std::pow(x[0], 3) / 3. - (1. - p * p) * x[0]; },
          [](const Vector &x, const double p) { return Vector{x[0] * x[0] + p * p - 1.}; },
          [](const Vector &x, double) { return Rows{{2. * x[0]}}; },
          [](const Vector &, const double p) { return Vector{2. * p}; }};
}

/**
 * Two bars of stiffness one and natural length L0 = sqrt(a^2 + h^2) from (-+a, 0) to the apex (v, h - w), and a load p
 * downwards on it (von Mises truss). On the symmetric path, u = h - w and L^2 = a^2 + u^2: p = 2 u (L0/L - 1).
 */
struct Truss
{
  double a, h;

  double natural_length() const { return std::hypot(a, h); }
  double load(const double u) const { return 2. * u * (natural_length() / std::hypot(a, u) - 1.); }
  /** dp/du = 0 at L^3 = L0 a^2. */
  double height_at_limit() const { return std::sqrt(std::pow(natural_length() * a * a, 2. / 3.) - a * a); }

  Energy energy() const
  {
    const Truss t         = *this;
    const auto horizontal = [t](const Vector &x, const int bar) { return bar == 0 ? t.a + x[0] : x[0] - t.a; };
    return {[=](const Vector &x, const double p)
            {
              double sum = -p * x[1];
              for (const int bar : {0, 1})
                sum += 0.5 * std::pow(std::hypot(horizontal(x, bar), t.h - x[1]) - t.natural_length(), 2);
              return sum;
            },
            [=](const Vector &x, const double p)
            {
              Vector g{0., -p};
              for (const int bar : {0, 1})
              {
                const double s = horizontal(x, bar), u = t.h - x[1];
                const double pull = 1. - t.natural_length() / std::hypot(s, u);
                g[0] += pull * s;
                g[1] -= pull * u;
              }
              return g;
            },
            [=](const Vector &x, double)
            {
              Rows H{{0., 0.}, {0., 0.}};
              for (const int bar : {0, 1})
              {
                const double s = horizontal(x, bar), u = t.h - x[1], L = std::hypot(s, u);
                const double pull = 1. - t.natural_length() / L, change = t.natural_length() / (L * L * L);
                H[0][0] += pull + change * s * s;
                H[1][1] += pull + change * u * u;
                H[0][1] -= change * s * u;
                H[1][0] -= change * s * u;
              }
              return H;
            },
            [](const Vector &, double) {
              return Vector{0., -1.};
            }};
  }
};

/** x^4/4 - p x^2/2 + (y - p)^2/2: y = p, and x = 0 or (from p = 0 on) x = -+sqrt(p). */
inline Energy pitchfork()
{
  return {[](const Vector &x, const double p)
          { return std::pow(x[0], 4) / 4. - p * x[0] * x[0] / 2. + std::pow(x[1] - p, 2) / 2.; },
          [](const Vector &x, const double p) {
            return Vector{std::pow(x[0], 3) - p * x[0], x[1] - p};
          },
          [](const Vector &x, const double p) {
            return Rows{{3. * x[0] * x[0] - p, 0.}, {0., 1.}};
          },
          [](const Vector &x, double) {
            return Vector{-x[0], -1.};
          }};
}

/** x^4/4 - x^2/2 + y^2/4, to be used with x + y = p: multiplier -y/2, and p = 2 x^3 - x, which folds at x^2 = 1/6. */
inline Energy two_springs()
{
  return {[](const Vector &x, double) { return std::pow(x[0], 4) / 4. - x[0] * x[0] / 2. + x[1] * x[1] / 4.; },
          [](const Vector &x, double) {
            return Vector{std::pow(x[0], 3) - x[0], x[1] / 2.};
          },
          [](const Vector &x, double) {
            return Rows{{3. * x[0] * x[0] - 1., 0.}, {0., 0.5}};
          },
          [](const Vector &, double) {
            return Vector{0., 0.};
          }};
}
} // namespace pellicle::synthetic

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/models/largest_value.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace pellicle
{
namespace
{
/** f in the parameters of a cell. */
struct LocalModel
{
  double value = 0.;
  std::array<double, 2> gradient{};
  std::array<double, 3> hessian{}; ///< 11, 12, 22
};

LocalModel model_at(const CellGeometry &geometry, const QuadraticFunction &f, const CellSite &site)
{
  const CellPoint p       = geometry.at(site);
  const Vector3<double> g = f.gradient(p.x);
  const auto q            = [&](const Vector3<double> &a, const Vector3<double> &b)
  { return f.diagonal[0] * a[0] * b[0] + f.diagonal[1] * a[1] * b[1] + f.diagonal[2] * a[2] * b[2]; };
  LocalModel model;
  model.value    = f.value(p.x);
  model.gradient = {{dot(g, p.first[0]), dot(g, p.first[1])}};
  model.hessian  = {{q(p.first[0], p.first[0]) + dot(g, p.second[0]), q(p.first[0], p.first[1]) + dot(g, p.second[1]),
                     q(p.first[1], p.first[1]) + dot(g, p.second[2])}};
  return model;
}

/** Takes a parameter out of the model: it stays where it is. */
void fix(LocalModel &model, const unsigned int a)
{
  model.gradient[a]    = 0.;
  model.hessian[1]     = 0.;
  model.hessian[2 * a] = 0.;
}

/** Newton's step uphill: (mu I - Hessian) p = gradient, with mu >= 0 such that the matrix is positive definite. */
std::array<double, 2> uphill_step(const LocalModel &model)
{
  const std::array<double, 2> &g = model.gradient;
  const double a = -model.hessian[0], b = -model.hessian[1], c = -model.hessian[2];
  const double mean = 0.5 * (a + c), radius = std::hypot(0.5 * (a - c), b);
  const double floor = 1e-8 * (std::abs(mean) + radius + std::abs(g[0]) + std::abs(g[1]));
  const double mu    = std::max(0., floor - (mean - radius));
  const double det   = (a + mu) * (c + mu) - b * b;
  if (!(det > 0.))
    return {{0., 0.}};
  return {{((c + mu) * g[0] - b * g[1]) / det, ((a + mu) * g[1] - b * g[0]) / det}};
}

double climb(const CellGeometry &geometry, const QuadraticFunction &f, CellSite site)
{
  LocalModel model = model_at(geometry, f, site);
  for (unsigned int iteration = 0; iteration < 50; ++iteration)
  {
    for (unsigned int a = 0; a < 2; ++a)
      if (a >= geometry.n_parameters() || (site.xi[a] <= 0. && model.gradient[a] <= 0.) ||
          (site.xi[a] >= 1. && model.gradient[a] >= 0.))
        fix(model, a);
    const std::array<double, 2> step = uphill_step(model);
    bool improved                    = false;
    for (double length = 1.; length > 1e-6 && !improved; length *= 0.5)
    {
      CellSite trial = site;
      for (unsigned int a = 0; a < geometry.n_parameters(); ++a)
        trial.xi[a] = std::clamp(site.xi[a] + length * step[a], 0., 1.);
      const LocalModel trial_model = model_at(geometry, f, trial);
      improved                     = trial_model.value > model.value;
      if (improved)
      {
        site  = trial;
        model = trial_model;
      }
    }
    if (!improved)
      break;
  }
  return model.value;
}
} // namespace

double QuadraticFunction::value(const Vector3<double> &x) const
{
  const Vector3<double> d = x - origin;
  double half             = 0.;
  for (unsigned int i = 0; i < 3; ++i)
    half += 0.5 * diagonal[i] * d[i] * d[i];
  return dot(linear, d) + half;
}

Vector3<double> QuadraticFunction::gradient(const Vector3<double> &x) const
{
  Vector3<double> result = linear;
  for (unsigned int i = 0; i < 3; ++i)
    result[i] += diagonal[i] * (x[i] - origin[i]);
  return result;
}

double largest_value(const CellGeometry &geometry, const QuadraticFunction &f)
{
  struct Best
  {
    double value        = -std::numeric_limits<double>::infinity();
    double smallest     = std::numeric_limits<double>::infinity();
    unsigned int sample = 0;
  };
  std::vector<Best> best(geometry.n_cells());
  double largest = -std::numeric_limits<double>::infinity();
  for (std::size_t cell = 0; cell < geometry.n_cells(); ++cell)
  {
    for (unsigned int i = 0; i < geometry.n_samples(); ++i)
    {
      const double value  = f.value(geometry.sample(cell, i));
      best[cell].smallest = std::min(best[cell].smallest, value);
      if (value > best[cell].value)
      {
        best[cell].value  = value;
        best[cell].sample = i;
      }
    }
    largest = std::max(largest, best[cell].value);
  }
  // Between samples a smooth function rises by a small part of its variation in the cell; a quarter is generous.
  const double of_samples = largest;
  for (std::size_t cell = 0; cell < geometry.n_cells(); ++cell)
    if (best[cell].value + 0.25 * (best[cell].value - best[cell].smallest) >= of_samples)
      largest = std::max(largest, climb(geometry, f, {cell, geometry.sample_coordinates(best[cell].sample)}));
  return largest;
}
} // namespace pellicle

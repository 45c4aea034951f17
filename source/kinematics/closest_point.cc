// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/kinematics/closest_point.h>

#include <cmath>
#include <string>

namespace pellicle
{
namespace
{
using Tensor = SymmetricSurfaceTensor<double>;

/** Determinant of the block of the free parameters, and its inverse. */
double leading_determinant(const Tensor &s, const unsigned int n_parameters)
{
  return n_parameters == 2 ? determinant(s) : n_parameters == 1 ? s(0, 0) : 1.;
}

Tensor leading_inverse(const Tensor &s, const unsigned int n_parameters)
{
  const double det = leading_determinant(s, n_parameters);
  return n_parameters == 2   ? Tensor(s(1, 1) / det, -s(0, 1) / det, s(0, 0) / det)
         : n_parameters == 1 ? Tensor(1. / det, 0., 0.)
                             : Tensor();
}

std::string text(const Vector3<double> &x)
{
  return "(" + std::to_string(x[0]) + ", " + std::to_string(x[1]) + ", " + std::to_string(x[2]) + ")";
}

Vector3<double> unit(const Vector3<double> &v)
{
  return v / norm(v);
}

/** A unit vector normal to the unit vector n. */
Vector3<double> any_normal_to(const Vector3<double> &n)
{
  const Vector3<double> axis = std::abs(n[0]) < 0.6 ? Vector3<double>(1., 0., 0.) : Vector3<double>(0., 1., 0.);
  return unit(cross(n, axis));
}

void add(const double s, const std::vector<double> &u, std::vector<double> &sum)
{
  for (std::size_t i = 0; i < sum.size(); ++i)
    sum[i] += s * u[i];
}
} // namespace

std::vector<double> relative_row(const Vector3<double> &v, const MasterPoint &master)
{
  std::vector<double> row = master_row(-v, master.values);
  for (unsigned int component = 0; component < 3; ++component)
    row[component * (1 + master.n_nodes())] = v[component];
  return row;
}

std::vector<double> master_row(const Vector3<double> &v, const std::vector<double> &m)
{
  const std::size_t n = m.size();
  std::vector<double> row(3 * (1 + n), 0.);
  for (unsigned int component = 0; component < 3; ++component)
    for (std::size_t K = 0; K < n; ++K)
      row[component * (1 + n) + 1 + K] = m[K] * v[component];
  return row;
}

ClosestPoint::ClosestPoint(const Vector3<double> &x, const MasterPoint &master)
    : n_parameters(master.n_parameters)
    , base(master.first)
{
  place(x, master);
  for (unsigned int a = 0; a < n_parameters; ++a)
    for (unsigned int b = a; b < n_parameters; ++b)
    {
      metric(a, b)    = dot(base[a], base[b]);
      curvature(a, b) = dot(normal, master.second(a, b));
    }
  inverse_metric = leading_inverse(metric, n_parameters);

  Tensor shifted;
  for (unsigned int i = 0; i < 3; ++i)
    shifted.components[i] = metric.components[i] - gap * curvature.components[i];
  // Smaller relative determinants leave no digits in c.
  constexpr double smallest = 1e-10;
  if (leading_determinant(shifted, n_parameters) <= smallest * leading_determinant(metric, n_parameters) ||
      (n_parameters == 2 && shifted(0, 0) <= 0.))
    throw SolveError("The point " + text(x) + ", " + std::to_string(gap) +
                     " off the surface it touches, is at or beyond that surface's centre of curvature: there is no "
                     "unique closest point. Take a smaller step, or a search radius below the radius of curvature.");
  c = leading_inverse(shifted, n_parameters);
  make_vectors(master);
}

/** Normal, gap, and the directions across. */
void ClosestPoint::place(const Vector3<double> &x, const MasterPoint &master)
{
  const Vector3<double> r = x - master.x;
  if (n_parameters == 2)
  {
    normal = unit(cross(base[0], base[1]));
    gap    = dot(r, normal);
    return;
  }
  const double distance = norm(r);
  if (distance == 0.)
    throw SolveError("The point " + text(x) + " is on an edge between master cells: the gap has no direction there.");
  const double side = dot(r, master.outward) < 0. ? -1. : 1.;
  normal            = (side / distance) * r;
  gap               = side * distance;
  if (n_parameters == 1)
    across = {unit(cross(base[0], normal))};
  else
  {
    const Vector3<double> first = any_normal_to(normal);
    across                      = {first, cross(normal, first)};
  }
}

void ClosestPoint::make_vectors(const MasterPoint &master)
{
  N = relative_row(normal, master);
  for (const Vector3<double> &b : across)
    B.push_back(relative_row(b, master));
  for (unsigned int a = 0; a < n_parameters; ++a)
  {
    T[a] = relative_row(base[a], master);
    Q[a] = master_row(normal, master.first_values[a]);
  }
  for (unsigned int a = 0; a < n_parameters; ++a)
  {
    D[a].assign(n_rows(), 0.);
    D_hat[a].assign(n_rows(), 0.);
    for (unsigned int b = 0; b < n_parameters; ++b)
    {
      add(c(a, b), T[b], D[a]);
      add(c(a, b) * gap, Q[b], D[a]);
      add(inverse_metric(a, b), T[b], D_hat[a]);
    }
  }
}
} // namespace pellicle

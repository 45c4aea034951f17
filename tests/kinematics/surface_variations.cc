// SPDX-License-Identifier: LGPL-2.1-or-later
// The formulas of the variations against automatic differentiation of the geometry along x + t w + s u.
#include <pellicle/kinematics/surface_variations.h>

#include "checks.h"
#include "surfaces.h"

#include <random>

using namespace pellicle;
using namespace pellicle::test_surfaces;

namespace
{
using Number = SecondOrder<2>;

/** Parametric derivatives of an increment of the position. */
struct Increment
{
  FirstDerivatives<double> first;
  SecondDerivatives<double> second;
};

Increment random_increment(std::mt19937 &generator)
{
  std::uniform_real_distribution<double> uniform(-1., 1.);
  Increment w;
  for (unsigned int i = 0; i < 3; ++i)
  {
    for (auto &v : w.first)
      v[i] = uniform(generator);
    for (auto &v : w.second.components)
      v[i] = uniform(generator);
  }
  return w;
}

/** The number x + t w + s u in the two variables t and s at 0. */
Vector3<Number> moved(const Vector3<double> &x, const Vector3<double> &w, const Vector3<double> &u)
{
  const auto ts = seed<Number>({{0., 0.}});
  Vector3<Number> result;
  for (unsigned int i = 0; i < 3; ++i)
    result[i] = x[i] + w[i] * ts[0] + u[i] * ts[1];
  return result;
}

double d_w(const Number &f)
{
  return f.val().dx(0);
}
double d_wu(const Number &f)
{
  return f.dx(0).dx(1);
}

template <typename Derivative>
Vector3<double> each(const Derivative &d, const Vector3<Number> &v)
{
  return Vector3<double>(d(v[0]), d(v[1]), d(v[2]));
}
template <typename Derivative>
SymmetricSurfaceTensor<double> each(const Derivative &d, const SymmetricSurfaceTensor<Number> &s)
{
  return SymmetricSurfaceTensor<double>(d(s.components[0]), d(s.components[1]), d(s.components[2]));
}

/** A sampled point, two random increments, and the geometry along them. */
struct Case
{
  std::string name;
  SurfacePoint<double> p;
  Increment w, u;
  SurfacePoint<Number> along;
};

std::vector<Case> cases()
{
  std::mt19937 generator(7);
  std::vector<Case> all;
  for (const Sample &s : samples())
  {
    const Increment w = random_increment(generator), u = random_increment(generator);
    const auto second = [&](const unsigned int i)
    { return moved(s.second.components[i], w.second.components[i], u.second.components[i]); };
    all.push_back({s.name, s.point(), w, u,
                   SurfacePoint<Number>(moved(s.first[0], w.first[0], u.first[0]),
                                        moved(s.first[1], w.first[1], u.first[1]), second(0), second(1), second(2))});
  }
  return all;
}

/** Cancellation inside the formulas is bounded by powers of the largest coefficient. */
double scale(const SurfacePoint<double> &p)
{
  double largest = 1.;
  for (unsigned int i = 0; i < 3; ++i)
    largest = std::max({largest, std::abs(p.inverse_metric.components[i]), std::abs(p.curvature.components[i])});
  return largest * largest;
}
} // namespace

TEST(SurfaceVariations, FirstVariationsOfTheTangentPlane)
{
  for (const Case &c : cases())
  {
    SCOPED_TRACE(c.name);
    const auto metric_variation = variation_of_metric(c.p, c.w.first);
    expect_close(metric_variation, each(d_w, c.along.metric));
    expect_close(variation_of_inverse_metric(c.p, metric_variation), each(d_w, c.along.inverse_metric), scale(c.p));
    expect_close(variation_of_jacobian(c.p, c.w.first), d_w(c.along.jacobian));
    expect_close(variation_of_area_vector(c.p, c.w.first), each(d_w, c.along.area_vector));
    expect_close(variation_of_normal(c.p, c.w.first), each(d_w, c.along.normal), scale(c.p));
    for (unsigned int a = 0; a < 2; ++a)
      expect_close(variation_of_dual(c.p, c.w.first)[a], each(d_w, c.along.dual[a]), scale(c.p));
  }
}

TEST(SurfaceVariations, FirstVariationsOfTheCurvatures)
{
  for (const Case &c : cases())
  {
    SCOPED_TRACE(c.name);
    const auto metric_variation    = variation_of_metric(c.p, c.w.first);
    const auto curvature_variation = variation_of_curvature(c.p, c.w.first, c.w.second);
    expect_close(curvature_variation, each(d_w, c.along.curvature), scale(c.p));
    expect_close(variation_of_mean_curvature(c.p, metric_variation, curvature_variation), d_w(c.along.mean_curvature),
                 scale(c.p));
    expect_close(variation_of_gauss_curvature(c.p, metric_variation, curvature_variation), d_w(c.along.gauss_curvature),
                 scale(c.p));
  }
}

TEST(SurfaceVariations, SecondVariations)
{
  for (const Case &c : cases())
  {
    SCOPED_TRACE(c.name);
    const auto &w = c.w.first, &u = c.u.first;
    expect_close(second_variation_of_metric(w, u), each(d_wu, c.along.metric));
    expect_close(second_variation_of_inverse_metric(c.p, w, u), each(d_wu, c.along.inverse_metric), scale(c.p));
    expect_close(second_variation_of_jacobian(c.p, w, u), d_wu(c.along.jacobian), scale(c.p));
    expect_close(second_variation_of_area_vector(w, u), each(d_wu, c.along.area_vector));
    expect_close(second_variation_of_normal(c.p, w, u), each(d_wu, c.along.normal), scale(c.p));
    expect_close(second_variation_of_curvature(c.p, w, c.w.second, u, c.u.second), each(d_wu, c.along.curvature),
                 scale(c.p));
  }
}

TEST(SurfaceVariations, SecondVariationsAreSymmetricInTheIncrements)
{
  for (const Case &c : cases())
  {
    SCOPED_TRACE(c.name);
    const auto &w = c.w.first, &u = c.u.first;
    expect_close(second_variation_of_jacobian(c.p, w, u), second_variation_of_jacobian(c.p, u, w), scale(c.p));
    expect_close(second_variation_of_normal(c.p, w, u), second_variation_of_normal(c.p, u, w), scale(c.p));
    expect_close(second_variation_of_inverse_metric(c.p, w, u), second_variation_of_inverse_metric(c.p, u, w),
                 scale(c.p));
  }
}

TEST(SurfaceVariations, InfinitesimalRotationsChangeOnlyDirections)
{
  const Vector3<double> omega(0.3, -1.1, 0.7);
  for (const Sample &s : samples())
  {
    SCOPED_TRACE(s.name);
    const SurfacePoint<double> p = s.point();
    const FirstDerivatives<double> w{{cross(omega, s.first[0]), cross(omega, s.first[1])}};
    const SecondDerivatives<double> w_second(cross(omega, s.second(0, 0)), cross(omega, s.second(0, 1)),
                                             cross(omega, s.second(1, 1)));
    const SymmetricSurfaceTensor<double> zero;
    expect_close(variation_of_metric(p, w), zero);
    expect_close(variation_of_jacobian(p, w), 0.);
    expect_close(variation_of_curvature(p, w, w_second), zero);
    expect_close(variation_of_normal(p, w), cross(omega, p.normal));
  }
}

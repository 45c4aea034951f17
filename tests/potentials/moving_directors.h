// SPDX-License-Identifier: LGPL-2.1-or-later
// Smooth periodic surfaces (u, v) -> x that move, with directors and vectors b_a on them, for the tests of directors.
// Sums over equidistant points are integrals to nearly round-off.
#pragma once

#include <pellicle/kinematics/automatic_differentiation.h>
#include <pellicle/kinematics/surface_operators.h>
#include <pellicle/potentials/director/director_history.h>
#include <pellicle/potentials/potential.h>

#include <cmath>

namespace pellicle::test
{
/** Value and derivatives of a vector function of (u, v, t) at one place and time. */
struct Jet
{
  Vector3<double> value;
  std::array<Vector3<double>, 3> d;                 ///< ,u ,v ,t
  std::array<std::array<Vector3<double>, 3>, 3> dd; ///< second derivatives

  Vector3<double> rate(const unsigned int a) const { return dd[a][2]; } ///< of ,u or ,v
};

template <typename Field>
Jet jet(const Field &field, const double u, const double v, const double t)
{
  using Number                = SecondOrder<3>;
  const Vector3<Number> value = field(seed<Number>(0, u), seed<Number>(1, v), seed<Number>(2, t));
  Jet result;
  for (unsigned int c = 0; c < 3; ++c)
  {
    result.value[c] = value_of(value[c]);
    for (unsigned int i = 0; i < 3; ++i)
    {
      result.d[i][c] = value[c].val().dx(i);
      for (unsigned int j = 0; j < 3; ++j)
        result.dd[i][j][c] = value[c].dx(i).dx(j);
    }
  }
  return result;
}

template <typename Number>
Vector3<Number> unit(const Vector3<Number> &v)
{
  return v / norm(v);
}

/** A torus with bumps that travel, stretches and turns; a_u x a_v points outwards. */
struct MovingTorus
{
  template <typename Number>
  Vector3<Number> operator()(const Number &u, const Number &v, const Number &t) const
  {
    using std::cos;
    using std::sin;
    const Number r     = 0.6 + 0.1 * cos(u - 2. * t) + 0.3 * t * sin(v) + 0.2 * t;
    const Number angle = u + 0.4 * t * cos(v) + 0.3 * t;
    const Number s     = 1.6 + r * cos(v);
    return {Number(s * cos(angle)), Number(s * sin(angle) + 0.5 * t * sin(u)), Number(r * sin(v) + 0.2 * t * cos(u))};
  }
};

/** Unit vectors near the torus's normals: d/|d| with d = n_0 + tilt c. */
struct MovingDirectors
{
  double tilt = 0.25;

  template <typename Number>
  Vector3<Number> operator()(const Number &u, const Number &v, const Number &t) const
  {
    using std::cos;
    using std::sin;
    const Vector3<Number> normal(Number(cos(u) * cos(v)), Number(sin(u) * cos(v)), sin(v));
    const Vector3<Number> c(Number(sin(u + v) + t), Number(cos(v) - 2. * t * sin(u)), Number(sin(u) + t * cos(v)));
    return unit<Number>(normal + Number(tilt) * c);
  }
};

/** b_a = (I - O O) c_a, index = 0 or 1. */
struct SpontaneousVectors
{
  unsigned int index = 0;
  double size        = 0.5;

  template <typename Number>
  Vector3<Number> operator()(const Number &u, const Number &v, const Number &t) const
  {
    using std::cos;
    using std::sin;
    const Vector3<Number> O = MovingDirectors()(u, v, t);
    const Vector3<Number> c =
        index == 0 ? Vector3<Number>(Number(1. + sin(v)), cos(u), Number(0.5 * sin(u - v)))
                   : Vector3<Number>(Number(0.3 * cos(u)), Number(sin(u + v) - 0.7), Number(0.9 * cos(v)));
    return Number(size) * (c - dot(O, c) * O);
  }
};

/** Inputs or rates of a density of (position, director, each with first derivatives). */
inline std::vector<double> stacked(const std::array<Vector3<double>, 6> &slots)
{
  std::vector<double> all;
  for (const Vector3<double> &v : slots)
    all.insert(all.end(), v.components.begin(), v.components.end());
  return all;
}

/** Value and gradient of a potential of position and director at one point. */
inline PointSums evaluate(const Potential &potential, const std::vector<double> &inputs, const std::size_t index = 0)
{
  const unsigned int offsets[2] = {0, 9};
  PointSums sums;
  sums.reset(1, 18, Order::gradient);
  potential.add({index, 1, 18, inputs.data()}, offsets, 1., Order::gradient, sums);
  return sums;
}

inline double product(const std::vector<double> &a, const std::vector<double> &b)
{
  double sum = 0.;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += a[i] * b[i];
  return sum;
}

/** Calls action(u, v, weight) at n x n equidistant points; the weights add up to (2 pi)^2. */
template <typename Action>
void over_torus(const unsigned int n, const Action &action)
{
  const double step = 2. * std::acos(-1.) / n;
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      action(i * step, j * step, step * step);
}
} // namespace pellicle::test

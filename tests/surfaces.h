// SPDX-License-Identifier: LGPL-2.1-or-later
// Surfaces with closed-form geometry, for tests of anything that sees a surface point.
#pragma once

#include <pellicle/kinematics/automatic_differentiation.h>
#include <pellicle/kinematics/surface_point.h>

#include <cmath>
#include <string>
#include <vector>

namespace pellicle::test_surfaces
{
/** Spherical angles (polar, azimuth): n outward. */
struct Sphere
{
  static constexpr auto name = "sphere";
  double R                   = 1.7;

  template <typename Number>
  Vector3<Number> position(const Number &u, const Number &v) const
  {
    return Vector3<Number>(Number(R * sin(u) * cos(v)), Number(R * sin(u) * sin(v)), Number(R * cos(u)));
  }
  double J(const double u, double) const { return R * R * std::sin(u); }
  double H(double, double) const { return -1. / R; }
  double K(double, double) const { return 1. / (R * R); }
};

/** Angles (about the axis, about the tube's centre line), distance R of that line from the axis, tube radius r: n
 * outward. */
struct Torus
{
  static constexpr auto name = "torus";
  double R = 1.5, r = 0.6;

  template <typename Number>
  Vector3<Number> position(const Number &u, const Number &v) const
  {
    const Number rho = R + r * cos(v);
    return Vector3<Number>(Number(rho * cos(u)), Number(rho * sin(u)), Number(r * sin(v)));
  }
  double distance(const double v) const { return R + r * std::cos(v); }
  double J(double, const double v) const { return r * distance(v); }
  double H(double, const double v) const { return -0.5 * (1. / r + std::cos(v) / distance(v)); }
  double K(double, const double v) const { return std::cos(v) / (r * distance(v)); }
};

/** Semi-axes a, b, c, scaled spherical angles: n outward. */
struct Ellipsoid
{
  static constexpr auto name = "ellipsoid";
  double a = 1.2, b = 0.8, c = 1.9;

  template <typename Number>
  Vector3<Number> position(const Number &u, const Number &v) const
  {
    return Vector3<Number>(Number(a * sin(u) * cos(v)), Number(b * sin(u) * sin(v)), Number(c * cos(u)));
  }
  /** norm of (x/a^2, y/b^2, z/c^2), the inverse distance of the tangent plane from the centre. */
  double inverse_support(const double u, const double v) const
  {
    const Vector3<double> x = position(u, v);
    return norm(Vector3<double>(x[0] / (a * a), x[1] / (b * b), x[2] / (c * c)));
  }
  double J(const double u, const double v) const { return a * b * c * std::sin(u) * inverse_support(u, v); }
  double H(const double u, const double v) const
  {
    const Vector3<double> x = position(u, v);
    return (dot(x, x) - a * a - b * b - c * c) / (2. * std::pow(a * b * c, 2) * std::pow(inverse_support(u, v), 3));
  }
  double K(const double u, const double v) const
  {
    return 1. / std::pow(a * b * c * std::pow(inverse_support(u, v), 2), 2);
  }
};

/** Azimuth and height, waist c: n away from the axis. */
struct Catenoid
{
  static constexpr auto name = "catenoid";
  double c                   = 0.9;

  template <typename Number>
  Vector3<Number> position(const Number &u, const Number &v) const
  {
    const Number rho = c * cosh(v / c);
    return Vector3<Number>(Number(rho * cos(u)), Number(rho * sin(u)), v);
  }
  double J(double, const double v) const { return c * std::pow(std::cosh(v / c), 2); }
  double H(double, double) const { return 0.; }
  double K(double, const double v) const { return -1. / std::pow(c * std::pow(std::cosh(v / c), 2), 2); }
};

/** z = (p x^2 + q y^2)/2: n upwards, so that the bowl has H > 0 in the convention b_ab = n . x,ab. */
struct Paraboloid
{
  static constexpr auto name = "paraboloid";
  double p = 0.7, q = 1.6;

  template <typename Number>
  Vector3<Number> position(const Number &u, const Number &v) const
  {
    return Vector3<Number>(u, v, Number(0.5 * p * u * u + 0.5 * q * v * v));
  }
  double J(const double u, const double v) const { return std::sqrt(1. + p * p * u * u + q * q * v * v); }
  double H(const double u, const double v) const
  {
    return ((1. + q * q * v * v) * p + (1. + p * p * u * u) * q) / (2. * std::pow(J(u, v), 3));
  }
  double K(const double u, const double v) const { return p * q / std::pow(J(u, v), 4); }
};

/** A point of a surface: its derivatives from automatic differentiation of the parametrisation, its geometry in closed
 * form. */
struct Sample
{
  std::string name;
  Vector3<double> x;
  FirstDerivatives<double> first;   ///< x,1 x,2
  SecondDerivatives<double> second; ///< x,11 x,12 x,22
  double J, H, K;

  SurfacePoint<double> point() const
  {
    return SurfacePoint<double>(first[0], first[1], second(0, 0), second(0, 1), second(1, 1));
  }
};

/**
 * The surface at (u, v). Its own parameters are mostly lines of curvature (a_12 = b_12 = 0); with a shear p, q the
 * parameters are (u + u1 + p u2, v + q u1 + u2), at which nothing vanishes by symmetry.
 */
template <typename Surface>
Sample sample(const Surface &surface, const double u, const double v, const double p = 0., const double q = 0.)
{
  const auto parameters          = seed<SecondOrder<2>>({{0., 0.}});
  const SecondOrder<2> sheared_u = u + parameters[0] + p * parameters[1],
                       sheared_v = v + q * parameters[0] + parameters[1];
  const auto position            = surface.position(sheared_u, sheared_v);
  Sample s{surface.name, {}, {}, {}, (1. - p * q) * surface.J(u, v), surface.H(u, v), surface.K(u, v)};
  s.name += " at (" + std::to_string(u) + ", " + std::to_string(v) + (p != 0. || q != 0. ? "), sheared" : ")");
  for (unsigned int i = 0; i < 3; ++i)
  {
    const auto first  = gradient_of(position[i]);
    const auto second = hessian_of(position[i]);
    s.x[i]            = value_of(position[i]);
    s.first[0][i]     = first[0];
    s.first[1][i]     = first[1];
    s.second(0, 0)[i] = second[0];
    s.second(0, 1)[i] = second[1];
    s.second(1, 1)[i] = second[3];
  }
  return s;
}

/** A few generic points of every surface above, in its own and in sheared parameters. */
inline std::vector<Sample> samples()
{
  std::vector<Sample> all;
  for (const auto &[u, v] : {std::array<double, 2>{{0.4, 0.3}}, {{1.1, -0.7}}, {{2.2, 1.3}}, {{0.9, 2.6}}})
    for (const auto &[p, q] : {std::array<double, 2>{{0., 0.}}, {{0.3, -0.2}}})
    {
      all.push_back(sample(Sphere(), u, v, p, q));
      all.push_back(sample(Torus(), u, v, p, q));
      all.push_back(sample(Ellipsoid(), u, v, p, q));
      all.push_back(sample(Catenoid(), u, v, p, q));
      all.push_back(sample(Paraboloid(), u, v, p, q));
    }
  return all;
}
} // namespace pellicle::test_surfaces

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/kinematics/vector3.h>
#include <pellicle/potentials/wetting/taylor.h>

#include <array>
#include <memory>
#include <utility>
#include <variant>

namespace pellicle
{
/**
 * Coordinates (u, v) on the surface of a rigid substrate, whose origin is the point of the surface on the z axis. They
 * turn integrals over the wetted base into integrals along the contact line.
 *
 * | code  | symbol                                                        |
 * |-------|---------------------------------------------------------------|
 * | place | X(u, v)                                                       |
 * | area  | X,u x X,v, out of the substrate: into the drop                |
 */
template <typename Number>
struct PlaceOnSubstrate
{
  Vector3<Number> place, area;
};

/** The plane z = h with the drop above it (up = 1: u = x, v = y) or below it (up = -1: u = x, v = -y). */
struct PlaneChart
{
  double height = 0.;
  double up     = 1.;

  template <typename Number>
  std::array<Number, 2> coordinates(const Vector3<Number> &x) const
  {
    return {{x[0], Number(up * x[1])}};
  }
  /** du, dv of a displacement dx of x. */
  template <typename Number>
  std::array<Number, 2> differential(const Vector3<Number> & /*x*/, const Vector3<Number> &dx) const
  {
    return {{dx[0], Number(up * dx[1])}};
  }
  template <typename Number>
  PlaceOnSubstrate<Number> at(const Number &u, const Number &v) const
  {
    return {{u, Number(up * v), Number(height)}, {Number(0.), Number(0.), Number(up)}};
  }
};

/**
 * A sphere of radius R that touches z = 0 at the origin: a ball below it (side +1; the drop sits on top), or a cavity
 * above it (side -1; the drop lies at the bottom). Stereographic projection from the opposite pole,
 *
 *     u = 2 R x/(2 R + s z),    x = k u, y = k v, z = -2 s R (1 - k),    k = 1/(1 + (u^2 + v^2)/(4 R^2)),
 *
 * smooth everywhere but there.
 */
struct SphereChart
{
  double radius = 1.;
  double side   = 1.;

  template <typename Number>
  std::array<Number, 2> coordinates(const Vector3<Number> &x) const
  {
    const Number f = 2. * radius / (2. * radius + side * x[2]);
    return {{Number(f * x[0]), Number(f * x[1])}};
  }
  template <typename Number>
  std::array<Number, 2> differential(const Vector3<Number> &x, const Vector3<Number> &dx) const
  {
    const Number f = 2. * radius / (2. * radius + side * x[2]), df = -f * f * side / (2. * radius) * dx[2];
    return {{Number(f * dx[0] + df * x[0]), Number(f * dx[1] + df * x[1])}};
  }
  template <typename Number>
  PlaceOnSubstrate<Number> at(const Number &u, const Number &v) const
  {
    const Number k = 1. / (1. + (u * u + v * v) / (4. * radius * radius));
    const Number x = k * u, y = k * v, kk = k * k, slope = kk * side / radius, up = kk * (2. * k - 1.);
    return {{x, y, Number(-2. * side * radius * (1. - k))}, {Number(slope * x), Number(slope * y), up}};
  }
};

/** The surface z = H(x, y): u = x, v = y. */
struct HeightChart
{
  std::shared_ptr<const FunctionOfPlace> height; ///< internal units

  template <typename Number>
  std::array<Number, 2> coordinates(const Vector3<Number> &x) const
  {
    return {{x[0], x[1]}};
  }
  template <typename Number>
  std::array<Number, 2> differential(const Vector3<Number> & /*x*/, const Vector3<Number> &dx) const
  {
    return {{dx[0], dx[1]}};
  }
  template <typename Number>
  PlaceOnSubstrate<Number> at(const Number &u, const Number &v) const
  {
    const FunctionAtPlace<Number> H(*height, u, v);
    return {{u, v, H.value}, {Number(-H.dx), Number(-H.dy), Number(1.)}};
  }
};

using SubstrateChart = std::variant<PlaneChart, SphereChart, HeightChart>;
} // namespace pellicle

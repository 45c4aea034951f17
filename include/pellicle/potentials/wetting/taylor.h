// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/function_of_place.h>
#include <pellicle/kinematics/automatic_differentiation.h>

namespace pellicle
{
/** f(x, y) and its gradient in a number type of automatic differentiation, exact to second derivatives: their Taylor
 * polynomials about the values of x and y. */
template <typename Number>
struct FunctionAtPlace
{
  Number value, dx, dy;

  FunctionAtPlace(const FunctionOfPlace &function, const Number &x, const Number &y)
  {
    const PlaceSample f = function.at(value_of(x), value_of(y));
    const Number u = x - value_of(x), v = y - value_of(y);
    const Number uu = 0.5 * u * u, uv = u * v, vv = 0.5 * v * v;
    value = f.value + f.dx * u + f.dy * v + f.dxx * uu + f.dxy * uv + f.dyy * vv;
    dx    = f.dx + f.dxx * u + f.dxy * v + f.dxxx * uu + f.dxxy * uv + f.dxyy * vv;
    dy    = f.dy + f.dxy * u + f.dyy * v + f.dxxy * uu + f.dxyy * uv + f.dyyy * vv;
  }
};
} // namespace pellicle

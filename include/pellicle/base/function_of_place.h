// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace pellicle
{
/** Value and partial derivatives of a function f(x, y) at a place. */
struct PlaceSample
{
  double value = 0., dx = 0., dy = 0., dxx = 0., dxy = 0., dyy = 0.;
};

/** A function of two coordinates, e.g. the height of a substrate or its wettability. */
class FunctionOfPlace
{
public:
  virtual ~FunctionOfPlace() = default;

  /** Where f or a derivative does not exist, the number is nan or infinite; nothing is thrown. */
  virtual PlaceSample at(double x, double y) const = 0;

  /** For messages: "0.1*sin(x)". */
  virtual const std::string &text() const = 0;
};
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>

namespace pellicle
{
/** Physical dimension energy^e length^l time^t of a parameter or a reported quantity. Time is not scaled: a scene's own
 * unit of time serves inside as well. */
struct Dimension
{
  int energy = 0;
  int length = 0;
  int time   = 0;

  /** Text such as "energy/length^2"; "1" when dimensionless. Defined here so that the point rooms stay header-light. */
  const char *text() const
  {
    const int code = 10000 * time + 100 * energy + length;
    switch (code)
    {
    case 10000:
      return "time";
    case 10098:
      return "energy time/length^2";
    case -9900:
      return "energy/time";
    case 0:
      return "1";
    case 1:
      return "length";
    case 2:
      return "length^2";
    case 3:
      return "length^3";
    case -1:
      return "1/length";
    case -2:
      return "1/length^2";
    case 100:
      return "energy";
    case 99:
      return "energy/length";
    case 98:
      return "energy/length^2";
    case 97:
      return "energy/length^3";
    case 96:
      return "energy/length^4";
    case 94:
      return "energy/length^6";
    default:
      return "energy^a length^b";
    }
  }
};

namespace dimensions
{
constexpr Dimension none{0, 0}, length{0, 1}, area{0, 2}, volume{0, 3}, curvature{0, -1}, gauss_curvature{0, -2},
    energy{1, 0}, line_tension{1, -1}, tension{1, -2}, pressure{1, -3}, time{0, 0, 1}, friction{1, -2, 1},
    power{1, 0, -1};
}

/**
 * The scene's own length and energy. Inside, everything is divided by these (so that one round-off and one tolerance
 * serve nanometres and SI alike); what users read is multiplied back.
 */
struct Scales
{
  double length = 1.;
  double energy = 1.;

  /** Size of one internal unit of a quantity of the given dimension, in the user's units. */
  double of(const Dimension dimension) const
  {
    return std::pow(energy, dimension.energy) * std::pow(length, dimension.length);
  }
};
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/function_of_place.h>

#include <functional>
#include <optional>
#include <utility>

namespace pellicle
{
/** Where a function of place is not smooth on a curve: curve parameter and place. */
struct Kink
{
  double s = 0., x = 0., y = 0.;
};

/**
 * The first place on a curve (x, y)(s), 0 <= s <= 1, continuous, where H is not twice continuously differentiable, or
 * none. Newton's method fails when nodes slide over such a place.
 *
 * The curve is sampled at `n_samples` places. Wherever the gradient or the matrix of second derivatives differs between
 * two neighbours, their interval is halved again and again towards the greater difference. The difference of a smooth
 * function goes to zero with the interval; where more than 1% of it is left in an interval of 1e-11, it is a jump.
 * Differences below 1e-8 of the function's size are taken for round-off. A derivative that is not a finite number
 * counts as a kink, too.
 *
 * A pair of kinks between the same two samples may be missed, and so are kinks that the curve never crosses; more
 * samples see more. Derivatives that change within less than 1e-10 of the curve look like jumps.
 */
std::optional<Kink> find_kink(const FunctionOfPlace &H, const std::function<std::pair<double, double>(double s)> &curve,
                              unsigned int n_samples = 500);
} // namespace pellicle

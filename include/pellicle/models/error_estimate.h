// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

namespace pellicle
{
/**
 * What is known of a level's error from a richer space (higher degree, or finer cells).
 *
 * Going there has two parts that are of opposite sign for bending energies: the given shape has another energy, since
 * its curvature is seen more sharply (`seen`), and then relaxes (`relaxed`). Where they cancel by accident the sum says
 * nothing, so no more than a tenth of the larger one is ever taken off.
 */
struct RicherSpace
{
  double seen    = 0.; ///< value there of the state carried over, minus the level's value
  double relaxed = 0.; ///< change of the value by the relaxation
};

/**
 * Estimate of the level's error: the larger of |seen + relaxed| and a tenth of either part, over 1 - ratio, where ratio
 * is that of the error left in the richer space, from the levels before (at most 1/2 is believed).
 *
 * @param before  estimates of the levels before, in the same unit.
 */
double estimate_from(const RicherSpace &richer, const std::vector<double> &before);

/**
 * The same from values of levels alone, where nothing is carried over: differences of neighbours d_i = |Q_{i+1} - Q_i|
 * fall by r = d_i/d_{i-1}, hence error d_i/(1 - r). So that one difference that is small by accident proves nothing,
 * none counts as smaller than a tenth of what the one before it lets expect at the ratio before. Returns estimates for
 * all levels but the last one.
 */
std::vector<double> estimates_of_sequence(const std::vector<double> &values);

/** Estimate for the level after the last estimated one: that times the larger of the last two ratios. Without two
 * estimates: that of the last one. */
double expected_error(const std::vector<double> &estimates);
} // namespace pellicle

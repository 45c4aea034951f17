// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

namespace pellicle
{
/**
 * What is known of a level's error from a richer space (higher degree, or finer cells). Going there has two parts: the
 * given shape has another value, since it is seen more sharply, and then relaxes. For bending energies they are of
 * opposite sign and a hundred times as large as their sum, for surfaces of drops the second one is almost all.
 */
struct RicherSpace
{
  double seen    = 0.; ///< value there of the state carried over, minus the level's value
  double relaxed = 0.; ///< change of the value by the relaxation
};

/**
 * Estimate of the last level's error from the richer spaces of all levels so far: |seen + relaxed|/(1 - ratio), where
 * ratio is that of the errors of the richer space and of the level, as the level before lets expect it (1/2 if there is
 * none, 0.8 at most).
 *
 * Two levels whose errors are equal by accident look perfect. So no level counts as more than 400 times as accurate as
 * the one before, and no sum for smaller than 1/2000 of the larger part.
 */
double estimate_from(const std::vector<RicherSpace> &levels);

/**
 * The same from values of levels alone, where nothing is carried over: differences of neighbours d_i = |Q_{i+1} - Q_i|
 * fall by r = d_i/d_{i-1}, hence error d_i/(1 - r). So that one difference that is small by accident proves nothing,
 * none counts as smaller than a tenth of what the one before it lets expect at the ratio before. Returns estimates for
 * all levels but the last one.
 */
std::vector<double> estimates_of_sequence(const std::vector<double> &values);

/** Estimate for the level after the last estimated one: that times the larger of the last two ratios. Without two
 * estimates: that of the last one; infinite without any. */
double expected_error(const std::vector<double> &estimates);
} // namespace pellicle

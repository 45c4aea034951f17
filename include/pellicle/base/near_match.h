// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace pellicle
{
/** The candidates closest to a misspelt word (at most `most`), best first; empty when none resembles it. Case is
 * ignored. */
std::vector<std::string> near_matches(const std::string &word, const std::vector<std::string> &candidates,
                                      unsigned int most = 3);

/** " Did you mean 'a' or 'b'?" from near_matches(), or " Possible: 'a', 'b', ... ." with all candidates when none is
 * near. */
std::string suggestion(const std::string &word, const std::vector<std::string> &candidates);
} // namespace pellicle

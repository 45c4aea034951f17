// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/exceptions.h>

#include <string>

namespace pellicle
{
/** Throws UserError unless 1 <= degree <= highest. */
inline void check_body_degree(const unsigned int degree, const unsigned int highest)
{
  if (degree < 1 || degree > highest)
    throw UserError("Degree = " + std::to_string(degree) + ": the cells of such a body have a degree from 1 to " +
                    std::to_string(highest) + ".");
}
} // namespace pellicle

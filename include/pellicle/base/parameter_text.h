// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/parameters.h>

#include <string>

namespace pellicle
{
/** The present value of a bound member as a scene writes it; assign_text() of it gives exactly the same value. */
std::string value_text(const ParameterSection::Entry &entry);

/** What may be written: "a number > 0", "an integer in [2, 5]", "true or false", "'a', 'b' or 'c'", ... */
std::string allowed_text(const ParameterSection::Entry &entry);

/**
 * Gives a bound member the value that a text of a scene stands for. Throws UserError with text, reason and what is
 * allowed, and leaves the member as it was, when the text stands for no allowed value.
 */
void assign_text(const ParameterSection::Entry &entry, const std::string &text);
} // namespace pellicle

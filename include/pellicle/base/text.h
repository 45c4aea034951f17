// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace pellicle
{
/** Without white space at both ends. */
std::string trimmed(const std::string &text);

/** A text of the user's as a message shows it: at most 200 characters of it, and '?' for control characters. */
std::string excerpt(const std::string &text);

/** ASCII letters in lower case. */
std::string lower_case(std::string text);

/** The trimmed parts between the commas that stand outside parentheses; no part for an empty text. */
std::vector<std::string> comma_separated(const std::string &text);

/** The parts with a separator between them. */
std::string joined(const std::vector<std::string> &parts, const std::string &separator);

/** "'a', 'b' or 'c'" with " or " as last separator. */
std::string quoted_list(const std::vector<std::string> &parts, const std::string &last_separator);
} // namespace pellicle

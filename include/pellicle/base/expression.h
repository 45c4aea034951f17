// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace pellicle
{
/**
 * The number that a text of a scene stands for: `0.9`, `1e-3`, `inf`, `-inf`, or an expression such as `4*pi`,
 * `2*pi/3`, `sqrt(2)`
 * (+ - * / ^, parentheses, pi, and the usual functions: sqrt, exp, ln, log10, sin, cos, tan, asin, ..., abs, min, max).
 * Throws UserError, naming the text, when it is no number, when it is nan, or when an expression is not finite (1/0).
 */
double evaluate_number(const std::string &text);
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ginac/ginac.h>

#include <array>
#include <string>

namespace pellicle
{
/**
 * The expression that a text in two variables stands for, with the syntax of ExpressionOfPlace. Two functions in it are
 * our own: `magnitude`(u) = |u| and its derivative `direction`(u) = u/|u|. (GiNaC's own abs is that of complex numbers,
 * and its parser reads 2*-x-y as 2*(-x-y).) Throws UserError.
 */
GiNaC::ex read_expression(const std::string &text, const std::array<GiNaC::realsymbol, 2> &variables);
} // namespace pellicle

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/constants.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/base/expression.h>
#include <pellicle/base/text.h>

#include <muParser.h>

#include <charconv>
#include <cmath>
#include <optional>

namespace pellicle
{
namespace
{
[[noreturn]] void refuse(const std::string &text, const std::string &reason)
{
  throw UserError("'" + excerpt(text) + "' is not a number" + reason);
}

/** A plain number, which nearly every entry is: no parser is built for it. Empty when the text is something else. */
std::optional<double> plain_number(const std::string &text)
{
  const std::size_t sign   = text.size() > 1 && text[0] == '+' && text[1] != '-' ? 1 : 0;
  const char *const end    = text.data() + text.size();
  double value             = 0.;
  const auto [stop, error] = std::from_chars(text.data() + sign, end, value);
  if (stop != end || error == std::errc::invalid_argument)
    return {};
  if (error == std::errc::result_out_of_range)
    refuse(text, " that double precision can hold: its size must be 0 or between 2.3e-308 and 1.7e308");
  return value;
}

double expression(const std::string &text)
{
  try
  {
    mu::Parser parser;
    parser.DefineConst("pi", pi);
    parser.SetExpr(text);
    const double value = parser.Eval();
    if (parser.GetNumResults() != 1)
      refuse(text, " but a list: a decimal fraction is written with a point");
    return value;
  }
  catch (const mu::Parser::exception_type &error)
  {
    const std::string where = trimmed(error.GetToken()).empty()
                                  ? "it is incomplete or has misplaced signs"
                                  : "'" + excerpt(trimmed(error.GetToken())) + "' is not understood";
    refuse(text, ": " + where + ". Expressions hold numbers, + - * / ^ ( ), pi and functions such as sqrt, exp, sin");
  }
}
} // namespace

double evaluate_number(const std::string &text)
{
  const std::string number = trimmed(text);
  if (number.empty())
    throw UserError("a number is missing: the value is empty");
  if (const std::optional<double> plain = plain_number(number))
  {
    if (std::isnan(*plain))
      refuse(number, "");
    return *plain;
  }
  const double value = expression(number);
  if (!std::isfinite(value))
    refuse(number, ": the expression has no finite value");
  return value;
}
} // namespace pellicle

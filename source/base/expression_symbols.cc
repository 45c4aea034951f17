// SPDX-License-Identifier: LGPL-2.1-or-later
#include "expression_symbols.h"

#include <pellicle/base/exact_text.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/base/text.h>

#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

namespace pellicle
{
namespace
{
using GiNaC::ex;

ex derivative_of_direction(const ex & /*u*/, unsigned int /*argument*/)
{
  return 0;
}

ex direction(const ex &u)
{
  static const unsigned int serial =
      GiNaC::function::register_new(GiNaC::function_options("direction", 1).derivative_func(derivative_of_direction));
  return GiNaC::function(serial, u);
}

ex derivative_of_magnitude(const ex &u, unsigned int /*argument*/)
{
  return direction(u);
}

ex magnitude(const ex &u)
{
  static const unsigned int serial =
      GiNaC::function::register_new(GiNaC::function_options("magnitude", 1).derivative_func(derivative_of_magnitude));
  return GiNaC::function(serial, u);
}

/** The number that an expression is, if it is a real one. */
std::optional<double> real_number(const ex &u)
{
  if (GiNaC::is_a<GiNaC::numeric>(u) && u.info(GiNaC::info_flags::real))
    return GiNaC::ex_to<GiNaC::numeric>(u).to_double();
  return {};
}

using Arguments = std::vector<ex>;

struct Function
{
  std::size_t n_arguments;
  ex (*make)(const Arguments &);
};

const std::map<std::string, Function> &functions()
{
  static const std::map<std::string, Function> table = {
      {"sqrt", {1, [](const Arguments &u) -> ex { return GiNaC::sqrt(u[0]); }}},
      {"exp", {1, [](const Arguments &u) -> ex { return GiNaC::exp(u[0]); }}},
      {"ln", {1, [](const Arguments &u) -> ex { return GiNaC::log(u[0]); }}},
      {"log", {1, [](const Arguments &u) -> ex { return GiNaC::log(u[0]); }}},
      {"log10", {1, [](const Arguments &u) -> ex { return GiNaC::log(u[0]) / GiNaC::log(10); }}},
      {"log2", {1, [](const Arguments &u) -> ex { return GiNaC::log(u[0]) / GiNaC::log(2); }}},
      {"sin", {1, [](const Arguments &u) -> ex { return GiNaC::sin(u[0]); }}},
      {"cos", {1, [](const Arguments &u) -> ex { return GiNaC::cos(u[0]); }}},
      {"tan", {1, [](const Arguments &u) -> ex { return GiNaC::tan(u[0]); }}},
      {"asin", {1, [](const Arguments &u) -> ex { return GiNaC::asin(u[0]); }}},
      {"acos", {1, [](const Arguments &u) -> ex { return GiNaC::acos(u[0]); }}},
      {"atan", {1, [](const Arguments &u) -> ex { return GiNaC::atan(u[0]); }}},
      {"atan2", {2, [](const Arguments &u) -> ex { return GiNaC::atan2(u[0], u[1]); }}},
      {"sinh", {1, [](const Arguments &u) -> ex { return GiNaC::sinh(u[0]); }}},
      {"cosh", {1, [](const Arguments &u) -> ex { return GiNaC::cosh(u[0]); }}},
      {"tanh", {1, [](const Arguments &u) -> ex { return GiNaC::tanh(u[0]); }}},
      {"asinh", {1, [](const Arguments &u) -> ex { return GiNaC::asinh(u[0]); }}},
      {"acosh", {1, [](const Arguments &u) -> ex { return GiNaC::acosh(u[0]); }}},
      {"atanh", {1, [](const Arguments &u) -> ex { return GiNaC::atanh(u[0]); }}},
      {"abs", {1, [](const Arguments &u) -> ex { return magnitude(u[0]); }}}};
  return table;
}

/**
 * Recursive descent:
 *
 *     sum     = product { (+|-) product }      power   = primary [ ^ factor ]
 *     product = factor { (*|/) factor }        primary = number | name | function ( sum {, sum} ) | ( sum )
 *     factor  = (+|-) factor | power
 */
class Reader
{
public:
  Reader(const std::string &text, const std::array<GiNaC::realsymbol, 2> &variables)
      : text(text)
      , variables(variables)
  {
  }

  ex read()
  {
    if (text.size() > longest_text)
      refuse("it has " + std::to_string(text.size()) + " characters, more than the " + std::to_string(longest_text) +
             " that are read");
    const ex all = sum();
    if (next() == ',')
      refuse("',' is not understood here; a decimal fraction is written with a point");
    if (next() != '\0')
      refuse("'" + excerpt(text.substr(position)) + "' is not understood where it stands");
    return all;
  }

private:
  [[noreturn]] void refuse(const std::string &reason) const
  {
    std::vector<std::string> names;
    for (const auto &named : functions())
      names.push_back(named.first);
    const std::string x = variables[0].get_name(), y = variables[1].get_name();
    throw UserError("'" + excerpt(text) + "' is not a function of " + x + " and " + y + ": " + reason +
                    ". Expressions hold numbers, + - * / ^ ( ), pi, " + x + ", " + y + " and the functions " +
                    joined(names, ", ") + ".");
  }

  /** The next character that is no space; '\0' at the end. */
  char next()
  {
    while (position < text.size() && (text[position] == ' ' || text[position] == '\t'))
      ++position;
    return position < text.size() ? text[position] : '\0';
  }

  bool take(const char wanted)
  {
    if (next() != wanted)
      return false;
    ++position;
    return true;
  }

  ex sum()
  {
    ex result = product();
    for (;;)
      if (take('+'))
        result += product();
      else if (take('-'))
        result -= product();
      else
        return result;
  }

  ex product()
  {
    ex result = factor();
    for (;;)
      if (take('*'))
        result *= factor();
      else if (take('/'))
        result /= factor();
      else
        return result;
  }

  /** All that is nested passes here. */
  ex factor()
  {
    if (++depth > deepest)
      refuse("it is nested more than " + std::to_string(deepest) + " deep");
    const ex result = signed_power();
    --depth;
    return result;
  }

  ex signed_power()
  {
    if (take('-'))
      return -factor();
    if (take('+'))
      return factor();
    const ex base = primary();
    return take('^') ? power(base, factor()) : base;
  }

  /** Small whole exponents are exact, so that such powers are differentiated as powers. All other numbers are floating:
   * exact ones would grow without bound, as in 9^9^9. */
  ex power(const ex &base, const ex &exponent)
  {
    const std::optional<double> n = real_number(exponent), number = real_number(base);
    if (number && n)
    {
      const double value = std::pow(*number, *n);
      if (!std::isfinite(value))
        refuse("it has a power of numbers that has no finite real value");
      return GiNaC::numeric(value);
    }
    if (number && *number <= 0.)
      refuse("a power with " + exact_text(*number) + " as base and an exponent that varies has no derivatives");
    if (n && std::abs(*n) <= 1000. && *n == std::floor(*n))
      return GiNaC::pow(base, GiNaC::numeric(static_cast<long>(*n)));
    return GiNaC::pow(base, exponent);
  }

  ex primary()
  {
    const char first = next();
    if (take('('))
    {
      const ex inner = sum();
      close();
      return inner;
    }
    if (is_digit(first) || first == '.')
      return number();
    if (is_letter(first))
      return named();
    refuse(first == '\0' ? "it is incomplete"
                         : "'" + excerpt(text.substr(position)) + "' is not understood where it stands");
  }

  void close()
  {
    if (!take(')'))
      refuse("a ')' is missing" + (next() == '\0' ? "" : " before '" + excerpt(text.substr(position)) + "'"));
  }

  ex number()
  {
    double value             = 0.;
    const char *const begin  = text.data() + position;
    const auto [stop, error] = std::from_chars(begin, text.data() + text.size(), value);
    if (error != std::errc())
      refuse("'" + excerpt(text.substr(position)) + "' does not begin with a number that double precision can hold");
    position += static_cast<std::size_t>(stop - begin);
    return GiNaC::numeric(value);
  }

  ex named()
  {
    const std::size_t begin = position;
    while (position < text.size() && (is_letter(text[position]) || is_digit(text[position])))
      ++position;
    const std::string name = text.substr(begin, position - begin);
    for (const GiNaC::realsymbol &variable : variables)
      if (name == variable.get_name())
        return variable;
    if (name == "pi")
      return GiNaC::Pi;
    const auto function = functions().find(name);
    if (function != functions().end())
      return function->second.make(arguments(name, function->second.n_arguments));
    for (const char *kinked : {"min", "max", "sign", "rint", "floor", "ceil", "round"})
      if (name == kinked)
        refuse("'" + name +
               "' has no derivatives, and derivatives are needed (of such functions only abs is accepted)");
    refuse("'" + name + "' is not understood");
  }

  Arguments arguments(const std::string &name, const std::size_t n)
  {
    if (!take('('))
      refuse("'" + name + "' is a function and needs a '('");
    Arguments all{sum()};
    while (take(','))
      all.push_back(sum());
    close();
    if (all.size() != n)
      refuse("'" + name + "' has " + std::to_string(all.size()) + " arguments instead of " + std::to_string(n));
    return all;
  }

  static bool is_digit(const char c) { return c >= '0' && c <= '9'; }
  static bool is_letter(const char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

  static constexpr std::size_t longest_text = 5000;
  static constexpr unsigned int deepest     = 100;

  const std::string &text;
  const std::array<GiNaC::realsymbol, 2> &variables;
  std::size_t position = 0;
  unsigned int depth   = 0;
};
} // namespace

GiNaC::ex read_expression(const std::string &text, const std::array<GiNaC::realsymbol, 2> &variables)
{
  return Reader(text, variables).read();
}
} // namespace pellicle
